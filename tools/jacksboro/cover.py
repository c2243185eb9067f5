"""What lies on the ground: meadow, fields, lawns, roads, drives, the pond with its banks.

Layers are lifted by a few centimetres each, in the order in which they cover one another.
"""

import math

from jacksboro import layout, polygons
from jacksboro.ground import Ground
from jacksboro.mesh import Mesh

LIFT_M = {"meadow": 0.05, "dry": 0.08, "lush": 0.10, "tilled": 0.12, "stubble": 0.12, "crop": 0.25,
          "lawn": 0.19, "drive": 0.26, "concrete": 0.26, "lane": 0.31, "road": 0.35}
STRIP_M = 14.0  # width of a strip in a field of two crops


def make_cover(ground: Ground, plan: layout.Plan) -> Mesh:
    mesh = Mesh()
    for outline in [plan.valley] + layout.CLEARINGS:
        _drape(ground, mesh, "meadow", outline)
    for number, patch in enumerate(layout.meadow_patches(plan)):
        _drape(ground, mesh, ("dry", "lush")[number % 2], patch)
    for part, second, azimuth, outline in layout.FIELDS:
        if second is None:
            _drape(ground, mesh, part, outline)
        else:
            for k, strip in enumerate(_strips(outline, azimuth)):
                _drape(ground, mesh, (part, second)[k % 2], strip)
    for house in plan.houses:
        _garden(ground, mesh, house)
    east, north, yaw = layout.BARN
    _drape(ground, mesh, "concrete", _rectangle((east, north), yaw, (-22, 24), (-11, 30)))
    east, north, yaw = layout.CHURCH
    _drape(ground, mesh, "concrete", _rectangle((east, north), yaw, (-9, 9), (12, 27)))
    for number, (line, width) in enumerate(plan.roads):
        part = "road" if number < 2 else "lane"
        for quad in polygons.ribbon(line, width):
            _drape(ground, mesh, part, quad)
    return mesh


def _drape(ground: Ground, mesh: Mesh, part: str, outline: list) -> None:
    outline = [(float(x), float(y)) for x, y in outline]
    if polygons.area(outline) < 0.0:
        outline.reverse()
    ground.drape(mesh, part, outline, LIFT_M[part])


def _rectangle(centre: tuple, yaw_deg: float, across: tuple, along: tuple) -> list:
    """A rectangle in the axes of something that stands at `centre` and faces `yaw_deg`."""
    s, c = math.sin(math.radians(yaw_deg)), math.cos(math.radians(yaw_deg))
    corners = [(across[0], along[0]), (across[1], along[0]), (across[1], along[1]),
               (across[0], along[1])]
    return [(centre[0] + u * c + v * s, centre[1] - u * s + v * c) for u, v in corners]


def _strips(outline: list, azimuth_deg: float) -> list:
    """Cuts a field into strips that run along an azimuth."""
    s, c = math.sin(math.radians(azimuth_deg)), math.cos(math.radians(azimuth_deg))
    offsets = [x * c - y * s for x, y in outline]
    middle = (sum(p[0] for p in outline) / len(outline), sum(p[1] for p in outline) / len(outline))
    offset = middle[0] * c - middle[1] * s
    strips = []
    first, last = math.floor(min(offsets) / STRIP_M), math.ceil(max(offsets) / STRIP_M)
    for k in range(first, last):
        u0, u1 = k * STRIP_M - offset, (k + 1) * STRIP_M - offset
        band = _rectangle(middle, azimuth_deg, (u0, u1), (-500.0, 500.0))
        strip = polygons.clip([(float(x), float(y)) for x, y in outline], band)
        if strip:
            strips.append(strip)
    return strips


def _garden(ground: Ground, mesh: Mesh, house: layout.House) -> None:
    """A lawn around the house and a drive from the road to its front."""
    dx, dy = house.gate[0] - house.east, house.gate[1] - house.north
    distance = math.hypot(dx, dy)
    half = house.reach + 1.5
    _drape(ground, mesh, "lawn",
           _rectangle((house.east, house.north), house.yaw_deg, (-half, half),
                      (-half - 4.0, distance - 4.5)))
    yaw = math.degrees(math.atan2(dx, dy))
    aside = 5.5 if house.style.startswith("ranch") else 3.5
    _drape(ground, mesh, "drive",
           _rectangle((house.east, house.north), yaw,
                      (aside - layout.DRIVE_WIDTH_M / 2, aside + layout.DRIVE_WIDTH_M / 2),
                      (4.0, distance - 2.0)))


def make_pond(ground: Ground, plan: layout.Plan) -> tuple:
    """Level water, a shore that dips below it, and banks down to the ground; and the level.

    The level is 0.3 m above the highest ground within the shore, so that nothing pokes through;
    where the ground falls away, the bank is the dam of a farm pond.
    """
    rings = {grow: _grown(plan.pond, grow) for grow in (-1.5, 0.0, 3.0, 5.0, 13.0)}
    inner = [p for k in range(11) for p in _grown(plan.pond, -4.0 * k)] + rings[5.0]
    level = max(ground.height(x, y) for x, y in inner) + 0.3
    mesh = Mesh()
    water = [(x, y, level) for x, y in plan.pond]
    centre = (*layout.POND, level)
    for a, b in zip(water, water[1:] + water[:1]):
        mesh.add("water", [centre, a, b])
    heights = {-1.5: lambda x, y: level - 0.35, 3.0: lambda x, y: level + 0.45,
               5.0: lambda x, y: level + 0.45, 13.0: lambda x, y: ground.height(x, y) - 0.3}
    for part, (low, high) in (("shore", (-1.5, 3.0)), ("bank", (3.0, 5.0)), ("bank", (5.0, 13.0))):
        inner = [(x, y, heights[low](x, y)) for x, y in rings[low]]
        outer = [(x, y, heights[high](x, y)) for x, y in rings[high]]
        for i in range(len(inner)):
            mesh.quad(part, inner[i - 1], outer[i - 1], outer[i], inner[i])
    return mesh, level


def _grown(outline: list, by: float) -> list:
    """Moves every point of a rounded outline away from its middle."""
    cx, cy = layout.POND
    moved = []
    for x, y in outline:
        r = math.hypot(x - cx, y - cy)
        k = max(0.0, r + by) / r
        moved.append((cx + k * (x - cx), cy + k * (y - cy)))
    return moved
