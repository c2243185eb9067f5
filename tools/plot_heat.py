#!/usr/bin/env python3
"""Draws what the heat balance does and what it costs, as SVG. Standard library only.

    tools/plot_heat.py year WEATHER.csv --nadir build/nadir >docs/pictures/heat_year.svg

A year of a TMY3 file over five open, level patches of the library's materials: daily minimum, mean
and maximum. Writes the year's figures to standard error, as a table of Markdown.

    build/bench/heat_solve --table | tools/plot_heat.py accuracy >docs/pictures/heat_accuracy.svg

Error of the temperature against the processor's time, a curve a setting.
"""

import argparse
import csv
import datetime
import math
import pathlib
import subprocess
import sys
import tempfile

# What is looked at: material of the library, name, colour; all level, side by side.
SURFACES = [
    ("meadow_grass", "grass", "#2ca02c"),
    ("asphalt_road", "asphalt", "#333333"),
    ("concrete_weathered", "concrete", "#8c6d31"),
    ("galvanised_steel", "steel roof", "#d62728"),
    ("water", "water", "#1f77b4"),
]
YEAR = 2025  # of the shadows; the weather's own year does not count
SIGMA = 5.670374e-8

SCENARIO = """<?xml version="1.0" encoding="UTF-8"?>
<scenario name="year">
  <time utc="{utc}"/>
  <site latitude_deg="{latitude}" longitude_deg="{longitude}" height_m="{height}"/>
  <illumination><ephemeris/></illumination>
  <atmosphere><layered profile="midlatitude_summer"/></atmosphere>
  <heat step_min="10" shadow_interval_min="20" history_h="8760" resolution_m="40">
    <weather_file file="{weather}" format="tmy3"/>
  </heat>
  <materials>
    <library file="library:materials.xml"/>
{materials}
  </materials>
  <geometry>
{planes}
  </geometry>
  <platform>
    <position><local east_m="0" north_m="0" up_m="300"/></position>
    <attitude><look_at><local east_m="0" north_m="0" up_m="0"/></look_at></attitude>
  </platform>
  <camera>
    <perspective focal_length_mm="25">
      <array name="one" samples="1" lines="1" pitch_um="17">
        <band_box name="lwir" lo_um="8" hi_um="12"/>
      </array>
    </perspective>
  </camera>
</scenario>
"""


# ---- drawing ------------------------------------------------------------------------------------

STYLE = ("<style>.frame{fill:none;stroke:#444}.grid{stroke:#ddd;fill:none}"
         ".line{fill:none;stroke-width:1.6}</style>")


def text(x, y, content, more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" {more}>{content}</text>'


def path(points, more=""):
    return f'<path d="M{"L".join(f"{x:.1f} {y:.1f}" for x, y in points)}" {more}/>'


def picture(width, height, lines):
    yield (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
           'font-family="sans-serif" font-size="12">')
    yield STYLE
    yield f'<rect width="{width}" height="{height}" fill="#fff"/>'
    yield from lines
    yield "</svg>"


class Axis:
    """From place a to place b."""

    def __init__(self, low, high, a, b):
        self.low, self.high, self.a, self.b = low, high, a, b

    def __call__(self, value):
        return self.a + (value - self.low) / (self.high - self.low) * (self.b - self.a)


class LogAxis(Axis):
    def __init__(self, values, a, b):
        super().__init__(math.log10(min(values) / 1.25), math.log10(max(values) * 1.25), a, b)

    def __call__(self, value):
        return super().__call__(math.log10(value))

    def ticks(self):
        digits = (1, 2, 5) if self.high - self.low < 2.5 else (1,)
        for decade in range(math.floor(self.low), math.ceil(self.high) + 1):
            for digit in digits:
                if self.low <= math.log10(digit) + decade <= self.high:
                    yield digit * 10.0**decade


# ---- a year -------------------------------------------------------------------------------------


def station_of(weather):
    """Hours ahead of UTC, latitude, longitude, height: the first line of a TMY3 file."""
    with open(weather, encoding="utf-8") as file:
        cells = next(csv.reader([file.readline().lstrip("# ")]))
    return float(cells[3]), float(cells[4]), float(cells[5]), float(cells[6].split()[0])


def scenario_text(weather, station):
    ahead_h, latitude, longitude, height = station
    end = datetime.datetime(YEAR + 1, 1, 1) - datetime.timedelta(hours=ahead_h)
    materials = [f'    <material name="{material}" solve="true"/>' for material, _, _ in SURFACES]
    planes = [f'    <plane name="{material}" material="{material}" east_m="{100 * i}" size_x_m="40" '
              'size_y_m="40"/>' for i, (material, _, _) in enumerate(SURFACES)]
    return SCENARIO.format(utc=end.strftime("%Y-%m-%dT%H:%M:%SZ"), latitude=latitude,
                           longitude=longitude, height=height, weather=weather.resolve(),
                           materials="\n".join(materials), planes="\n".join(planes))


def rows_of(file, ahead_h):
    """Every step: local time, surface, air, and what makes a sky clear."""
    ahead = datetime.timedelta(hours=ahead_h)
    rows = []
    for row in csv.DictReader(file):
        time = datetime.datetime.strptime(row["utc"], "%Y-%m-%dT%H:%M:%SZ") + ahead
        surface, air = float(row["surface_c"]), float(row["air_c"])
        if not -100.0 < surface < 150.0:  # also refuses what is no number
            sys.exit(f"{surface} degrees Celsius at {time}")
        black = SIGMA * (air + 273.15)**4
        rows.append({"time": time, "surface": surface, "air": air,
                     "sun": float(row["direct_normal_w_m2"]),
                     "sky": float(row["sky_long_wave_w_m2"]) / black})
    return rows


def solve_year(weather, nadir):
    """Rows of each surface, by its name."""
    station = station_of(weather)
    solved = {}
    with tempfile.TemporaryDirectory() as folder:
        scenario, table = pathlib.Path(folder) / "year.xml", pathlib.Path(folder) / "year.csv"
        scenario.write_text(scenario_text(weather, station), encoding="utf-8")
        for i, (_, name, _) in enumerate(SURFACES):
            subprocess.run([nadir, "temperature", scenario, "--point", f"{100 * i},0", "--csv", table],
                           check=True, stdout=subprocess.DEVNULL)
            with open(table, encoding="utf-8") as file:
                solved[name] = rows_of(file, station[0])
    return solved


def mean(values):
    values = list(values)
    return sum(values) / len(values) if values else math.nan


def by_day(rows, key):
    """Day of the year from 0: minimum, mean and maximum."""
    days = {}
    for row in rows:
        days.setdefault(row["time"].timetuple().tm_yday - 1, []).append(row[key])
    return [(day, min(of), mean(of), max(of)) for day, of in sorted(days.items())]


def by_month(days):
    """Middle of each month as a day of the year, and means of minimum, mean and maximum."""
    first = [datetime.date(YEAR, month, 1).timetuple().tm_yday - 1 for month in range(1, 13)] + [365]
    for begin, end in zip(first, first[1:]):
        of = [day for day in days if begin <= day[0] < end]
        yield (0.5 * (begin + end), *(mean(day[i] for day in of) for i in (1, 2, 3)))


def when(time):
    return f"{time.day} {time:%b} {time:%H:%M}"


def over_air(rows, months, hours, clear):
    return mean(row["surface"] - row["air"] for row in rows
                if row["time"].month in months and row["time"].hour in hours and clear(row))


def at_hour(rows, month, hour, key):
    return mean(row[key] for row in rows
                if (row["time"].month, row["time"].hour, row["time"].minute) == (month, hour, 0))


def hottest_week(rows, key):
    highest = [day[3] for day in by_day(rows, "air")]
    first = max(range(len(highest) - 6), key=lambda i: sum(highest[i:i + 7]))
    return mean(day[3] for day in by_day(rows, key)[first:first + 7])


def table_row(name, rows, key):
    low, high = (choose(rows, key=lambda row: row[key]) for choose in (min, max))
    cells = [name, f"{low[key]:.1f}, {when(low['time'])}", f"{high[key]:.1f}, {when(high['time'])}",
             f"{mean(row[key] for row in rows):.1f}", f"{at_hour(rows, 7, 12, key):.1f}",
             f"{at_hour(rows, 1, 7, key):.1f}", f"{hottest_week(rows, key):.1f}"]
    if key == "surface":
        summer = (6, 7, 8)
        days = [day[3] - day[1] for day in by_day(
            [row for row in rows if row["time"].month in summer], key)]
        cells += [f"{over_air(rows, summer, (12, 13, 14), lambda row: row['sun'] > 600.0):+.1f}",
                  f"{over_air(rows, summer, (4,), lambda row: row['sky'] < 0.85):+.1f}",
                  f"{mean(days):.1f}"]
    else:
        cells += ["", "", ""]
    return "| " + " | ".join(cells) + " |"


def print_table(solved):
    print("| °C | lowest | highest | mean | July, 12 h | January, 7 h | hottest week | clear noon, K "
          "| clear night, K | range, K |\n|---|---|---|---|---|---|---|---|---|---|", file=sys.stderr)
    print(table_row("air", solved[SURFACES[0][1]], "air"), file=sys.stderr)
    for name, rows in solved.items():
        print(table_row(name, rows, "surface"), file=sys.stderr)


TOP, PANEL, HIGH, GAP, LEFT = 30, 180, 360, 8, 48


def panel(place, name, colour, rows, y):
    """One surface: its days as a band, its months as lines, the air's beside them."""
    a = LEFT + place * (PANEL + GAP)
    x = Axis(0, 365, a, a + PANEL)
    for degrees in range(int(y.low), int(y.high) + 1, 10):
        yield f'<path class="grid" d="M{a} {y(degrees):.1f}h{PANEL}"/>'
        if place == 0:
            yield text(LEFT - 6, y(degrees) + 4, f"{degrees}", 'text-anchor="end"')
    yield f'<path d="M{a} {y(0):.1f}h{PANEL}" stroke="#aaa"/>'
    days = by_day(rows, "surface")
    band = [(x(d + 0.5), y(low)) for d, low, _, _ in days]
    band += [(x(d + 0.5), y(high)) for d, _, _, high in reversed(days)]
    yield path(band, f'fill="{colour}" fill-opacity="0.18"')
    air = list(by_month(by_day(rows, "air")))
    for i, dash in ((1, "2 3"), (2, "none"), (3, "2 3")):
        yield path([(x(month[0]), y(month[i])) for month in air],
                   f'class="line" stroke="#888" stroke-dasharray="{dash}"')
    months = list(by_month(days))
    for i, dash in ((1, "5 3"), (2, "none"), (3, "5 3")):
        yield path([(x(month[0]), y(month[i])) for month in months],
                   f'class="line" stroke="{colour}" stroke-dasharray="{dash}"')
    yield f'<rect x="{a}" y="{TOP}" width="{PANEL}" height="{HIGH}" class="frame"/>'
    yield text(a + PANEL / 2, TOP - 10, name, f'text-anchor="middle" font-weight="bold" fill="{colour}"')
    for month, letter in zip(months, "JFMAMJJASOND"):
        yield text(x(month[0]), TOP + HIGH + 16, letter, 'text-anchor="middle" font-size="11"')


def draw_year(solved):
    every = [row["surface"] for rows in solved.values() for row in rows]
    y = Axis(10 * math.floor(min(every) / 10), 10 * math.ceil(max(every) / 10), TOP + HIGH, TOP)
    lines = []
    for place, (_, name, colour) in enumerate(SURFACES):
        lines += panel(place, name, colour, solved[name], y)
    lines.append(text(14, TOP + HIGH / 2, "temperature, °C",
                      f'text-anchor="middle" transform="rotate(-90 14 {TOP + HIGH / 2})"'))
    lines.append(text(LEFT, TOP + HIGH + 40,
                      "Band: each day, lowest to highest. Lines: month's mean of the daily mean (full), "
                      "minimum and maximum (dashed); grey: the air's, likewise."))
    width = LEFT + len(SURFACES) * (PANEL + GAP)
    print("\n".join(picture(width, TOP + HIGH + 54, lines)))


# ---- accuracy against time ----------------------------------------------------------------------

# Setting of heat_solve: colour, default, name.
SETTINGS = {
    "step_s": ("#1f77b4", 600.0, "step, s"),
    "growth (first interval with it)": ("#2ca02c", 1.3, "growth of nodes' intervals"),
    "shadow_interval_s": ("#d62728", 600.0, "shadow interval, s"),
    "sky_rays": ("#9467bd", 64.0, "sky rays"),
    "surroundings": ("#ff7f0e", 8.0, "surroundings"),
    "spin_up_k": ("#8c564b", 0.05, "spin-up, K"),
}
SMALLEST_K = 0.001  # errors below are not drawn: the table has four digits
BOX = (70, 24, 560, 424)  # left, top, right, bottom


def accuracy_rows(lines):
    """Points of each setting: (time in us, error in K, value), ascending in value; and the rms
    error of the defaults in all things together."""
    points, together = {}, None
    for row in csv.DictReader(lines):
        if row["setting"] not in SETTINGS:
            continue
        value = float(row["value"])
        points.setdefault(row["setting"], []).append(
            (float(row["us_a_cell"]), float(row["own_rms_k"]), value))
        if row["setting"] == "step_s" and value == SETTINGS["step_s"][1]:
            together = float(row["all_rms_k"])
    drawn = {name: sorted((p for p in of if p[1] >= SMALLEST_K), key=lambda p: p[2])
             for name, of in points.items()}
    return drawn, together


def accuracy_grid(x, y):
    left, top, right, bottom = BOX
    for value in x.ticks():
        yield f'<path class="grid" d="M{x(value):.1f} {top}V{bottom}"/>'
        yield text(x(value), bottom + 18, f"{value:g}", 'text-anchor="middle"')
    for value in y.ticks():
        yield f'<path class="grid" d="M{left} {y(value):.1f}H{right}"/>'
        yield text(left - 8, y(value) + 4, f"{value:g}", 'text-anchor="end"')
    yield f'<rect x="{left}" y="{top}" width="{right - left}" height="{bottom - top}" class="frame"/>'
    yield text((left + right) / 2, bottom + 42, "processor time a cell, µs", 'text-anchor="middle"')
    middle = (top + bottom) / 2
    yield text(18, middle, "error of the surface temperature, K rms",
               f'text-anchor="middle" transform="rotate(-90 18 {middle})"')


def accuracy_curve(name, points, x, y):
    colour, default, _ = SETTINGS[name]
    yield path([(x(us), y(error)) for us, error, _ in points], f'class="line" stroke="{colour}"')
    for us, error, value in points:
        yield f'<circle cx="{x(us):.1f}" cy="{y(error):.1f}" r="3.2" fill="{colour}"/>'
        if value == default:
            yield (f'<circle cx="{x(us):.1f}" cy="{y(error):.1f}" r="7" fill="none" '
                   f'stroke="{colour}" stroke-width="1.5"/>')
    for us, error, value in {points[0], points[-1]}:
        yield text(x(us) + 7, y(error) - 5, f"{value:g}", f'fill="{colour}" font-size="11"')


def draw_accuracy(lines):
    points, together = accuracy_rows(lines)
    every = [p for of in points.values() for p in of]
    if not every or together is None:
        sys.exit("no rows of heat_solve --table")
    left, top, right, bottom = BOX
    x = LogAxis([p[0] for p in every], left, right)
    y = LogAxis([p[1] for p in every] + [together], bottom, top)
    out = list(accuracy_grid(x, y))
    out.append(f'<path d="M{left} {y(together):.1f}H{right}" stroke="#000" stroke-dasharray="6 4"/>')
    for i, (name, of) in enumerate(points.items()):
        if of:
            out += accuracy_curve(name, of, x, y)
        colour, default, label = SETTINGS[name]
        more = f" ({default:g})" if of else f" ({default:g}): below {SMALLEST_K:g} K"
        out.append(text(right + 14, top + 20 + 20 * i, label + more, f'fill="{colour}"'))
    notes = ["circles, figures in brackets:", "the defaults", "",
             f"broken line: all defaults together, {together:.2g} K"]
    for i, note in enumerate(notes):
        out.append(text(right + 14, top + 40 + 20 * len(points) + 18 * i, note))
    print("\n".join(picture(right + 260, bottom + 56, out)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    kinds = parser.add_subparsers(dest="kind", required=True)
    year = kinds.add_parser("year", help="a year of weather over five surfaces")
    year.add_argument("weather", type=pathlib.Path, help="TMY3 file")
    year.add_argument("--nadir", default="nadir", help="the command; default: on the PATH")
    accuracy = kinds.add_parser("accuracy", help="error against time of heat_solve --table")
    accuracy.add_argument("table", type=argparse.FileType(encoding="utf-8"), nargs="?",
                          default=sys.stdin, help="CSV; default: standard input")
    options = parser.parse_args()
    if options.kind == "year":
        solved = solve_year(options.weather, options.nadir)
        print_table(solved)
        draw_year(solved)
    else:
        draw_accuracy(options.table)


if __name__ == "__main__":
    main()
