"""Where everything lies: roads, fields, pond and buildings, in metres east and north of the site.

Drawn by hand on the terrain's level ground; houses then line up along the roads by themselves.
"""

import dataclasses
import math
import random

from jacksboro import polygons

# Middle of the village, on the valley floor below the Jacksboro fault's scarp. The height is that
# of the terrain there, so that the scene's up coordinate is about 0 in the village.
SITE = (36.590, -84.2183, 312.0)

ROAD_WIDTH_M, LANE_WIDTH_M, DRIVE_WIDTH_M = 7.0, 4.5, 3.0

# The open valley floor; all around it is forest.
VALLEY = [(40, -1010), (290, -960), (330, -690), (400, -470), (462, -210), (520, 40), (575, 250),
          (600, 450), (500, 610), (330, 560), (170, 600), (-20, 545), (-220, 600), (-420, 520),
          (-690, 500), (-800, 400), (-700, 290), (-560, 235), (-500, 95), (-440, -70), (-335, -190),
          (-290, -310), (-140, -420), (-70, -610), (-10, -810)]
# Clearings higher up.
CLEARINGS = [
    [(-330, 760), (-130, 720), (60, 790), (90, 960), (-90, 1020), (-290, 950)],
    [(260, 800), (470, 760), (560, 960), (420, 1120), (270, 1010)],
    [(-590, -260), (-500, -300), (-440, -210), (-480, -110), (-570, -130)],
]
MAIN_ROAD = [(150, -1290), (110, -1010), (60, -800), (20, -620), (-40, -430), (-85, -240),
             (-80, -60), (-105, 110), (-160, 270), (-270, 380), (-420, 420), (-600, 385),
             (-760, 400), (-930, 470)]
NORTH_ROAD = [(-160, 270), (-95, 400), (-30, 520), (-20, 680), (-60, 860), (-40, 1060), (30, 1290)]
EAST_LANE = [(-80, -60), (10, -40), (95, -50), (190, -20), (300, 10), (410, 70), (500, 190)]
SOUTH_LANE = [(-85, -240), (-170, -215), (-250, -160), (-330, -60), (-380, 60)]

BARN = (150.0, 12.0, 160.0)       # east, north, yaw of the front in degrees
CHURCH = (-132.0, -105.0, 80.0)
POND = (250.0, -172.0)            # centre, where the plain is level within 0.2 m

FIELDS = [  # part, second part of the strips or none, azimuth of the strips, outline
    ("tilled", None, 0.0, [(215, 45), (300, 75), (395, 120), (380, 260), (230, 230)]),
    ("crop", "stubble", 20.0, [(30, 90), (195, 60), (215, 240), (225, 400), (70, 420), (10, 270)]),
    ("crop", None, 0.0, [(245, 250), (380, 280), (470, 330), (480, 450), (350, 500), (250, 410)]),
    ("stubble", None, 0.0, [(330, -50), (430, 10), (470, 110), (420, 60), (320, -5)]),
    ("stubble", "tilled", 62.0, [(75, -660), (230, -640), (300, -470), (150, -410), (60, -440)]),
    ("crop", None, 0.0, [(100, -890), (240, -860), (270, -690), (90, -690)]),
    ("crop", "tilled", 105.0, [(-410, 110), (-230, 60), (-190, 190), (-260, 320), (-430, 330)]),
    ("stubble", None, 0.0, [(-370, -40), (-290, -90), (-180, -60), (-170, 60), (-300, 50)]),
    ("tilled", "crop", 45.0, [(-660, 415), (-460, 450), (-450, 500), (-660, 480)]),
    ("crop", None, 0.0, [(-280, 790), (-140, 750), (-90, 900), (-250, 920)]),
    ("stubble", None, 0.0, [(-10, 810), (60, 820), (70, 930), (-20, 950)]),
    ("tilled", "stubble", 10.0, [(300, 830), (450, 790), (520, 950), (420, 1060), (310, 990)]),
    ("crop", None, 0.0, [(-560, -240), (-500, -270), (-460, -200), (-500, -140), (-560, -150)]),
]
# Hedges and rows of trees between pastures.
HEDGES = [[(-40, -330), (60, -300), (150, -300), (250, -290), (370, -300), (440, -290)],
          [(150, -300), (140, -410)], [(-60, -150), (40, -140), (130, -120)],
          [(130, -120), (150, -300)],
          [(480, 190), (520, 330), (500, 470)],
          [(-210, 420), (-60, 490)], [(20, 440), (220, 470)],
          [(-230, -220), (-130, -330)]]
# road, from and to along it in m, houses' distance from its middle, spacing
STREETS = [
    (MAIN_ROAD, 700, 1560, 20.0, 40.0),
    (NORTH_ROAD, 40, 330, 19.0, 44.0),
    (EAST_LANE, 30, 150, 17.0, 34.0),
    (SOUTH_LANE, 40, 300, 18.0, 46.0),
    (MAIN_ROAD, 1650, 1980, 26.0, 70.0),
]
STYLES = ["cottage_white", "cottage_brick", "farmhouse_white", "farmhouse_brick", "ranch_white",
          "ranch_block"]
REACH_M = {"cottage": 8.0, "farmhouse": 11.0, "ranch": 13.2}  # from the origin to the far corner


@dataclasses.dataclass
class House:
    style: str
    east: float
    north: float
    yaw_deg: float
    gate: tuple  # where its drive leaves the road

    @property
    def reach(self) -> float:
        return REACH_M[self.style.split("_")[0]]


@dataclasses.dataclass
class Plan:
    """Everything with its final outline."""

    roads: list    # (line, width)
    houses: list
    sheds: list    # (east, north, yaw)
    pond: list     # shore, counter-clockwise
    valley: list

    def open_ground(self, x: float, y: float) -> bool:
        return polygons.contains(self.valley, x, y) or any(
            polygons.contains(c, x, y) for c in CLEARINGS)

    def clear_of_roads(self, x: float, y: float, margin: float) -> bool:
        return all(polygons.distance(line, x, y) > width / 2 + margin for line, width in self.roads)

    def clear_of_buildings(self, x: float, y: float, margin: float) -> bool:
        spots = [(h.east, h.north, h.reach) for h in self.houses]
        spots += [(x1, y1, 4.0) for x1, y1, _ in self.sheds]
        spots += [(BARN[0], BARN[1], 24.0), (CHURCH[0], CHURCH[1], 16.0)]
        return all(math.hypot(x - a, y - b) > reach + margin for a, b, reach in spots)

    def clear_of_pond(self, x: float, y: float, margin: float) -> bool:
        return (not polygons.contains(self.pond, x, y)
                and polygons.edge_distance(self.pond, x, y) > margin)

    def clear_of_fields(self, x: float, y: float, margin: float) -> bool:
        return all(not polygons.contains(outline, x, y)
                   and polygons.edge_distance(outline, x, y) > margin
                   for _, _, _, outline in FIELDS)


def make_plan() -> Plan:
    main = polygons.smooth_line(MAIN_ROAD, 10.0)
    roads = [(main, ROAD_WIDTH_M)]
    others = ((NORTH_ROAD, ROAD_WIDTH_M - 1.0), (EAST_LANE, LANE_WIDTH_M),
              (SOUTH_LANE, LANE_WIDTH_M))
    roads += [(polygons.smooth_line(knots, 10.0), width) for knots, width in others]
    plan = Plan(roads, [], [], _shore(), _ragged(VALLEY))
    rng = random.Random(21)
    for knots, first, last, setback, spacing in STREETS:
        line = polygons.smooth_line(knots, 10.0)
        for side in (1.0, -1.0):
            _line_up(plan, rng, line, (first, last), setback, spacing, side)
    return plan


def _shore() -> list:
    """A lobed oval of about 130 x 85 m."""
    shore = []
    for k in range(72):
        a = math.tau * k / 72
        r = 1.0 + 0.12 * math.cos(2 * a + 0.6) + 0.10 * math.cos(3 * a + 2.1)
        r += 0.03 * math.cos(7 * a)
        x, y = 64.0 * r * math.cos(a), 40.0 * r * math.sin(a)
        turn = math.radians(25.0)
        shore.append((POND[0] + x * math.cos(turn) - y * math.sin(turn),
                      POND[1] + x * math.sin(turn) + y * math.cos(turn)))
    return shore


def meadow_patches(plan: Plan) -> list:
    """Blots of drier and lusher grass; they overlap neither the valley's edge nor each other."""
    rng, patches = random.Random(8), []
    while len(patches) < 46:
        x, y, size = rng.uniform(-720, 560), rng.uniform(-960, 580), rng.uniform(14.0, 46.0)
        if (not polygons.contains(plan.valley, x, y)
                or polygons.edge_distance(plan.valley, x, y) < 1.7 * size
                or any(math.hypot(x - u, y - v) < 1.6 * (size + r) for u, v, r in patches)):
            continue
        patches.append((x, y, size))
    return [_blot(rng, *patch) for patch in patches]


def _blot(rng: random.Random, x: float, y: float, size: float) -> list:
    phases = [rng.uniform(0.0, math.tau) for _ in range(4)]
    blot, turn, stretch = [], rng.uniform(0.0, math.pi), rng.uniform(1.0, 1.6)
    for k in range(32):
        a = math.tau * k / 32
        r = size * (1.0 + sum(0.11 * math.cos((n + 2) * a + f) for n, f in enumerate(phases)))
        u, v = r * stretch * math.cos(a), r / stretch * math.sin(a)
        blot.append((x + u * math.cos(turn) - v * math.sin(turn),
                     y + u * math.sin(turn) + v * math.cos(turn)))
    return blot


def _ragged(outline: list) -> list:
    """The forest's edge is never straight."""
    rng = random.Random(5)
    line = polygons.smooth_line(outline + outline[:1], 35.0)[:-1]
    return [(x + rng.uniform(-9, 9), y + rng.uniform(-9, 9)) for x, y in line]


def _line_up(plan: Plan, rng: random.Random, line: list, reach: tuple, setback: float,
             spacing: float, side: float) -> None:
    travelled, due = 0.0, reach[0] + rng.uniform(0.0, spacing)
    for a, b in zip(line, line[1:]):
        length = math.dist(a, b)
        while travelled <= due < travelled + length and due < reach[1]:
            t = (due - travelled) / length
            gate = (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))
            across = (side * (b[1] - a[1]) / length, -side * (b[0] - a[0]) / length)
            _settle(plan, rng, gate, across, setback + rng.uniform(-2.0, 5.0))
            due += spacing * rng.uniform(0.85, 1.35)
        travelled += length


def _settle(plan: Plan, rng: random.Random, gate: tuple, across: tuple, setback: float) -> None:
    """A house beside the road if there is room, facing it; some have a shed behind."""
    x, y = gate[0] + setback * across[0], gate[1] + setback * across[1]
    style = rng.choice(STYLES)
    # the front looks back at the road: an azimuth, clockwise from north
    yaw = math.degrees(math.atan2(-across[0], -across[1])) + rng.uniform(-4.0, 4.0)
    house = House(style, round(x, 2), round(y, 2), round(yaw % 360.0, 1), gate)
    reach = house.reach
    if not (polygons.contains(plan.valley, x, y) and plan.clear_of_roads(x, y, reach - 1.0)
            and plan.clear_of_buildings(x, y, reach + 1.0)
            and plan.clear_of_pond(x, y, reach + 14.0)
            and plan.clear_of_fields(x, y, reach - 3.0)):
        return
    plan.houses.append(house)
    if rng.random() < 0.5:
        sx, sy = x + 17.0 * across[0] + 8.0 * across[1], y + 17.0 * across[1] - 8.0 * across[0]
        if (plan.clear_of_roads(sx, sy, 4.0) and plan.clear_of_buildings(sx, sy, 4.0)
                and plan.clear_of_fields(sx, sy, 3.0) and plan.clear_of_pond(sx, sy, 16.0)):
            plan.sheds.append((round(sx, 2), round(sy, 2), round((yaw + 90.0) % 360.0, 1)))
