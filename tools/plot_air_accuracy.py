#!/usr/bin/env python3
"""Draws accuracy against time of air tables as SVG.

    build/bench/air_tables --csv | tools/plot_air_accuracy.py >docs/pictures/air_accuracy.svg

One line for each thing that is varied; the default belongs to all of them. Standard library only.
"""

import csv
import math
import sys

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 760, 480, 70, 24, 190, 56
# What is varied: its colour, and what the default is on its axis.
FAMILIES = {
    "streams": ("#1f77b4", "8"),
    "layers": ("#2ca02c", "1"),
    "term tolerance": ("#d62728", "0.0005"),
    "nodes": ("#9467bd", "16"),
}
NAMES = {
    "streams": "streams (2: fast mode)",
    "layers": "layers, times the default",
    "term tolerance": "tolerance of terms",
    "nodes": "nodes of zenith, azimuth",
}


class Axis:
    """Logarithmic, from place a to place b."""

    def __init__(self, values, a, b):
        self.low = math.log10(min(values) / 1.25)
        self.high = math.log10(max(values) * 1.25)
        self.a, self.b = a, b

    def __call__(self, value):
        share = (math.log10(value) - self.low) / (self.high - self.low)
        return self.a + share * (self.b - self.a)

    def ticks(self):
        for decade in range(math.floor(self.low), math.ceil(self.high) + 1):
            for digit in (1, 2, 5):
                if self.low <= math.log10(digit) + decade <= self.high:
                    yield digit * 10.0**decade


def read(lines):
    """Points of each family: (time in s, error in %, label), ascending in time."""
    points = {family: [] for family in FAMILIES}
    for row in csv.DictReader(lines):
        point = float(row["cpu_ms"]) / 1e3, 100.0 * float(row["rms_error"])
        family = "streams" if row["family"] == "fast" else row["family"]
        if family == "default":
            for name, (_, value) in FAMILIES.items():
                points[name].append((*point, value))
        elif family in points:
            points[family].append((*point, row["value"]))
    return {family: sorted(of) for family, of in points.items()}


def text(x, y, content, more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" {more}>{content}</text>'


def grid(x, y):
    yield f'<rect x="{LEFT}" y="{TOP}" width="{WIDTH - LEFT - RIGHT}" height="{HEIGHT - TOP - BOTTOM}" class="frame"/>'
    for value in x.ticks():
        yield f'<path class="grid" d="M{x(value):.1f} {TOP}V{HEIGHT - BOTTOM}"/>'
        yield text(x(value), HEIGHT - BOTTOM + 18, f"{value:g}", 'text-anchor="middle"')
    for value in y.ticks():
        yield f'<path class="grid" d="M{LEFT} {y(value):.1f}H{WIDTH - RIGHT}"/>'
        yield text(LEFT - 8, y(value) + 4, f"{value:g}", 'text-anchor="end"')
    middle = 0.5 * (LEFT + WIDTH - RIGHT)
    yield text(middle, HEIGHT - 14, "processor time of a table of 60 wavelengths, s", 'text-anchor="middle"')
    height = 0.5 * (TOP + HEIGHT - BOTTOM)
    yield text(18, height, "rms error of radiance, %", f'text-anchor="middle" transform="rotate(-90 18 {height})"')


def curves(points, x, y):
    for i, (family, of) in enumerate(points.items()):
        colour = FAMILIES[family][0]
        way = "L".join(f"{x(time):.1f} {y(error):.1f}" for time, error, _ in of)
        yield f'<path d="M{way}" stroke="{colour}" fill="none" stroke-width="1.5"/>'
        for time, error, label in of:
            yield f'<circle cx="{x(time):.1f}" cy="{y(error):.1f}" r="3.5" fill="{colour}"/>'
            if label != FAMILIES[family][1]:
                label = f"{float(label):.2g}"
                yield text(x(time) + 6, y(error) - 5, label, f'fill="{colour}"')
        yield text(WIDTH - RIGHT + 14, TOP + 20 + 20 * i, NAMES[family], f'fill="{colour}"')


def main():
    points = read(sys.stdin)
    every = [point for of in points.values() for point in of]
    if not every:
        sys.exit("no rows of air_tables --csv on standard input")
    x = Axis([p[0] for p in every], LEFT, WIDTH - RIGHT)
    y = Axis([p[1] for p in every], HEIGHT - BOTTOM, TOP)
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="12">')
    print("<style>.frame{fill:none;stroke:#444}.grid{stroke:#ddd}</style>")
    print(f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>')
    for line in (*grid(x, y), *curves(points, x, y)):
        print(line)
    default = next(p for p in points["streams"] if p[2] == "8")
    print(f'<circle cx="{x(default[0]):.1f}" cy="{y(default[1]):.1f}" r="7" fill="none" stroke="#000"/>')
    print(text(WIDTH - RIGHT + 14, TOP + 20 + 20 * len(points), "circle: the default"))
    print("</svg>")


if __name__ == "__main__":
    main()
