"""Houses, barn, church and sheds from a few measures each.

The origin is at ground level in the middle of the plan; the front looks along +y, so that an
instance's yaw is the azimuth that the front faces. Foundations go 2.5 m into the ground: within
11 m of a house the village's ground falls by 2.3 m at most, so that no corner hangs in the air.
"""

import math

from jacksboro.mesh import Mesh

FOUNDATION_M = 2.5
ROOF_M = 0.25       # thickness of a roof, with its battens
PROUD_M = 0.04      # windows and doors stand that far in front of the wall


def _walls(mesh: Mesh, lo: tuple, hi: tuple, eaves: float) -> None:
    """Foundation up to 0.4 m, then walls up to the eaves; (lo, hi) are corners of the plan."""
    (x0, y0), (x1, y1) = lo, hi
    mesh.box("foundation", (x0, y0, -FOUNDATION_M), (x1, y1, 0.4), bottom=False)
    inset = 0.03  # so that walls and foundation do not share a plane
    mesh.box("walls", (x0 + inset, y0 + inset, 0.35), (x1 - inset, y1 - inset, eaves), bottom=False)


def _slab(mesh: Mesh, part: str, top: list) -> None:
    """A sloping plate: its upper side `top`, the same below, and the rim."""
    bottom = [(x, y, z - ROOF_M) for x, y, z in top]
    mesh.add(part, top)
    mesh.add(part, bottom[::-1])
    for i in range(len(top)):
        mesh.quad(part, bottom[i - 1], bottom[i], top[i], top[i - 1])


def _gable_roof(mesh: Mesh, part: str, lo: tuple, hi: tuple, eaves: float, rise: float,
                over: float = 0.5, walls: str = "walls") -> None:
    """Ridge along x; `rise` from eaves to ridge; the gables' triangles belong to `walls`."""
    (x0, y0), (x1, y1) = lo, hi
    middle, half = (y0 + y1) / 2, (y1 - y0) / 2
    pitch = rise / half
    out = eaves - over * pitch + ROOF_M
    ridge = eaves + rise + ROOF_M
    _slab(mesh, part, [(x0 - over, y0 - over, out), (x1 + over, y0 - over, out),
                       (x1 + over, middle, ridge), (x0 - over, middle, ridge)])
    _slab(mesh, part, [(x1 + over, y1 + over, out), (x0 - over, y1 + over, out),
                       (x0 - over, middle, ridge), (x1 + over, middle, ridge)])
    inset = 0.03
    for x, first, second in ((x1 - inset, y0, y1), (x0 + inset, y1, y0)):
        mesh.add(walls, [(x, first, eaves), (x, second, eaves), (x, middle, eaves + rise)])


def _hip_roof(mesh: Mesh, part: str, lo: tuple, hi: tuple, eaves: float, rise: float,
              over: float = 0.6) -> None:
    """Four slopes of one pitch; the ridge runs along x, the longer side."""
    (x0, y0), (x1, y1) = lo, hi
    middle, half = (y0 + y1) / 2, (y1 - y0) / 2
    out, top = eaves - over * rise / half + ROOF_M, eaves + rise + ROOF_M
    a, b = (x0 - over, y0 - over, out), (x1 + over, y0 - over, out)
    c, d = (x1 + over, y1 + over, out), (x0 - over, y1 + over, out)
    e, f = (x0 + half, middle, top), (x1 - half, middle, top)
    for face in ([a, b, f, e], [b, c, f], [c, d, e, f], [d, a, e]):
        mesh.add(part, face)
    mesh.quad(part, d, c, b, a)  # the soffit


def _panel(mesh: Mesh, part: str, side: str, wall: float, along: float, z: float, width: float,
           height: float) -> None:
    """An upright rectangle on the wall at `wall` of the side front, back, left or right."""
    u0, u1, z1 = along - width / 2, along + width / 2, z + height
    w = wall + (PROUD_M if side in ("front", "right") else -PROUD_M)
    if side == "front":
        mesh.quad(part, (u1, w, z), (u0, w, z), (u0, w, z1), (u1, w, z1))
    elif side == "back":
        mesh.quad(part, (u0, w, z), (u1, w, z), (u1, w, z1), (u0, w, z1))
    elif side == "right":
        mesh.quad(part, (w, u0, z), (w, u1, z), (w, u1, z1), (w, u0, z1))
    else:
        mesh.quad(part, (w, u1, z), (w, u0, z), (w, u0, z1), (w, u1, z1))


def _windows(mesh: Mesh, lo: tuple, hi: tuple, floors: list, across: int, deep: int) -> None:
    """Windows at equal distances; the middle of the front's ground floor is kept for the door."""
    (x0, y0), (x1, y1) = lo, hi
    for level, z in enumerate(floors):
        for i in range(across):
            x = x0 + (i + 0.5) * (x1 - x0) / across
            if level > 0 or abs(x - (x0 + x1) / 2) > 1.2:
                _panel(mesh, "windows", "front", y1, x, z, 1.3, 1.4)
            _panel(mesh, "windows", "back", y0, x, z, 1.3, 1.4)
        for i in range(deep):
            y = y0 + (i + 0.5) * (y1 - y0) / deep
            _panel(mesh, "windows", "right", x1, y, z, 1.2, 1.4)
            _panel(mesh, "windows", "left", x0, y, z, 1.2, 1.4)


def _chimney(mesh: Mesh, x: float, y: float, base: float, top: float) -> None:
    mesh.box("chimney", (x - 0.45, y - 0.45, base), (x + 0.45, y + 0.45, top), bottom=False)


def _porch(mesh: Mesh, x0: float, x1: float, wall: float, depth: float, roof_z: float) -> None:
    """A platform, four posts and a lean-to roof in front of the door."""
    mesh.box("porch", (x0, wall, -FOUNDATION_M), (x1, wall + depth, 0.4), bottom=False)
    for x in (x0 + 0.15, x1 - 0.15):
        mesh.box("porch", (x - 0.1, wall + depth - 0.3, 0.4), (x + 0.1, wall + depth - 0.1, roof_z))
    _slab(mesh, "roof", [(x1 + 0.3, wall + depth + 0.3, roof_z + ROOF_M - 0.3),
                         (x0 - 0.3, wall + depth + 0.3, roof_z + ROOF_M - 0.3),
                         (x0 - 0.3, wall, roof_z + ROOF_M + 0.4),
                         (x1 + 0.3, wall, roof_z + ROOF_M + 0.4)])


def cottage() -> Mesh:
    """One storey, 11 x 8 m, gable roof, porch."""
    mesh, lo, hi = Mesh(), (-5.5, -4.0), (5.5, 4.0)
    _walls(mesh, lo, hi, 3.1)
    _gable_roof(mesh, "roof", lo, hi, 3.1, 2.7)
    _windows(mesh, lo, hi, [1.2], 4, 2)
    _panel(mesh, "door", "front", 4.0, 0.0, 0.4, 1.1, 2.1)
    _porch(mesh, -2.0, 2.0, 4.0, 2.2, 2.6)
    _chimney(mesh, 3.2, -1.2, 4.0, 7.0)
    return mesh


def farmhouse() -> Mesh:
    """Two storeys, 12 x 9 m, steep gable roof, a lower wing behind, two chimneys."""
    mesh, lo, hi = Mesh(), (-6.0, -4.5), (6.0, 4.5)
    _walls(mesh, lo, hi, 5.9)
    _gable_roof(mesh, "roof", lo, hi, 5.9, 3.6, over=0.6)
    _windows(mesh, lo, hi, [1.2, 4.0], 4, 2)
    _panel(mesh, "door", "front", 4.5, 0.0, 0.4, 1.2, 2.2)
    _porch(mesh, -4.5, 4.5, 4.5, 2.4, 2.8)
    wing_lo, wing_hi = (-1.0, -10.0), (5.0, -4.5)
    _walls(mesh, wing_lo, wing_hi, 3.0)
    _hip_roof(mesh, "roof", (-1.0, -10.0), (5.0, -4.2), 3.0, 1.6, over=0.3)
    _chimney(mesh, -5.0, 0.0, 7.5, 11.0)
    _chimney(mesh, 4.4, 0.0, 7.5, 11.0)
    return mesh


def ranch() -> Mesh:
    """One long storey, 17 x 9 m, hip roof, with a garage wing to the front."""
    mesh, lo, hi = Mesh(), (-8.5, -4.5), (8.5, 4.5)
    _walls(mesh, lo, hi, 2.9)
    _hip_roof(mesh, "roof", lo, hi, 2.9, 2.5)
    _windows(mesh, lo, hi, [1.1], 5, 2)
    _panel(mesh, "door", "front", 4.5, 0.0, 0.4, 1.1, 2.1)
    _walls(mesh, (2.5, 4.4), (8.5, 10.0), 2.7)
    _hip_roof(mesh, "roof", (2.5, 3.9), (8.5, 10.0), 2.7, 1.8, over=0.4)
    _panel(mesh, "door", "front", 10.0, 5.5, 0.1, 4.6, 2.3)
    _chimney(mesh, -4.0, -1.0, 3.8, 6.6)
    return mesh


def shed() -> Mesh:
    """A garden shed, 5 x 4 m."""
    mesh, lo, hi = Mesh(), (-2.5, -2.0), (2.5, 2.0)
    _walls(mesh, lo, hi, 2.2)
    _gable_roof(mesh, "roof", lo, hi, 2.2, 1.1, over=0.25)
    _panel(mesh, "door", "front", 2.0, 0.0, 0.4, 1.4, 1.7)
    return mesh


def church() -> Mesh:
    """A nave of 20 x 10 m along y, a tower with a spire in front."""
    mesh = Mesh()
    nave = Mesh()  # built along x, then turned by a quarter
    lo, hi = (-10.0, -5.0), (10.0, 5.0)
    _walls(nave, lo, hi, 6.0)
    _gable_roof(nave, "roof", lo, hi, 6.0, 5.2, over=0.5)
    for i in range(5):
        for side, wall in (("front", 5.0), ("back", -5.0)):
            _panel(nave, "windows", side, wall, -8.0 + 4.0 * i, 1.8, 1.1, 3.2)
    for part, faces in nave.faces.items():
        for face in faces:
            mesh.add(part, [(-y, x, z) for x, y, z in face])
    _walls(mesh, (-2.2, 9.0), (2.2, 13.4), 15.0)
    _panel(mesh, "door", "front", 13.4, 0.0, 0.4, 1.8, 2.8)
    _panel(mesh, "windows", "front", 13.4, 0.0, 10.5, 1.2, 2.4)
    tip, half = (0.0, 11.2, 26.0), 2.6
    base = [(-half, 11.2 - half, 15.0), (half, 11.2 - half, 15.0), (half, 11.2 + half, 15.0),
            (-half, 11.2 + half, 15.0)]
    for i in range(4):
        mesh.add("spire", [base[i - 1], base[i], tip])
    mesh.add("spire", base[::-1])
    return mesh


def barn() -> Mesh:
    """A gambrel-roofed barn of 26 x 14 m with big doors, and a silo beside it."""
    mesh, lo, hi = Mesh(), (-13.0, -7.0), (13.0, 7.0)
    _walls(mesh, lo, hi, 4.5)
    for s in (1.0, -1.0):
        lower = [(13.5 * s, 7.5 * s, 4.1), (-13.5 * s, 7.5 * s, 4.1),
                 (-13.5 * s, 4.4 * s, 8.6), (13.5 * s, 4.4 * s, 8.6)]
        upper = [(13.5 * s, 4.4 * s, 8.6), (-13.5 * s, 4.4 * s, 8.6),
                 (-13.5 * s, 0.0, 11.0), (13.5 * s, 0.0, 11.0)]
        _slab(mesh, "roof", lower)
        _slab(mesh, "roof", upper)
        gable = [(12.97 * s, -7.0 * s, 4.4), (12.97 * s, 7.0 * s, 4.4), (12.97 * s, 4.3 * s, 8.4),
                 (12.97 * s, 0.0, 10.8), (12.97 * s, -4.3 * s, 8.4)]
        mesh.add("walls", gable)
    for side, wall in (("right", 13.0), ("left", -13.0)):
        _panel(mesh, "door", side, wall, 0.0, 0.4, 5.0, 4.4)
        _panel(mesh, "windows", side, wall, 0.0, 6.6, 1.6, 1.6)
    _panel(mesh, "door", "front", 7.0, 0.0, 0.4, 4.6, 3.4)
    _silo(mesh, (18.0, -2.5), 2.8, 13.0)
    return mesh


def _silo(mesh: Mesh, centre: tuple, radius: float, height: float, sides: int = 20) -> None:
    ring = [(centre[0] + radius * math.cos(math.tau * i / sides),
             centre[1] + radius * math.sin(math.tau * i / sides)) for i in range(sides)]
    levels = [(1.0, height), (0.8, height + 1.3), (0.45, height + 2.2), (0.0, height + 2.5)]
    for a, b in zip(ring, ring[1:] + ring[:1]):
        mesh.quad("silo", (*a, -FOUNDATION_M), (*b, -FOUNDATION_M), (*b, height), (*a, height))
        for (k0, z0), (k1, z1) in zip(levels, levels[1:]):
            corners = [_towards(centre, a, k0, z0), _towards(centre, b, k0, z0),
                       _towards(centre, b, k1, z1), _towards(centre, a, k1, z1)]
            mesh.add("silo_roof", corners if k1 > 0.0 else corners[:3])


def _towards(centre: tuple, rim: tuple, share: float, z: float) -> tuple:
    return (centre[0] + share * (rim[0] - centre[0]), centre[1] + share * (rim[1] - centre[1]), z)
