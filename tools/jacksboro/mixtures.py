"""Vegetation as it grows here: mixtures by area of the library's published classes."""

import csv
import pathlib

from library import tables

# The published classes are few and coarse: broadleaf forest reflects less red than any leaf, and
# meadow grass, tabulated every 25 nm, already as much red as green within a sensor's red band.
# Real stands are neither pure nor closed; the mixtures are about as green as such places look.
MIXTURES = {
    "oak_leaves": {"broadleaf_forest": 0.72, "grass_on_soil": 0.19, "meadow_grass": 0.09},
    "bright_leaves": {"broadleaf_forest": 0.56, "meadow_grass": 0.30, "grass_on_soil": 0.14},
    "needles": {"pine_forest": 0.70, "broadleaf_forest": 0.30},
    "woodland": {"broadleaf_forest": 0.60, "pine_forest": 0.22, "grass_on_soil": 0.18},
    "meadow": {"broadleaf_forest": 0.46, "meadow_grass": 0.45, "grass_on_soil": 0.09},
    "lush": {"broadleaf_forest": 0.56, "meadow_grass": 0.40, "grass_on_soil": 0.04},
    "crop": {"broadleaf_forest": 0.72, "meadow_grass": 0.25, "grass_on_soil": 0.03},
    "dry_grass": {"meadow_grass": 0.50, "grass_on_soil": 0.30, "broadleaf_forest": 0.20},
}


def write(spectra: pathlib.Path, path: pathlib.Path) -> None:
    """`spectra` is the library's folder of reflectances."""
    classes = sorted({name for mixture in MIXTURES.values() for name in mixture})
    curves = {name: read_curve(spectra / f"{name}.csv") for name in classes}
    grid = sorted({x for curve in curves.values() for x, _ in curve})
    columns = {name: [(x, round(sum(share * tables.interpolate(curves[part], x)
                                    for part, share in mixture.items()), 4)) for x in grid]
               for name, mixture in MIXTURES.items()}
    recipes = [f"{name}: " + ", ".join(f"{100 * share:.0f} % {part}"
                                       for part, share in mixture.items())
               for name, mixture in MIXTURES.items()]
    tables.write_spectrum(path, {
        "title": "Vegetation of the demo place: mixtures by area of published classes",
        "quantity": "reflectance", "unit": "1", "wavelength": "um, vacuum",
        "source": "Nadir's library spectra " + ", ".join(classes)
                  + " (NPOESS land reflectance table in CRTM v3)",
        "licence": "CC0-1.0 (JCSDA CRTM)",
        "made-by": "tools/make_jacksboro.py from scenes/library/spectra",
        "note": ["The shares were chosen for this place by eye; they are not measured.", *recipes],
    }, columns)


def read_curve(path: pathlib.Path) -> list:
    """(um, value) pairs of a spectrum file with one column."""
    with path.open(encoding="utf-8", newline="") as file:
        rows = csv.reader(line for line in file if not line.startswith("#"))
        next(rows)
        return [(float(x), float(y)) for x, y in rows]
