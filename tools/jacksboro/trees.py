"""Tree prototypes: crowns of lumps or of drooping whorls, on tapering trunks.

Parts `leaves` and `bark`; a grove has `leaves`, `bright` and `needles`. Heights in m at scale 1;
trunks go 1 m into the ground.
"""

import math
import random

from jacksboro.mesh import Mesh


def _trunk(mesh: Mesh, height: float, radius: float, sides: int = 6) -> None:
    low = [(1.3 * radius * math.cos(math.tau * i / sides),
            1.3 * radius * math.sin(math.tau * i / sides), -1.0) for i in range(sides)]
    high = [(0.4 * radius * math.cos(math.tau * i / sides),
             0.4 * radius * math.sin(math.tau * i / sides), height) for i in range(sides)]
    for i in range(sides):
        mesh.quad("bark", low[i - 1], low[i], high[i], high[i - 1])


def _icosahedron() -> tuple:
    g = (1.0 + math.sqrt(5.0)) / 2.0
    points = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
              (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
             (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
             (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    return [_unit(p) for p in points], faces


def _unit(p: tuple) -> tuple:
    length = math.sqrt(sum(v * v for v in p))
    return tuple(v / length for v in p)


def _ball() -> tuple:
    """An icosahedron cut once: 42 points, 80 faces, all on the unit sphere."""
    points, faces = _icosahedron()
    middles, cut = {}, []

    def middle(a: int, b: int) -> int:
        key = (min(a, b), max(a, b))
        if key not in middles:
            points.append(_unit(tuple(x + y for x, y in zip(points[a], points[b]))))
            middles[key] = len(points) - 1
        return middles[key]

    for a, b, c in faces:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        cut += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
    return points, cut


def _lump(mesh: Mesh, rng: random.Random, centre: tuple, radii: tuple, rough: float,
          part: str = "leaves") -> None:
    """A ball of leaves, each corner pushed in or out by up to `rough` of its radius."""
    points, faces = _ball()
    moved = []
    for p in points:
        push = 1.0 + rng.uniform(-rough, rough)
        moved.append(tuple(c + push * r * v for c, r, v in zip(centre, radii, p)))
    for face in faces:
        mesh.add(part, [moved[i] for i in face])


def broadleaf(seed: int, height: float, spread: float, crown_base: float, lumps: int) -> Mesh:
    """A crown of lumps around an ellipsoid between `crown_base` and `height`."""
    rng, mesh = random.Random(seed), Mesh()
    _trunk(mesh, 0.75 * height, 0.022 * height)
    middle, half = (height + crown_base) / 2, (height - crown_base) / 2
    _lump(mesh, rng, (0.0, 0.0, middle), (0.62 * spread, 0.62 * spread, 0.8 * half), 0.15)
    for i in range(lumps):
        # a spiral of equal areas over the sphere, without its lowest part
        z = 1.0 - 1.7 * (i + 0.5) / lumps
        turn = math.tau * 0.618034 * i + rng.uniform(-0.3, 0.3)
        out = math.sqrt(1.0 - z * z)
        size = rng.uniform(0.36, 0.5) * spread
        reach = spread - 0.75 * size
        _lump(mesh, rng, (reach * out * math.cos(turn), reach * out * math.sin(turn),
                          middle + (half - 0.55 * size) * z),
              (size, size, 0.8 * size), 0.2)
    return mesh


def conifer(seed: int, height: float, spread: float, crown_base: float, whorls: int,
            sides: int = 11) -> Mesh:
    """Drooping whorls of branches, each a star-shaped skirt narrower than the one below."""
    rng, mesh = random.Random(seed), Mesh()
    _trunk(mesh, 0.96 * height, 0.016 * height)
    step = (height - crown_base) / whorls
    for i in range(whorls):
        share = 1.0 - i / whorls
        reach = spread * share**0.85 + 0.15
        top = crown_base + (i + 1) * step + 0.55 * step
        rim_z = crown_base + i * step
        _skirt(mesh, rng, min(top, height), rim_z, reach, sides)
    return mesh


def _skirt(mesh: Mesh, rng: random.Random, top: float, rim_z: float, reach: float,
           sides: int) -> None:
    """Branch tips reach out and droop, the notches between them stay behind."""
    turn, rim = rng.uniform(0.0, math.tau), []
    for k in range(2 * sides):
        tip = k % 2 == 0
        out = reach * (rng.uniform(0.85, 1.12) if tip else rng.uniform(0.55, 0.7))
        angle = turn + math.pi * k / sides
        rim.append((out * math.cos(angle), out * math.sin(angle),
                    rim_z + (-0.08 if tip else 0.12) * reach))
    under = (0.0, 0.0, rim_z + 0.25 * (top - rim_z))
    for a, b in zip(rim, rim[1:] + rim[:1]):
        mesh.add("leaves", [a, b, (0.0, 0.0, top)])
        mesh.add("leaves", [b, a, under])


def grove(seed: int, trees: int, radius: float) -> Mesh:
    """Crowns side by side for woods far away; they reach down far enough for steep slopes."""
    rng, mesh = random.Random(seed), Mesh()
    for i in range(trees):
        # a spiral of equal areas over a disc
        out, turn = radius * math.sqrt((i + 0.5) / trees), math.tau * 0.618034 * i
        x, y = out * math.cos(turn), out * math.sin(turn)
        height, spread = rng.uniform(15.0, 23.0), rng.uniform(4.2, 5.6)
        part = ("leaves", "needles", "bright")[(0, 2, 0, 1)[i % 4]]
        _lump(mesh, rng, (x, y, 0.4 * height - 3.0), (spread, spread, 0.5 * height), 0.12, part)
        lean = rng.uniform(0.0, math.tau)
        _lump(mesh, rng, (x + 1.6 * math.cos(lean), y + 1.6 * math.sin(lean), 0.72 * height),
              (0.7 * spread, 0.7 * spread, 0.28 * height), 0.2, part)
    return mesh


PROTOTYPES = {
    "oak": lambda: broadleaf(11, height=17.0, spread=6.2, crown_base=3.2, lumps=9),
    "poplar": lambda: broadleaf(12, height=25.0, spread=5.2, crown_base=6.5, lumps=11),
    "maple": lambda: broadleaf(13, height=14.0, spread=4.6, crown_base=2.6, lumps=7),
    "hemlock": lambda: conifer(14, height=21.0, spread=4.3, crown_base=1.8, whorls=9),
    "pine": lambda: conifer(15, height=24.0, spread=3.7, crown_base=9.0, whorls=6),
    "grove": lambda: grove(17, trees=8, radius=12.0),
    "shrub": lambda: broadleaf(16, height=3.4, spread=1.8, crown_base=0.2, lumps=3),
}
