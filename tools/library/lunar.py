"""The moon's disc reflectance: coefficients of the ROLO model 311g."""

import pathlib

from library.tables import SCRIPT, read_csv, write_spectrum

NAMES = ["a0", "a1", "a2", "a3", "b1", "b2", "b3", "d1", "d2", "d3"]


def write(reference: pathlib.Path, output: pathlib.Path) -> None:
    rows = read_csv(reference / "lunar" / "rolo_311g_coefficients.csv")
    um = [float(r["wavelength_nm"]) * 1e-3 for r in rows]
    columns = {name: [(x, float(r[name])) for x, r in zip(um, rows)] for name in NAMES}
    columns["smoothing"] = [(x, float(r["apollo_scale"])) for x, r in zip(um, rows)]
    write_spectrum(
        output / "illumination" / "moon.csv",
        {"title": "Disc reflectance of the moon: coefficients of the ROLO model 311g",
         "quantity": "parameter", "unit": "1", "wavelength": "um, vacuum",
         "source": ["H. H. Kieffer and T. C. Stone, The Spectral Irradiance of the Moon, "
                    "Astron. J. 129, 2887 (2005), doi:10.1086/430185, table 4, US Geological "
                    "Survey"],
         "licence": "Published results of the US government",
         "made-by": f"{SCRIPT} from lunar/rolo_311g_coefficients.csv",
         "note": ["Equation 10 of the paper; the phase angle in radians for a, the sun's "
                  "selenographic longitude in radians for b; d as the paper has them. What all "
                  "bands share (c, p) stands with the equation in the program.",
                  "smoothing: factor that takes the band's reflectance to a smooth spectrum of "
                  "Apollo samples (95 % soil, 5 % breccia)."]},
        columns)
    print(f"moon: {len(rows)} bands, {um[0]:g} to {um[-1]:g} um")
