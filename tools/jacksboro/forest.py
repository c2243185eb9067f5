"""Where trees grow: woods around the valley, hedges and garden trees within it."""

import math
import random

from jacksboro import layout, polygons
from jacksboro.ground import Ground

# The woods are planted all around the village and where the shipped scenarios' camera (see day.xml)
# looks; elsewhere and beyond lies the terrain's own forest canopy. Groves stand for several trees
# where one is smaller than a pixel or two; they are planted only where that camera sees the ground.
CAMERA = (690.0, -930.0, 370.0)
VIEW_AZIMUTH_DEG, VIEW_HALF_WIDTH_DEG = 323.0, 27.0
AROUND_M, NEAR_M, FAR_M = 950.0, 2400.0, 6600.0
GROVE_SPACING_M = 21.0
SHARES = [("oak", 0.34), ("poplar", 0.26), ("maple", 0.18), ("hemlock", 0.12), ("pine", 0.10)]


class Planter:
    """Trees so far, and whether there is room for another."""

    CELL_M = 12.0

    def __init__(self, ground: Ground, plan: layout.Plan, seed: int):
        self.ground, self.plan, self.rng = ground, plan, random.Random(seed)
        self.trees, self._cells = [], {}  # (kind, east, north, yaw, scale)

    def near(self, x: float, y: float, distance: float) -> bool:
        """Whether a trunk stands closer than that."""
        i, j, reach = int(x // self.CELL_M), int(y // self.CELL_M), int(distance // self.CELL_M) + 1
        for a in range(i - reach, i + reach + 1):
            for b in range(j - reach, j + reach + 1):
                if any(math.hypot(x - u, y - v) < distance for u, v in self._cells.get((a, b), ())):
                    return True
        return False

    def plant(self, kind: str, x: float, y: float, scale: float) -> None:
        self._cells.setdefault((int(x // self.CELL_M), int(y // self.CELL_M)), []).append((x, y))
        self.trees.append((kind, x, y, self.rng.uniform(0.0, 360.0), scale))

    def free(self, x: float, y: float, crown: float) -> bool:
        """Whether a crown of that radius stands on nothing built or tilled."""
        plan = self.plan
        if math.hypot(x, y) > 1600.0:
            return True
        return (plan.clear_of_roads(x, y, crown) and plan.clear_of_pond(x, y, crown + 1.0)
                and plan.clear_of_buildings(x, y, crown - 1.0)
                and plan.clear_of_fields(x, y, 0.3 * crown))


def _wood_kind(rng: random.Random, ridge: float) -> str:
    """More pines on dry crests, more poplars in hollows; `ridge` in [0, 1] is how high it lies."""
    weights = [share * (1.0 + 2.0 * ridge if kind == "pine" else
                        1.4 - 0.9 * ridge if kind == "poplar" else 1.0) for kind, share in SHARES]
    return rng.choices([kind for kind, _ in SHARES], weights)[0]


def plant_woods(planter: Planter) -> None:
    """Darts thrown at the ground: first groves far off, then trees in view, then around."""
    rng, sight = planter.rng, _Sight(planter.ground)
    for _ in range(90000):
        _throw_grove(planter, sight, *_in_view(rng, NEAR_M - 60.0, FAR_M))
    for _ in range(130000):
        _throw(planter, *_in_view(rng, 0.0, NEAR_M))
    for _ in range(60000):
        radius, angle = AROUND_M * math.sqrt(rng.random()), rng.uniform(0.0, math.tau)
        _throw(planter, radius * math.cos(angle), radius * math.sin(angle))


def _in_view(rng: random.Random, nearest: float, farthest: float) -> tuple:
    """A point in the view, evenly over its area."""
    angle = math.radians(VIEW_AZIMUTH_DEG + VIEW_HALF_WIDTH_DEG * rng.uniform(-1.0, 1.0))
    distance = math.sqrt(rng.uniform(nearest**2, farthest**2))
    return CAMERA[0] + distance * math.sin(angle), CAMERA[1] + distance * math.cos(angle)


class _Sight:
    """What the camera sees: along each of a fan of azimuths the highest line of sight so far."""

    STEP_M, FAN_DEG, CROWN_M = 25.0, 0.25, 25.0

    def __init__(self, ground: Ground):
        self.ground, self._fan = ground, {}

    def sees(self, x: float, y: float) -> bool:
        """Whether crowns at a place show above what lies in front of them."""
        dx, dy = x - CAMERA[0], y - CAMERA[1]
        line = self._line(round(math.degrees(math.atan2(dx, dy)) / self.FAN_DEG))
        step = int(math.hypot(dx, dy) / self.STEP_M)
        if step + 1 >= len(line):
            return False
        top = self.ground.height(x, y) + self.CROWN_M - CAMERA[2]
        return top / math.hypot(dx, dy) >= line[step]

    def _line(self, number: int) -> list:
        if number not in self._fan:
            angle, steepest = math.radians(number * self.FAN_DEG), -10.0
            line = self._fan[number] = []
            for k in range(1, int(FAR_M / self.STEP_M) + 2):
                x = CAMERA[0] + k * self.STEP_M * math.sin(angle)
                y = CAMERA[1] + k * self.STEP_M * math.cos(angle)
                if not self.ground.inside(x, y):
                    break
                rise = (self.ground.height(x, y) - CAMERA[2]) / (k * self.STEP_M)
                line.append(steepest)
                steepest = max(steepest, rise)
        return self._fan[number]


def _throw(planter: Planter, x: float, y: float) -> None:
    rng = planter.rng
    scale = rng.uniform(0.72, 1.12)
    if not planter.ground.inside(x, y) or planter.plan.open_ground(x, y):
        return
    spacing = 7.4 + 0.0018 * math.dist((x, y), CAMERA[:2])
    if planter.near(x, y, spacing) or not planter.free(x, y, 4.0 * scale):
        return
    ridge = min(1.0, max(0.0, (planter.ground.height(x, y) - 60.0) / 400.0))
    planter.plant(_wood_kind(rng, ridge), x, y, scale)


def _throw_grove(planter: Planter, sight: _Sight, x: float, y: float) -> None:
    if (planter.ground.inside(x, y) and not planter.near(x, y, GROVE_SPACING_M)
            and sight.sees(x, y)):
        planter.plant("grove", x, y, planter.rng.uniform(0.85, 1.15))


def plant_village(planter: Planter) -> None:
    """Garden trees, trees along the road, hedges along fields, shrubs at the pond."""
    rng, plan = planter.rng, planter.plan
    for house in plan.houses:
        for _ in range(9):
            x, y = house.east + rng.uniform(-24, 24), house.north + rng.uniform(-24, 24)
            kind = rng.choice(["maple", "maple", "oak", "hemlock", "shrub", "shrub"])
            scale = rng.uniform(0.45, 0.85)
            crown, spacing = (1.2, 3.5) if kind == "shrub" else (4.5 * scale, 7.0)
            if planter.free(x, y, crown) and not planter.near(x, y, spacing):
                planter.plant(kind, x, y, scale)
    for _, _, _, outline in layout.FIELDS:
        for a, b in zip(outline, outline[1:] + outline[:1]):
            if rng.random() < 0.62:
                _hedge(planter, a, b)
    for line in layout.HEDGES:
        for a, b in zip(line, line[1:]):
            _hedge(planter, a, b)
    for k in range(0, 72):
        x, y = plan.pond[k]
        if rng.random() < 0.35:
            out = 1.0 + rng.uniform(14.0, 20.0) / math.dist((x, y), layout.POND)
            x, y = (layout.POND[0] + out * (x - layout.POND[0]),
                    layout.POND[1] + out * (y - layout.POND[1]))
            kind = rng.choice(["shrub", "shrub", "maple"])
            if planter.free(x, y, 2.0) and not planter.near(x, y, 4.0):
                planter.plant(kind, x, y, rng.uniform(0.6, 0.9))
    _scatter(planter, rng)


def _hedge(planter: Planter, a: tuple, b: tuple) -> None:
    """Shrubs in a row 3 m outside a field's edge, now and then a tree among them."""
    rng, length = planter.rng, math.dist(a, b)
    nx, ny = (b[1] - a[1]) / length * 3.0, -(b[0] - a[0]) / length * 3.0
    for k in range(int(length / 3.0)):
        t = (k + rng.uniform(0.2, 0.8)) * 3.0 / length
        x, y = a[0] + t * (b[0] - a[0]) + nx, a[1] + t * (b[1] - a[1]) + ny
        tree = rng.random() < 0.15
        kind = rng.choice(["maple", "oak"]) if tree else "shrub"
        crown = 3.5 if tree else 1.5
        if (planter.plan.clear_of_roads(x, y, crown)
                and planter.plan.clear_of_buildings(x, y, crown)
                and planter.plan.clear_of_pond(x, y, 14.0)
                and not planter.near(x, y, 6.0 if tree else 1.9)):
            planter.plant(kind, x, y, rng.uniform(0.55, 0.9))


def _scatter(planter: Planter, rng: random.Random) -> None:
    """Single trees and clumps on the meadows."""
    for _ in range(130):
        cx, cy = rng.uniform(-750, 560), rng.uniform(-950, 580)
        if not polygons.contains(planter.plan.valley, cx, cy):
            continue
        for _ in range(rng.choice([1, 1, 2, 5, 7])):
            x, y = cx + rng.gauss(0, 9), cy + rng.gauss(0, 9)
            scale = rng.uniform(0.6, 1.0)
            if planter.free(x, y, 6.0 * scale) and not planter.near(x, y, 6.5):
                planter.plant(rng.choice(["oak", "maple", "maple", "hemlock"]), x, y, scale)
