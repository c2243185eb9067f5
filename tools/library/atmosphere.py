"""Simple clear-sky inputs for a uniform atmosphere: Rayleigh air and an Angstrom aerosol.

No gas absorption in the scattered sunlight (no water vapour, ozone or carbon dioxide bands). The
air's own thermal emission comes from a LOWTRAN7 run.
"""

import math
import pathlib

from library.tables import SCRIPT, interpolate, read_csv, write_spectrum

SOLAR_ZENITH_DEG = 25.0
ANGSTROM_BETA = 0.06   # aerosol optical depth at 1 um
ANGSTROM_ALPHA = 1.3   # Angstrom's value for continental aerosol
AEROSOL_ALBEDO = 0.95  # single scattering
AEROSOL_ASYMMETRY = 0.70
AIR_SCALE_HEIGHT_KM = 8.4
AEROSOL_SCALE_HEIGHT_KM = 2.0
PATH_HEIGHT_KM = 1.5
DIFFUSIVITY = 1.66  # Elsasser: a hemisphere's flux is that of a slant path of secant 1.66


def rayleigh_depth(x: float) -> float:
    """Vertical Rayleigh optical depth of the air at 1013.25 mb, 360 ppm CO2, wavelength in um.

    Bodhaine et al. 1999 (J. Atmos. Oceanic Technol. 16, 1854), eq. 30, made for 0.25 to 0.85 um and
    good to 1 um. Beyond, where that fit levels off, wavelength^-4 from its value at 1 um.
    """
    if x > 1.0:
        return rayleigh_depth(1.0) / x**4
    numerator = 1.0455996 - 341.29061 / x**2 - 0.90230850 * x**2
    denominator = 1.0 + 0.0027059889 / x**2 - 85.968563 * x**2
    return 0.0021520 * numerator / denominator


def aerosol_depth(x: float) -> float:
    """Angstrom 1929: beta wavelength^-alpha, wavelength in um."""
    return ANGSTROM_BETA * x**-ANGSTROM_ALPHA


def delta_scaled(tau: float, omega: float, g: float) -> tuple:
    """Joseph, Wiscombe, Weinman 1976 (J. Atmos. Sci. 33, 2452): the forward peak, f = g^2, counts
    as unscattered."""
    f = g * g
    return (1.0 - omega * f) * tau, (1.0 - f) * omega / (1.0 - omega * f), (g - f) / (1.0 - f)


def two_stream(tau: float, omega: float, g: float, mu0: float) -> tuple:
    """Reflected, diffusely transmitted and directly transmitted fraction of a collimated beam over
    black ground: Eddington's two-stream, Meador & Weaver 1980 (J. Atmos. Sci. 37, 630), eqs. 14, 15
    and table 1."""
    omega = min(omega, 1.0 - 1e-9)  # the formulas for omega < 1 are stable to here
    g1 = 0.25 * (7.0 - omega * (4.0 + 3.0 * g))
    g2 = -0.25 * (1.0 - omega * (4.0 - 3.0 * g))
    g3 = 0.25 * (2.0 - 3.0 * g * mu0)
    g4 = 1.0 - g3
    a1, a2 = g1 * g4 + g2 * g3, g1 * g3 + g2 * g4
    k = math.sqrt(g1 * g1 - g2 * g2)
    if abs(1.0 - k * mu0) < 1e-6:  # removable singularity of both formulas
        mu0 *= 1.0 + 1e-5
    up, down, direct = math.exp(k * tau), math.exp(-k * tau), math.exp(-tau / mu0)
    scale = omega / ((1.0 - (k * mu0) ** 2) * ((k + g1) * up + (k - g1) * down))
    reflected = scale * ((1.0 - k * mu0) * (a2 + k * g3) * up
                         - (1.0 + k * mu0) * (a2 - k * g3) * down
                         - 2.0 * k * (g3 - a2 * mu0) * direct)
    diffuse = -direct * scale * ((1.0 + k * mu0) * (a1 + k * g4) * up
                                 - (1.0 - k * mu0) * (a1 - k * g4) * down
                                 - 2.0 * k * (g4 + a1 * mu0) / direct)
    return reflected, diffuse, direct


def sky(x: float, irradiance: float) -> tuple:
    """Radiance of a uniform dome with the diffuse irradiance of the clear sky, and the beam's
    transmittance with the aerosol's true (unscaled) extinction."""
    mu0 = math.cos(math.radians(SOLAR_ZENITH_DEG))
    air, aerosol = rayleigh_depth(x), aerosol_depth(x)
    scattered = air + AEROSOL_ALBEDO * aerosol
    tau, omega, g = delta_scaled(air + aerosol, scattered / (air + aerosol),
                                 AEROSOL_ASYMMETRY * AEROSOL_ALBEDO * aerosol / scattered)
    _, diffuse, direct_scaled = two_stream(tau, omega, g, mu0)
    direct = math.exp(-(air + aerosol) / mu0)
    diffuse += direct_scaled - direct  # the aureole belongs to the sky here
    return irradiance * mu0 * diffuse / math.pi, direct


def path(x: float, irradiance: float) -> tuple:
    """Singly scattered sunlight and transmittance between the ground and a sensor PATH_HEIGHT_KM
    above it that looks straight down. Chandrasekhar 1950, section 24: reflection by a thin layer,
    L = E / (4 pi) omega p(Theta) mu0 / (mu + mu0) (1 - exp(-tau (1 / mu + 1 / mu0)))."""
    mu0 = math.cos(math.radians(SOLAR_ZENITH_DEG))
    air, aerosol = rayleigh_depth(x), aerosol_depth(x)
    air_below = air * (1.0 - math.exp(-PATH_HEIGHT_KM / AIR_SCALE_HEIGHT_KM))
    aerosol_below = aerosol * (1.0 - math.exp(-PATH_HEIGHT_KM / AEROSOL_SCALE_HEIGHT_KM))
    tau = air_below + aerosol_below
    cos_scatter = -mu0  # sun at zenith angle theta, view from above: Theta = 180 degrees - theta
    g = AEROSOL_ASYMMETRY
    rayleigh = 0.75 * (1.0 + cos_scatter**2)
    henyey = (1.0 - g * g) / (1.0 + g * g - 2.0 * g * cos_scatter) ** 1.5
    omega_p = (air_below * rayleigh + AEROSOL_ALBEDO * aerosol_below * henyey) / tau
    above = math.exp(-(air + aerosol - tau) / mu0)
    thin = (1.0 - math.exp(-tau * (1.0 + 1.0 / mu0))) * mu0 / (1.0 + mu0)
    return irradiance * above / (4.0 * math.pi) * omega_p * thin, math.exp(-tau)


def grid() -> list:
    """0.3 to 14 um: 5 nm where the sky is blue, coarser where it is nearly black."""
    fine = [0.30 + 0.005 * i for i in range(140)]
    middle = [1.00 + 0.02 * i for i in range(85)]
    return fine + middle + [2.7 + 0.1 * i for i in range(13)] + [4.0 + 0.25 * i for i in range(41)]


def bin_irradiance(solar: list, grid_um: list) -> dict:
    """Solar irradiance at each grid point, as the mean of the tabulated means about it."""
    result = {}
    for i, x in enumerate(grid_um):
        lo = 0.5 * (x + grid_um[max(0, i - 1)])
        hi = 0.5 * (x + grid_um[min(len(grid_um) - 1, i + 1)])
        near = [y for s, y in solar if lo <= s <= hi]
        near = near or [min(solar, key=lambda p: abs(p[0] - x))[1]]
        result[x] = sum(near) / len(near)
    return result


def header(title: str, quantity: str, unit: str, notes: list) -> dict:
    return {
        "title": title, "quantity": quantity, "unit": unit, "wavelength": "um, vacuum",
        "source": "Computed: Rayleigh optical depth of Bodhaine et al. 1999 (1013.25 mb; "
                  "wavelength^-4 "
                  f"beyond 1 um) and an aerosol of optical depth {ANGSTROM_BETA:g} "
                  f"wavelength^-{ANGSTROM_ALPHA:g} (Angstrom), single scattering albedo "
                  f"{AEROSOL_ALBEDO:g}, asymmetry {AEROSOL_ASYMMETRY:g}; sun of "
                  "illumination/solar.csv "
                  f"at zenith angle {SOLAR_ZENITH_DEG:g} degrees, 1 AU",
        "licence": "Apache-2.0 (computed for Nadir); sunlight as in illumination/solar.csv",
        "made-by": f"{SCRIPT} from solar/tsis1_hsrs_v2_1nm.csv and solar/astm_e490_00a.csv",
        "note": [*notes, "No gas absorption: no water vapour, ozone or carbon dioxide bands."]}


def check(reference: pathlib.Path) -> None:
    """The Rayleigh depth against the reference table, the two-stream against conservation."""
    table = read_csv(reference / "validation" / "rayleigh_optical_depth.csv")
    worst = max(abs(rayleigh_depth(float(r["wavelength_um"])) / float(r["lowtran7_us_std"]) - 1.0)
                for r in table)
    print(f"atmosphere: Rayleigh depth within {100 * worst:.2f} % of the reference table")
    kept = max(abs(sum(two_stream(t, 1.0, g, mu)) - 1.0)
               for t in (0.01, 0.3, 2.0) for g in (0.0, 0.7) for mu in (0.3, 0.9))
    if worst > 0.02 or kept > 1e-4:
        raise ValueError(f"atmosphere: Rayleigh off by {worst:g}, two-stream loses {kept:g}")


def thermal_curve(reference: pathlib.Path) -> list:
    """Downwelling thermal radiance at the ground, 0.3 to 14 um, of the uniform dome that gives the
    sky's irradiance: at secant 1.66, linearly between LOWTRAN's secants 1 and 2."""
    curve = []
    for r in read_csv(reference / "lowtran7_reference" / "thermal_radiance.csv"):
        zenith, slant = float(r["therm_down_mls_L"]), float(r["therm_down_mls_60_L"])
        curve.append((1e4 / float(r["wavenumber_cm-1"]),
                      zenith + (slant - zenith) * (DIFFUSIVITY - 1.0)))
    return [(0.3, 0.0), (2.5, 0.0), *sorted(p for p in curve if 3.0 < p[0] <= 14.3)]


def thermal_header(title: str, source: str, licence: str, made_from: str, notes: list) -> dict:
    return {
        "title": title, "quantity": "radiance", "unit": "W m^-2 sr^-1 um^-1",
        "wavelength": "um, vacuum", "source": source, "licence": licence,
        "made-by": f"{SCRIPT} from {made_from}",
        "extended": "thermal emission from 0.3 to 2.5 um by 0, then linearly to LOWTRAN's first "
                    "value at "
                    "3.01 um (a black body at 294 K has 0.004 W m^-2 sr^-1 um^-1 at 2.5 um)",
        "note": [*notes, "Thermal emission taken at secant 1.66 (Elsasser's diffusivity factor), "
                 "linearly between 1 and 2: the uniform dome whose irradiance is the sky's."]}


def write_thermal(reference: pathlib.Path, output: pathlib.Path, diffuse: list) -> None:
    thermal = thermal_curve(reference)
    lowtran = ("LOWTRAN7 run (AFGL-TR-88-0177), mid-latitude summer, no aerosol, downwelling at "
               "the "
               "ground at zenith angles 0 and 60 degrees")
    licence = "Apache-2.0 (computed for Nadir with public-domain LOWTRAN7)"
    table = "lowtran7_reference/thermal_radiance.csv"
    write_spectrum(
        output / "atmosphere" / "clear_sky_thermal.csv",
        thermal_header("Thermal emission of a clear mid-latitude summer sky, uniform over the dome",
                       lowtran, licence, table, ["A clear night's sky, without stars and "
                                                 "airglow."]),
        {"radiance": thermal})
    grid_um = sorted({x for x, _ in diffuse} | {x for x, _ in thermal if x <= 14.0})
    total = [(x, interpolate(diffuse, x) + interpolate(thermal, x)) for x in grid_um]
    write_spectrum(
        output / "atmosphere" / "clear_sky_day.csv",
        thermal_header("Clear sky by day: scattered sunlight and thermal emission, uniform over "
                       "the "
                       "dome", f"Sum of clear_sky_diffuse.csv and clear_sky_thermal.csv. {lowtran}",
                       licence, table, ["Gases absorb in the thermal part only."]),
        {"radiance": total})
    print(f"atmosphere: thermal sky {len(thermal)} rows, at 3.01 um {thermal[2][1]:.2g}")


def write(reference: pathlib.Path, output: pathlib.Path, solar: list) -> None:
    check(reference)
    x_um = grid()
    irradiance = bin_irradiance(solar, x_um)
    radiance, transmittance, path_radiance, path_transmittance = [], [], [], []
    for x in x_um:
        dome, direct = sky(x, irradiance[x])
        scattered, passed = path(x, irradiance[x])
        radiance.append((x, dome))
        transmittance.append((x, direct))
        path_radiance.append((x, scattered))
        path_transmittance.append((x, passed))
    folder = output / "atmosphere"
    per_um = "W m^-2 sr^-1 um^-1"
    slant = (f"Between the ground and a sensor {PATH_HEIGHT_KM:g} km above that looks straight "
             "down; air "
             f"and aerosol fall off with {AIR_SCALE_HEIGHT_KM:g} and {AEROSOL_SCALE_HEIGHT_KM:g} "
             "km.")
    write_spectrum(folder / "clear_sky_diffuse.csv", header(
        "Scattered sunlight of a clear sky by day, uniform over the dome", "radiance", per_um,
        ["Diffuse irradiance over pi. Delta-Eddington two-stream (Joseph et al. 1976, Meador & "
         "Weaver "
         "1980) over black ground; the aureole that delta scaling counts as direct is given back "
         "to the sky.", "The air's own emission is not in it: see clear_sky_thermal.csv."]),
        {"radiance": radiance})
    write_spectrum(folder / "clear_direct_transmittance.csv", header(
        "Transmittance of the clear air for the direct sun", "transmittance", "1",
        ["exp(-tau / cos(solar zenith angle))."]), {"transmittance": transmittance})
    write_spectrum(folder / "clear_path_radiance.csv", header(
        "Sunlight scattered into a short vertical path", "radiance", per_um,
        ["Single scattering by a thin layer (Chandrasekhar 1950, section 24), Rayleigh and "
         "Henyey-Greenstein phase functions, black ground.", slant]), {"radiance": path_radiance})
    write_spectrum(folder / "clear_path_transmittance.csv", header(
        "Transmittance of a short vertical path", "transmittance", "1", ["exp(-tau).", slant]),
        {"transmittance": path_transmittance})
    write_thermal(reference, output, radiance)
