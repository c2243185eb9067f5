"""A smoke plume that bends over in the wind, as density and temperature on a grid (NRRD)."""

import math
import pathlib
import random
import struct

# The volume's box in metres, x along the wind from the stack's mouth; and the air around it.
LO, HI = (-4.0, -13.0, -3.0), (92.0, 13.0, 29.0)
CELLS = (48, 26, 32)
AIR_K, EXIT_K = 288.0, 420.0


def rise_m(x: float) -> float:
    """Height of the axis: Briggs' two-thirds law, 1.6 F^(1/3) x^(2/3) / u, F = 16.4 m^4/s^3 and
    u = 5 m/s (G. A. Briggs, Plume Rise, AEC 1969)."""
    return 1.6 * 16.384 ** (1 / 3) * max(x, 0.0) ** (2 / 3) / 5.0


def radius_m(x: float) -> float:
    """Entrainment: the plume widens with 0.4 of its rise (Briggs 1969)."""
    return 1.3 + 0.4 * rise_m(x) + 0.02 * max(x, 0.0)


def _noise(rng: random.Random) -> list:
    """Puffs: random waves that drift apart from each other."""
    return [(rng.uniform(0.15, 0.9), rng.uniform(-0.7, 0.7), rng.uniform(-0.7, 0.7),
             rng.uniform(0, 6.283)) for _ in range(14)]


def grids() -> tuple:
    rng = random.Random(4)
    waves, density, kelvin = _noise(rng), [], []
    for k in range(CELLS[2]):
        for j in range(CELLS[1]):
            for i in range(CELLS[0]):
                x, y, z = (LO[a] + (n + 0.5) * (HI[a] - LO[a]) / CELLS[a]
                           for a, n in ((0, i), (1, j), (2, k)))
                density.append(_density(x, y, z, waves))
                # mixed with air in proportion to the cross-section's growth
                kelvin.append(AIR_K + (EXIT_K - AIR_K) * (radius_m(0.0) / radius_m(x)) ** 2)
    return density, kelvin


def _density(x: float, y: float, z: float, waves: list) -> float:
    if x < -1.3:
        return 0.0
    puff = sum(math.sin(a * x + b * y + c * z + d) for a, b, c, d in waves) / len(waves)
    width = radius_m(x)
    axis = rise_m(x) + 0.5 * width * math.sin(0.22 * x + 1.0) * min(1.0, x / 40.0)
    r = math.hypot(y - 0.3 * width * math.sin(0.17 * x), z - axis) / width
    # mass flux is the same at every distance: density falls as the section grows
    value = math.exp(-r * r) * (radius_m(0.0) / width) ** 1.2 * max(0.0, 1.0 + 2.2 * puff)
    return value if value > 0.004 else 0.0


def write_nrrd(path: pathlib.Path, kind: str, values: list) -> None:
    code = {"uint8": "B", "uint16": "H"}[kind]
    head = ["NRRD0004", "# Made by tools/make_showcase.py", f"type: {kind}", "dimension: 3",
            "sizes: " + " ".join(map(str, CELLS))]
    head += (["endian: little"] if kind != "uint8" else []) + ["encoding: raw"]
    data = struct.pack(f"<{len(values)}{code}", *(round(value) for value in values))
    path.write_bytes(("\n".join(head) + "\n\n").encode("ascii") + data)


def write(folder: pathlib.Path) -> None:
    density, kelvin = grids()
    peak = max(density)
    write_nrrd(folder / "plume_density.nrrd", "uint8", [255.0 * value / peak for value in density])
    write_nrrd(folder / "plume_temperature.nrrd", "uint16", kelvin)
