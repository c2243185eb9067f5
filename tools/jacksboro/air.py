"""The direct sun's transmittance for a low sun, from the library's for a high one."""

import math
import pathlib

from jacksboro.mixtures import read_curve
from library import tables

LIBRARY_ZENITH_DEG = 25.0  # scenes/library/README.md
SUN_ELEVATION_DEG = 30.0   # in day.xml


def write(atmosphere: pathlib.Path, path: pathlib.Path) -> None:
    """Beer's law: optical depth along the beam grows with the secant of the zenith angle."""
    ratio = math.cos(math.radians(LIBRARY_ZENITH_DEG)) / math.sin(math.radians(SUN_ELEVATION_DEG))
    curve = [(x, y**ratio) for x, y in read_curve(atmosphere / "clear_direct_transmittance.csv")]
    tables.write_spectrum(path, {
        "title": f"Transmittance of the clear air for a sun {SUN_ELEVATION_DEG:g} degrees high",
        "quantity": "transmittance", "unit": "1", "wavelength": "um, vacuum",
        "source": "Nadir's library, clear_direct_transmittance.csv (zenith angle "
                  f"{LIBRARY_ZENITH_DEG:g} degrees)",
        "licence": "Apache-2.0 (computed for Nadir)",
        "made-by": "tools/make_jacksboro.py from scenes/library/atmosphere",
        "note": f"The library's values to the power {ratio:.4f}, the ratio of the secants.",
    }, {"transmittance": curve})
