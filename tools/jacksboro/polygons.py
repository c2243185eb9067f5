"""Plane polygons as lists of (x, y), counter-clockwise: areas, clipping, cutting into triangles."""

import math


def area(points: list) -> float:
    """Signed, positive when counter-clockwise."""
    edges = zip(points, points[1:] + points[:1])
    return 0.5 * sum(ax * by - bx * ay for (ax, ay), (bx, by) in edges)


def contains(points: list, x: float, y: float) -> bool:
    """Whether a point lies inside, by the parity of crossings."""
    inside = False
    for (ax, ay), (bx, by) in zip(points, points[1:] + points[:1]):
        if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
            inside = not inside
    return inside


def distance(line: list, x: float, y: float) -> float:
    """From a point to an open line of points."""
    return min(_to_segment(a, b, x, y) for a, b in zip(line, line[1:]))


def edge_distance(points: list, x: float, y: float) -> float:
    """From a point to the outline of a polygon."""
    return distance(points + points[:1], x, y)


def _to_segment(a: tuple, b: tuple, x: float, y: float) -> float:
    dx, dy = b[0] - a[0], b[1] - a[1]
    t = ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy)
    t = min(1.0, max(0.0, t))
    return math.hypot(x - a[0] - t * dx, y - a[1] - t * dy)


def clip(subject: list, convex: list) -> list:
    """The part of `subject` within `convex` (Sutherland and Hodgman, CACM 17(1), 1974).

    A concave subject may come back with edges that run there and back; they have no area.
    """
    piece = subject
    for a, b in zip(convex, convex[1:] + convex[:1]):
        side = [(b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) for x, y in piece]
        result = []
        for i, point in enumerate(piece):
            before, s, t = piece[i - 1], side[i - 1], side[i]
            if (s < 0.0) != (t < 0.0):
                k = s / (s - t)
                result.append((before[0] + k * (point[0] - before[0]),
                               before[1] + k * (point[1] - before[1])))
            if t >= 0.0:
                result.append(point)
        piece = result
        if len(piece) < 3:
            return []
    return _without_repeats(piece)


def _without_repeats(points: list) -> list:
    kept = [p for i, p in enumerate(points)
            if math.hypot(p[0] - points[i - 1][0], p[1] - points[i - 1][1]) > 0.005]
    return kept if len(kept) >= 3 else []


def triangulate(points: list) -> list:
    """Triangles that fill a simple polygon, by cutting ears; slivers below 1 cm^2 are left out."""
    rest, triangles = list(points), []
    while len(rest) >= 3:
        ear = _find_ear(rest)
        triangle = [rest[ear - 1], rest[ear], rest[(ear + 1) % len(rest)]]
        if area(triangle) > 1e-4:
            triangles.append(triangle)
        del rest[ear]
    return triangles


def _find_ear(points: list) -> int:
    for i, tip in enumerate(points):
        corner = [points[i - 1], tip, points[(i + 1) % len(points)]]
        if area(corner) > 1e-6 and not any(
                _strictly_inside(corner, p) for p in points if p not in corner):
            return i
    return 0  # only slivers are left


def _strictly_inside(triangle: list, p: tuple) -> bool:
    return all(area([a, b, p]) > 1e-9 for a, b in zip(triangle, triangle[1:] + triangle[:1]))


def ribbon(line: list, width: float) -> list:
    """Quadrilaterals of a strip along a line, mitred where it bends."""
    sides = []
    for i, (x, y) in enumerate(line):
        a, b = line[max(0, i - 1)], line[min(len(line) - 1, i + 1)]
        dx, dy = b[0] - a[0], b[1] - a[1]
        length = math.hypot(dx, dy)
        nx, ny = -dy / length * width / 2, dx / length * width / 2
        sides.append(((x - nx, y - ny), (x + nx, y + ny)))
    return [[r0, r1, l1, l0] for (r0, l0), (r1, l1) in zip(sides, sides[1:])]


def smooth_line(knots: list, spacing: float) -> list:
    """Points about `spacing` apart on a Catmull-Rom curve through the knots."""
    padded = [_beyond(knots[1], knots[0])] + knots + [_beyond(knots[-2], knots[-1])]
    line = []
    for p0, p1, p2, p3 in zip(padded, padded[1:], padded[2:], padded[3:]):
        count = max(1, round(math.dist(p1, p2) / spacing))
        line += [tuple(_catmull_rom(a, b, c, d, k / count) for a, b, c, d in zip(p0, p1, p2, p3))
                 for k in range(count)]
    return line + [knots[-1]]


def _beyond(a: tuple, b: tuple) -> tuple:
    return 2 * b[0] - a[0], 2 * b[1] - a[1]


def _catmull_rom(a: float, b: float, c: float, d: float, t: float) -> float:
    return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)))
