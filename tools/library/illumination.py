"""Solar spectral irradiance at 1 AU."""

import pathlib

from library.tables import SCRIPT, bin_mean, integral, read_csv, write_spectrum

JOIN_UM = 2.7
# Total solar irradiance of ASTM E490 is 1366.1 W m^-2; 0.9965 takes it to the 1361.3 W m^-2 that
# today's radiometers measure (Kopp & Lean 2011, GRL 38, L01706).
E490_SCALE = 0.9965
# (to um, width of the bins): fine enough for multispectral bands, coarser where the sun is smooth.
BINS = [(1.0, 0.005), (2.7, 0.010), (4.0, 0.020), (8.0, 0.050), (20.0, 0.200)]
START_UM = 0.205


def solar_curve(reference: pathlib.Path) -> list:
    """HSRS to the join, scaled E490 beyond; (um, W m^-2 um^-1)."""
    hsrs = [(float(r["vacuum_wavelength_nm"]) * 1e-3, float(r["irradiance_W_m-2_nm-1"]) * 1e3)
            for r in read_csv(reference / "solar" / "tsis1_hsrs_v2_1nm.csv")]
    e490 = [(float(r["wavelength_um"]), float(r["irradiance_W_m-2_um-1"]) * E490_SCALE)
            for r in read_csv(reference / "solar" / "astm_e490_00a.csv")]
    return [p for p in hsrs if p[0] <= JOIN_UM] + [p for p in e490 if p[0] > JOIN_UM]


def binned(curve: list) -> list:
    """Means over the bins, at the bins' centres."""
    points, lo = [], START_UM
    for end, width in BINS:
        for i in range(round((end - lo) / width)):
            a = lo + i * width
            points.append((a + 0.5 * width, bin_mean(curve, a, a + width)))
        lo = end
    return points


def write(reference: pathlib.Path, output: pathlib.Path) -> list:
    full = solar_curve(reference)
    curve = binned(full)
    total = integral(curve)
    bins = ", ".join(f"{1000 * width:g} nm to {end:g} um" for end, width in BINS)
    write_spectrum(
        output / "illumination" / "solar.csv",
        {"title": "Solar spectral irradiance above the air at 1 AU",
         "quantity": "irradiance", "unit": "W m^-2 um^-1", "wavelength": "um, vacuum",
         "source": [f"To {JOIN_UM:g} um: TSIS-1 Hybrid Solar Reference Spectrum v2 (Coddington "
                    "et al. "
                    "2023, Earth and Space Science, LASP), means over 1 nm",
                    f"Beyond: ASTM E490-00a (as posted by NREL) times {E490_SCALE:g}, which "
                    "takes its "
                    "total of 1366.1 to 1361.3 W m^-2"],
         "licence": "TSIS-1 HSRS: NASA-funded, open with citation. ASTM E490: numbers publicly "
                    "posted "
                    "by NREL",
         "made-by": f"{SCRIPT} from solar/tsis1_hsrs_v2_1nm.csv and solar/astm_e490_00a.csv",
         "note": [f"Means over bins of {bins}, given at the bins' centres.",
                  f"Integral {total:.2f} W m^-2 over {curve[0][0]:g} to {curve[-1][0]:g} um.",
                  "Uncertainty 0.3 % in the visible and near infrared, up to 1.3 % elsewhere "
                  "(HSRS)."]},
        {"irradiance": curve})
    print(f"solar: {len(curve)} rows, integral {total:.2f} W m^-2 "
          f"({integral(full):.2f} before binning, whole E490 tail and far ultraviolet)")
    e490_overlap = [(float(r["wavelength_um"]), float(r["irradiance_W_m-2_um-1"]) * E490_SCALE)
                    for r in read_csv(reference / "solar" / "astm_e490_00a.csv")]
    ratio = bin_mean(e490_overlap, 2.5, 2.7) / bin_mean(full, 2.5, 2.7)
    print(f"solar: scaled E490 over HSRS at 2.5 to 2.7 um: {ratio:.4f}")
    return curve
