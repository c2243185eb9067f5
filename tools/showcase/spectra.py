"""Spectra of the showcase: invented paints and lamps, and what follows from Nadir's library."""

import math
import pathlib

INVENTED = ["source: invented for this scene; not measured", "licence: Apache-2.0 (made for Nadir)",
            "made-by: tools/make_showcase.py"]


def read(path: pathlib.Path) -> list:
    """Rows of numbers of a spectrum file."""
    lines = [line for line in path.read_text(encoding="utf-8").splitlines()
             if line and not line.startswith("#")]
    return [[float(cell) for cell in line.split(",")] for line in lines[1:]]


def write(path: pathlib.Path, title: str, facts: list, columns: dict, wavelengths: list) -> None:
    """A plain table; `columns` are functions of the wavelength in um."""
    lines = [f"# {title}"] + [f"# {fact}" for fact in facts]
    lines.append("wavelength_um," + ",".join(columns))
    for um in wavelengths:
        lines.append(f"{um:g}," + ",".join(f"{max(f(um), 0.0):.5g}" for f in columns.values()))
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def interpolate(rows: list, um: float, column: int = 1) -> float:
    if um <= rows[0][0]:
        return rows[0][column]
    for a, b in zip(rows, rows[1:]):
        if um <= b[0]:
            return a[column] + (b[column] - a[column]) * (um - a[0]) / (b[0] - a[0])
    return rows[-1][column]


def _edge(um: float, at: float, width: float) -> float:
    return 1.0 / (1.0 + math.exp((at - um) / width))


def _hump(um: float, at: float, width: float) -> float:
    return math.exp(-((um - at) / width) ** 2)


def paints(folder: pathlib.Path) -> None:
    """Pigments step up at an edge or have a hump; all paint is dark beyond 3 um."""
    def fade(shape):
        return lambda um: shape(um) if um < 2.5 else 0.06

    write(folder / "paints.csv", "Paints: reflectance below the gloss", INVENTED, {
        "red": fade(lambda u: 0.03 + 0.52 * _edge(u, 0.605, 0.012)),
        "orange": fade(lambda u: 0.04 + 0.58 * _edge(u, 0.565, 0.014)),
        "yellow": fade(lambda u: 0.05 + 0.62 * _edge(u, 0.51, 0.012)),
        "blue": fade(lambda u: 0.03 + 0.30 * _hump(u, 0.46, 0.04) + 0.3 * _edge(u, 0.72, 0.02)),
        "green": fade(lambda u: 0.03 + 0.24 * _hump(u, 0.53, 0.035) + 0.3 * _edge(u, 0.72, 0.02)),
        "white": fade(lambda u: 0.05 + 0.77 * _edge(u, 0.40, 0.008)),
        "dark": fade(lambda u: 0.035),
    }, [0.35 + 0.01 * k for k in range(46)] + [0.9, 1.2, 2.4, 2.6, 14.0])


def leaf(folder: pathlib.Path) -> None:
    """A single leaf in the visible and near infrared by eye, dark in the thermal infrared."""
    def reflectance(u):
        if u > 2.5:
            return 0.04
        green = 0.05 + 0.08 * math.exp(-((u - 0.55) / 0.035) ** 2) + 0.42 * _edge(u, 0.715, 0.012)
        return green if u < 1.3 else 0.25
    title = "A broad leaf: hemispherical reflectance and transmittance"
    write(folder / "leaf.csv", title, INVENTED, {
        "reflectance": reflectance,
        "transmittance": lambda u: 0.0 if u > 2.5 else 0.85 * reflectance(u) - 0.015,
    }, [0.35 + 0.02 * k for k in range(28)] + [1.29, 1.31, 2.49, 2.51, 14.0])


def glass(library: pathlib.Path, folder: pathlib.Path) -> None:
    """A pane of 6 mm: by hand below 5 um; optical depth 4 pi k d / lambda beyond: opaque."""
    rows = read(library / "optics" / "soda_lime_glass.csv")

    def depth(um):
        if um < 2.7:
            return 0.06 if um < 0.7 else 0.25
        k = interpolate(rows, um, 2) if um >= 5 else 0.001
        return min(9000.0, 4 * math.pi * k * 6000.0 / um)
    write(folder / "glass.csv", "Window pane of 6 mm, slightly grey", [
        "source: soda lime glass of Nadir's library beyond 5 um; invented below",
        "licence: CC0-1.0 (refractiveindex.info)",
        "made-by: tools/make_showcase.py from library optics/soda_lime_glass.csv",
    ], {"n": lambda u: 1.52 if u < 5 else interpolate(rows, u), "absorption": depth},
        [0.35, 0.69, 0.71, 2.6, 2.8, 4.9] + [row[0] for row in rows if 5 <= row[0] <= 14.5])


def water_body(folder: pathlib.Path) -> None:
    title = "Harbour water: diffuse reflectance from below the surface"
    write(folder / "water_body.csv", title, INVENTED, {
        "reflectance": lambda u: 0.0 if u > 0.9 else
        0.010 + 0.020 * math.exp(-((u - 0.53) / 0.08) ** 2) * _edge(u, 0.44, 0.03)},
        [0.35 + 0.02 * k for k in range(28)] + [0.92, 14.0])


def moon(library: pathlib.Path, folder: pathlib.Path) -> None:
    """E = E_sun p (R / d)^2 at full moon, geometric albedo p = 0.12 (lambda / 0.55 um)^0.9,
    at most 0.4: 0.12 in the visible (C. W. Allen, Astrophysical Quantities); reddening by eye."""
    rows = [row for row in read(library / "illumination" / "solar.csv") if 0.3 <= row[0] <= 14.2]
    share = (1737.4 / 384400.0) ** 2
    title = "The full moon above the air, W m^-2 um^-1: sunlight it reflects"
    write(folder / "full_moon.csv", title, [
        "source: solar.csv of Nadir's library (TSIS-1 HSRS) times geometric albedo times (R / d)^2",
        "note: geometric albedo 0.12 at 0.55 um, its reddening by eye; its own heat is left out",
        "licence: as illumination/solar.csv", "made-by: tools/make_showcase.py",
    ], {"irradiance": lambda u: interpolate(rows, u) * share * min(0.4, 0.12 * (u / 0.55) ** 0.9)},
        sorted({row[0] for row in rows[:: 8]} | {rows[0][0], rows[-1][0]}))


def smoke(folder: pathlib.Path) -> None:
    """Oil smoke: mostly scattering in the visible, grey soot absorption falling as 1 / lambda."""
    write(folder / "plume.csv", "Coefficients of the plume at its densest, 1/m", INVENTED, {
        "absorption": lambda u: 0.015 * 0.55 / u + (0.06 if u > 2.5 else 0.0),
        "scattering": lambda u: 0.30 * (0.55 / u) ** 1.2,
    }, [0.35 + 0.05 * k for k in range(14)] + [1.5, 2.49, 2.51, 4.0, 8.0, 10.0, 12.0, 14.0])


def ground(library: pathlib.Path, folder: pathlib.Path) -> None:
    """Albedo w of the grains whose half-space reflects r: w = 1 - ((1 - r) / (1 + r))^2 for r the
    diffusive reflectance (B. Hapke, Theory of Reflectance and Emittance Spectroscopy, 2012)."""
    rows = [row for row in read(library / "spectra" / "compacted_soil.csv") if row[0] <= 14.5]

    def albedo(um):
        r = interpolate(rows, um)
        return 1.0 - ((1.0 - r) / (1.0 + r)) ** 2
    write(folder / "yard.csv", "Single-scattering albedo of the yard's soil", [
        "source: compacted_soil of Nadir's library (NPOESS land reflectance table in CRTM v3)",
        "licence: CC0-1.0 (JCSDA CRTM)",
        "made-by: tools/make_showcase.py from library spectra/compacted_soil.csv",
    ], {"albedo": albedo}, [row[0] for row in rows])


def night_sky(library: pathlib.Path, folder: pathlib.Path) -> None:
    """Moonlight scattered by the air: the day's sky times the moon's share of the sun's light."""
    day = read(library / "atmosphere" / "clear_sky_diffuse.csv")
    thermal = read(library / "atmosphere" / "clear_sky_thermal.csv")
    share = (1737.4 / 384400.0) ** 2 * 0.12

    def radiance(u):
        return interpolate(day, u) * share + 1e-6 if u < 2.5 else interpolate(thermal, u)
    title = "Sky of a moonlit night: scattered moonlight, airglow, thermal emission"
    write(folder / "night_sky.csv", title, [
        "source: clear_sky_diffuse.csv times the full moon's share of sunlight (2.4e-6), 1e-6 "
        "W m^-2 sr^-1 um^-1 of airglow and starlight, clear_sky_thermal.csv beyond 2.5 um",
        "licence: Apache-2.0", "made-by: tools/make_showcase.py",
    ], {"radiance": radiance}, [0.35 + 0.05 * k for k in range(14)] + [1.5, 2.5]
        + [row[0] for row in thermal if row[0] > 2.5])


def lamps(folder: pathlib.Path) -> None:
    """Diodes: a blue peak and a phosphor. Spectral flux of one lamp."""
    def diode(blue, centre):
        return lambda u: 0.0 if u > 0.85 else (
            blue * math.exp(-((u - 0.452) / 0.013) ** 2) + math.exp(-((u - centre) / 0.08) ** 2))

    shapes = {"street_lamp": (diode(0.35, 0.61), 4000.0), "ceiling": (diode(1.1, 0.575), 40000.0),
              "floodlight": (diode(0.5, 0.59), 26000.0), "beacon": (diode(0.9, 0.58), 9000.0)}
    grid = [0.36 + 0.005 * k for k in range(99)] + [0.86, 14.2]
    title = "Spectral flux of the lamps, W um^-1 in all directions together"
    write(folder / "lamps.csv", title, INVENTED + [
        "note: " + ", ".join(f"{name} {lumens:.0f} lm" for name, (_, lumens) in shapes.items())],
        {name: _scaled(*shape, grid) for name, shape in shapes.items()}, grid)


def _scaled(shape, lumens: float, grid: list):
    """683 lm/W times the integral of V(lambda) is the flux; V = 1.019 exp(-285 (u - 0.559)^2)."""
    def seen(u):
        return shape(u) * 1.019 * math.exp(-285.4 * (u - 0.559) ** 2)
    total = sum((b - a) * 0.5 * (seen(a) + seen(b)) for a, b in zip(grid, grid[1:]))
    return lambda u: shape(u) * lumens / (683.0 * total)


def street_ies(path: pathlib.Path) -> None:
    """A street luminaire: most light at 50 degrees from straight down, little beyond 65."""
    vertical = [0, 10, 20, 30, 40, 50, 55, 60, 65, 70, 75, 80, 85, 90]
    horizontal = [0, 30, 60, 90, 120, 150, 180]
    lines = ["IESNA:LM-63-2002", "[TEST] invented for this scene", "[MANUFAC] none", "TILT=NONE",
             f"1 6000 1 {len(vertical)} {len(horizontal)} 1 2 0.3 0.6 0.1", "1 1 90",
             " ".join(map(str, vertical)), " ".join(map(str, horizontal))]
    for h in horizontal:
        side = 0.4 + 0.6 * math.cos(math.radians(h)) ** 2
        if h > 90:
            side *= 0.55  # house side
        row = []
        for v in vertical:
            bat = 1.0 / math.cos(math.radians(min(v, 55))) ** 2
            row.append(round(700 * (side * bat if v > 20 else 1.0) * (1 - _edge(v, 58, 3))))
        lines.append(" ".join(map(str, row)))
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
