"""Meshes of the showcase: polygons by part, as tools/jacksboro/mesh.py keeps them."""

import math
import pathlib
import random

from jacksboro.mesh import Mesh as Polygons

MADE_BY = "# Made by tools/make_showcase.py. x east, y north, z up, metres."


class Mesh(Polygons):
    """Adds a few shapes, and writes millimetres, which leaves and window bars need."""

    def write(self, path: pathlib.Path, what: str) -> None:
        numbers, lines = {}, []
        for part, faces in self.faces.items():
            lines.append(f"usemtl {part}")
            for face in faces:
                keys = [" ".join(f"{value:.3f}".rstrip("0").rstrip(".") for value in corner)
                        for corner in face]
                lines.append("f " + " ".join(
                    str(numbers.setdefault(key, len(numbers) + 1)) for key in keys))
        head = [f"# {what}", MADE_BY]
        path.write_text("\n".join(head + [f"v {key}" for key in numbers] + lines) + "\n",
                        encoding="ascii")

    def rectangle(self, part: str, lo: tuple, hi: tuple, z: float) -> None:
        """Level, seen from above."""
        (x0, y0), (x1, y1) = lo, hi
        self.quad(part, (x0, y0, z), (x1, y0, z), (x1, y1, z), (x0, y1, z))

    def prism(self, part: str, outline: list, bottom: float, top: float) -> None:
        """Walls and lid over an outline that runs counter-clockwise seen from above."""
        for a, b in zip(outline, outline[1:] + outline[:1]):
            self.quad(part, (*a, bottom), (*b, bottom), (*b, top), (*a, top))
        self.add(part, [(*corner, top) for corner in outline])

    def strut(self, part: str, ends: tuple, radius: float) -> None:
        """A bar of square section between two places."""
        a, b = ends
        along = [q - p for p, q in zip(a, b)]
        length = math.sqrt(sum(v * v for v in along))
        t = [v / length for v in along]
        helper = (0.0, 0.0, 1.0) if abs(t[2]) < 0.9 else (1.0, 0.0, 0.0)
        u = _cross(t, helper)
        size = math.sqrt(sum(v * v for v in u))
        u = [v / size for v in u]
        w = _cross(t, u)
        corners = []
        for place in (a, b):
            corners.append([tuple(place[i] + radius * (p * u[i] + q * w[i]) for i in range(3))
                            for p, q in ((1, 1), (-1, 1), (-1, -1), (1, -1))])
        near, far = corners
        for i in range(4):
            j = (i + 1) % 4
            self.quad(part, near[j], near[i], far[i], far[j])
        self.add(part, [near[i] for i in range(4)])
        self.add(part, [far[i] for i in (3, 2, 1, 0)])


def _cross(a: list, b: list) -> list:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def tree(seed: int) -> Mesh:
    """A broad-leaved tree 9 m high: a trunk and a crown of single flat leaf clusters."""
    rng, mesh = random.Random(seed), Mesh()
    mesh.strut("bark", ((0, 0, 0), (0.1, 0, 4.5)), 0.22)
    for x, y in ((1.6, 0.4), (-1.2, 1.2), (-0.3, -1.7), (0.6, 1.5)):
        mesh.strut("bark", ((0, 0, 2.8), (x, y, 6.2)), 0.09)
    for _ in range(420):
        # near the surface of an ellipsoid, where a crown carries its leaves
        z, turn = rng.uniform(-1, 1), rng.uniform(0, 2 * math.pi)
        shell = rng.uniform(0.45, 1) ** 0.5
        ring = math.sqrt(1 - z * z) * shell
        centre = (3.1 * ring * math.cos(turn), 3.1 * ring * math.sin(turn), 6.0 + 3.0 * z * shell)
        mesh.add("leaves", _leaf(rng, centre, rng.uniform(0.3, 0.5)))
    return mesh


def _leaf(rng: random.Random, centre: tuple, half: float) -> list:
    """A square in a random plane, more often level than upright."""
    tilt, turn, spin = math.acos(rng.uniform(0.25, 1)), rng.uniform(0, 6.283), rng.uniform(0, 6.283)
    u = (math.cos(turn) * math.cos(tilt), math.sin(turn) * math.cos(tilt), -math.sin(tilt))
    v = (-math.sin(turn), math.cos(turn), 0.0)
    corners = []
    for k in range(4):
        p, q = half * math.cos(spin + k * math.pi / 2), half * math.sin(spin + k * math.pi / 2)
        corners.append(tuple(c + p * a + q * b for c, a, b in zip(centre, u, v)))
    return corners


def car() -> Mesh:
    """A saloon car 4.4 m long, front towards +y."""
    mesh = Mesh()
    mesh.box("paint", (-0.88, -2.2, 0.3), (0.88, 0.95, 0.95))
    hood = [(-0.88, 0.95), (0.88, 0.95), (0.8, 2.2), (-0.8, 2.2)]
    mesh.prism("hood", [hood[i] for i in (0, 1, 2, 3)], 0.3, 0.88)
    lo, hi = (0.85, -1.9, 0.9), (0.66, -1.3, 0.35)
    base, top = ([(-x, y0, z), (x, y0, z), (x, y1, z), (-x, y1, z)]
                 for (x, y0, y1), z in ((lo, 0.95), (hi, 1.42)))
    for i in range(4):
        j = (i + 1) % 4
        mesh.quad("windows", base[i], base[j], top[j], top[i])
    mesh.add("paint", top)
    for x in (-0.9, 0.72):
        for y in (-1.45, 1.2):
            mesh.box("tyres", (x, y - 0.32, 0.0), (x + 0.18, y + 0.32, 0.62))
    return mesh
