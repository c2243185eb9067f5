"""Reading reference figures, thinning curves, writing the project's spectrum format."""

import csv
import math
import pathlib

SCRIPT = "tools/make_library.py"


def read_csv(path: pathlib.Path) -> list:
    """Rows as dictionaries; leading lines that start with '#' are skipped."""
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def first_comment(path: pathlib.Path) -> str:
    """The text of the '#' line at the top of a file."""
    with path.open(encoding="utf-8") as file:
        line = file.readline()
    if not line.startswith("#"):
        raise ValueError(f"{path.name}: no '#' line at its top")
    return line.lstrip("# ").strip()


def interpolate(curve: list, x: float) -> float:
    """Piecewise linear through ascending (x, y); end values are held."""
    if x <= curve[0][0]:
        return curve[0][1]
    if x >= curve[-1][0]:
        return curve[-1][1]
    low, high = 0, len(curve) - 1
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if curve[middle][0] <= x else (low, middle)
    (x0, y0), (x1, y1) = curve[low], curve[high]
    return y0 + (y1 - y0) * (x - x0) / (x1 - x0)


def integral(curve: list) -> float:
    """Trapezoid rule, exact for the piecewise linear curve."""
    return sum(0.5 * (a[1] + b[1]) * (b[0] - a[0]) for a, b in zip(curve, curve[1:]))


def bin_mean(curve: list, lo: float, hi: float) -> float:
    """Mean of the piecewise linear curve over [lo, hi]."""
    inner = [p for p in curve if lo < p[0] < hi]
    ends = (lo, interpolate(curve, lo)), (hi, interpolate(curve, hi))
    return integral([ends[0], *inner, ends[1]]) / (hi - lo)


def window(curve: list, lo: float, hi: float) -> tuple:
    """The curve on [lo, hi], end values held beyond its table, and what was held, in words."""
    held = []
    if curve[0][0] > lo:
        held.append(f"{lo:g} to {curve[0][0]:g} um by the value at {curve[0][0]:g} um")
    if curve[-1][0] < hi:
        held.append(f"{curve[-1][0]:g} to {hi:g} um by the value at {curve[-1][0]:g} um")
    inner = [p for p in curve if lo < p[0] < hi]
    return [(lo, interpolate(curve, lo)), *inner, (hi, interpolate(curve, hi))], ", ".join(held)


def thin(curve: list, tolerance: float) -> list:
    """Douglas-Peucker in the ordinate: linear interpolation in what is left stays within
    `tolerance` of every point left out."""
    keep = {0, len(curve) - 1}
    stack = [(0, len(curve) - 1)]
    while stack:
        first, last = stack.pop()
        (x0, y0), (x1, y1) = curve[first], curve[last]
        worst, where = tolerance, None
        for i in range(first + 1, last):
            x, y = curve[i]
            error = abs(y - (y0 + (y1 - y0) * (x - x0) / (x1 - x0)))
            if error > worst:
                worst, where = error, i
        if where is not None:
            keep.add(where)
            stack += [(first, where), (where, last)]
    return [curve[i] for i in sorted(keep)]


def thin_to(curve: list, tolerance: float, most: int) -> tuple:
    """Thins to at most `most` points, by widening the tolerance until they suffice."""
    while len(thinned := thin(curve, tolerance)) > most:
        tolerance *= 1.25
    return thinned, tolerance


def number(value: float) -> str:
    return "0" if value == 0 else f"{value:.6g}"


def write_spectrum(path: pathlib.Path, header: dict, columns: dict) -> None:
    """Writes `columns` (name -> ascending (um, value) pairs) in the format of docs/formats.md.

    A column that does not have a wavelength of another one gets an empty cell there. `header`
    values that are lists become repeated lines; empty ones are left out.
    """
    lines = ["# nadir-spectrum: 1"]
    for key, value in header.items():
        values = value if isinstance(value, list) else [value]
        lines += [f"# {key}: {' '.join(v.split())}" for v in values if v]
    lookup = {name: {f"{x:.6f}": y for x, y in curve} for name, curve in columns.items()}
    grid = sorted({f"{x:.6f}" for curve in columns.values() for x, _ in curve}, key=float)
    lines.append(",".join(["wavelength_um", *columns]))
    for x in grid:
        cells = [number(column[x]) if x in column else "" for column in lookup.values()]
        if any(c and not math.isfinite(float(c)) for c in cells):
            raise ValueError(f"{path.name}: a number at {x} um is not finite")
        lines.append(",".join([f"{float(x):.6g}", *cells]))
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")
