"""Sunlight at the ground on a clear day: what means over sunlight are weighted with."""

import pathlib
import subprocess

from library.tables import SCRIPT, integral, write_spectrum


def write(output: pathlib.Path, program: pathlib.Path) -> None:
    """`program` is bench/sunlight_at_ground, built: the air's light takes the simulator itself. It
    reads the tables of sun and air that were written before."""
    rows = subprocess.run([program, output], check=True, capture_output=True, text=True).stdout
    curve = [tuple(float(cell) for cell in row.split(",")) for row in rows.splitlines()]
    total = integral(curve)
    write_spectrum(
        output / "illumination" / "sunlight_at_ground.csv",
        {"title": "Sunlight on level ground, clear sky, air mass 1.5",
         "quantity": "irradiance", "unit": "W m^-2 um^-1", "wavelength": "um, vacuum",
         "source": ["Sun: illumination/solar.csv (TSIS-1 HSRS v2, ASTM E490-00a beyond 2.7 um)",
                    "Air: US standard atmosphere 1976 with 420 ppm of carbon dioxide, rural haze "
                    "of 23 km, LOWTRAN7's gases and particles (AFGL-TR-88-0177), discrete "
                    "ordinates; docs/clear-sky.md"],
         "licence": "Apache-2.0 (computed for Nadir from public-domain LOWTRAN7 figures; TSIS-1 "
                    "HSRS: NASA-funded, open with citation)",
         "made-by": f"{SCRIPT} by bench/sunlight_at_ground",
         "note": ["Direct and diffuse light, the sun at 1 au and 48.2 degrees from the zenith, "
                  "ground that reflects 0.2.",
                  "Means over bins of 10 nm to 1 um, 20 nm to 2.5 um, 50 nm to 4 um, given at the "
                  "bins' centres and held to the outer edges.",
                  f"Integral {total:.1f} W m^-2 over {curve[0][0]:g} to {curve[-1][0]:g} um."]},
        {"irradiance": curve})
    print(f"sunlight at the ground: {len(curve)} rows, integral {total:.1f} W m^-2")
