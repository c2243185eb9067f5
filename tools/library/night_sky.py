"""The moonless night sky: airglow, stars and zodiacal light, and a suburb's glow."""

import math
import pathlib

from library.tables import SCRIPT, bin_mean, integral, interpolate, read_csv, write_spectrum

# Light of 1 erg s^-1 cm^-2 A^-1 arcsec^-2, in W m^-2 sr^-1 um^-1.
ARCSEC_SR = (math.pi / 180.0 / 3600.0) ** 2
UNIT = 1e-7 * 1e4 * 1e4 / ARCSEC_SR
# Broad-band brightness of the zenith on a moonless night, mag arcsec^-2: mean over all year and all
# night of the Cerro Paranal sky model at a solar radio flux of 130 (its calculator, version 1.4.3;
# Noll et al. 2012, A&A 543, A92; Jones et al. 2013, A&A 560, A91), and its night-to-night spread.
SKY = {"U": (22.09, 0.37), "B": (22.78, 0.24), "V": (21.83, 0.95), "R": (21.06, 0.94),
       "I": (19.74, 0.39), "Z": (18.76, 0.45), "Y": (17.61, 0.57), "J": (16.87, 0.78),
       "H": (14.42, 0.89), "K": (15.25, 1.00)}
# Effective wavelength in um and flux of magnitude 0 in erg s^-1 cm^-2 A^-1. UBVRIJHK: Bessell,
# Castelli & Plez 1998, A&A 333, 231, table A2. Z and Y: AB offsets 0.528 and 0.634 of Hewett et al.
# 2006, MNRAS 367, 454, with 3631 Jy.
ZERO = {"U": (0.366, 417.5e-11), "B": (0.438, 632.0e-11), "V": (0.545, 363.1e-11),
        "R": (0.641, 217.7e-11), "I": (0.798, 112.6e-11), "J": (1.22, 31.47e-11),
        "H": (1.63, 11.38e-11), "K": (2.19, 3.961e-11)}
AB_OFFSET = {"Z": (0.8817, 0.528), "Y": (1.0305, 0.634)}
LIGHT = 2.99792458e18  # Angstrom s^-1
# Bands that OH fills evenly: the band's figure is held from edge to edge, not put on a point.
PLATEAU = {"J": (1.17, 1.33), "H": (1.50, 1.78), "K": (2.00, 2.27)}
DARK_UM = 2.45  # OH's sequence of overtones has ended; the fundamental begins at 2.8 um
END_UM = 20.0   # zeros to here, so that the files cover every sensor
V_UM = 0.545
SUBURB_V = 19.5
LAMP_K = 3000.0
C2 = 14387.768775  # um K


def zero_point(band: str) -> tuple:
    if band in ZERO:
        return ZERO[band]
    um, offset = AB_OFFSET[band]
    return um, 3631e-23 * 10.0 ** (-0.4 * offset) * LIGHT / (um * 1e4) ** 2


def radiance(band: str, magnitude: float) -> float:
    """W m^-2 sr^-1 um^-1 of a magnitude per square arc second."""
    return zero_point(band)[1] * 10.0 ** (-0.4 * magnitude) * UNIT


def levels(reference: pathlib.Path) -> dict:
    rows = read_csv(reference / "nightsky" / "night_sky_levels.csv")
    return {r["component"]: float(r["level"]) for r in rows if r["band"] == "V"}


def reddened_sun(solar: list, um: float) -> float:
    """Sunlight from interplanetary dust at 90 degrees from the sun, on any scale: Leinert et al.
    1998, A&AS 127, 1, eq. 22. Means over 0.04 um: stars do not share the sun's lines."""
    slope = 0.9 if um < 0.5 else 0.6
    return bin_mean(solar, um - 0.02, um + 0.02) * (1.0 + slope * math.log10(um / 0.5))


def starlight_curve(solar: list, v_radiance: float) -> list:
    grid = [0.28 + 0.02 * i for i in range(62)] + [1.55 + 0.05 * i for i in range(18)]
    scale = v_radiance / reddened_sun(solar, V_UM)
    curve = [(x, scale * reddened_sun(solar, x)) for x in grid]
    return curve + [(DARK_UM, 0.0), (END_UM, 0.0)]


def airglow_curve(starlight: list, v_magnitude: float) -> list:
    """What the sky model has over the starlight, dimmed all alike to the wanted V."""
    shift = v_magnitude - SKY["V"][0]
    points = []
    for band, (magnitude, _) in SKY.items():
        um = zero_point(band)[0]
        value = radiance(band, magnitude + shift) - interpolate(starlight, um)
        points += [(x, value) for x in PLATEAU.get(band, (um,))]
    points.sort()
    if min(v for _, v in points) <= 0.0:
        raise ValueError("night sky: starlight exceeds the sky")
    return [(0.28, points[0][1]), *points, (DARK_UM, 0.0), (END_UM, 0.0)]


def lamp_curve(v_radiance: float) -> list:
    """Black body between 0.40 and 0.70 um, fading to nothing at 0.38 and 0.80 um."""
    def body(um: float) -> float:
        fade = min(1.0, (um - 0.38) / 0.02, (0.80 - um) / 0.10)
        return max(fade, 0.0) / (um ** 5 * math.expm1(C2 / (um * LAMP_K)))
    grid = [0.38 + 0.01 * i for i in range(43)]
    scale = v_radiance / body(V_UM)
    return [(0.28, 0.0), *((x, scale * body(x)) for x in grid), (END_UM, 0.0)]


def header(title: str, source: list, licence: str, files: str, notes: list) -> dict:
    return {"title": title, "quantity": "radiance", "unit": "W m^-2 sr^-1 um^-1",
            "wavelength": "um, vacuum", "source": source, "licence": licence,
            "made-by": f"{SCRIPT} from {files}", "note": notes}


def write(reference: pathlib.Path, output: pathlib.Path, solar: list) -> None:
    level = levels(reference)
    share = {k: level[f"{k}_fraction"] for k in ("airglow", "zodiacal", "starlight_scattered")}
    stars_share = 1.0 - share["airglow"] / sum(share.values())
    v_magnitude = level["dark_zenith_sky_V"]
    v_sky = radiance("V", v_magnitude)
    stars = starlight_curve(solar, stars_share * v_sky)
    glow = airglow_curve(stars, v_magnitude)
    town = lamp_curve(radiance("V", SUBURB_V) - v_sky)
    folder = output / "illumination"
    table = "nightsky/night_sky_levels.csv"
    spread = ", ".join(f"{band} {d:g}" for band, (_, d) in SKY.items())
    level_note = (f"With the other file of the pair V = {v_magnitude:g} mag arcsec^-2 "
                  f"({v_sky:.3g} W m^-2 sr^-1 um^-1 at {V_UM:g} um) in the zenith, of which "
                  f"{100 * (1 - stars_share):.0f} % airglow; zero points of Bessell et al. 1998.")
    zero_note = (f"0 beyond {DARK_UM:g} um: the air's own thermal emission is brighter there "
                 "than OH's fundamental.")
    facts = "published facts; this arrangement Apache-2.0"
    write_spectrum(folder / "night_airglow.csv", header(
        "Airglow of a moonless night, zenith",
        ["Broad-band brightness U to K of the Cerro Paranal sky model (Noll et al. 2012, A&A 543, "
         "A92; Jones et al. 2013, A&A 560, A91; calculator version 1.4.3), mean over year and "
         "night at solar flux 130, less night_starlight.csv",
         "Zero points: Bessell, Castelli & Plez 1998, A&A 333, 231; Z and Y: Hewett et al. 2006, "
         "MNRAS 367, 454"], facts, table,
        [level_note, f"The sky model's own spread from night to night in mag: {spread}.",
         "Straight lines between bands; J, H and K are held over their OH bands. Lines (557.7, "
         "630 nm, OH's) are spread over their band. K holds some thermal emission of the air.",
         zero_note]), {"radiance": glow})
    write_spectrum(folder / "night_starlight.csv", header(
        "Zodiacal light and scattered starlight, zenith",
        ["Level in V: 75 of 220 S10 (night sky summary). Spectrum: illumination/solar.csv, "
         "reddened as interplanetary dust at 90 degrees from the sun (Leinert et al. 1998, A&AS "
         "127, 1, eq. 22)"],
        "sunlight as in illumination/solar.csv; level: published facts", f"{table}, solar/tsis1_hsrs_v2_1nm.csv",
        [level_note, "Zodiacal light varies by a factor of 3 over the sky, starlight by 10; both "
         "are even here. Starlight (a fifth of this) has the colour of the dust.",
         zero_note]), {"radiance": stars})
    write_spectrum(folder / "night_suburban_glow.csv", header(
        "Glow of a suburb's lamps, zenith, seen from the ground",
        [f"Level: a sky of V = {SUBURB_V:g} mag arcsec^-2 less the natural one of "
         f"{v_magnitude:g}. Shape: black body of {LAMP_K:g} K (warm white) from 0.40 to 0.70 um, "
         "linearly to 0 at 0.38 and 0.80 um: street lamps emit little beyond"],
        "Apache-2.0 (computed for Nadir)", table,
        ["An example: lamps differ from town to town. Give a spectrum of your own for a known "
         "one. Scattering's blue tinge and the lamps' lines are not in it."]), {"radiance": town})
    swir = [p for p in glow if 1.4 <= p[0] <= 1.8]
    print(f"night sky: airglow {len(glow)} rows, V {v_sky:.3g}, airglow at 0.55, 0.8, 1.6 um "
          f"{interpolate(glow, 0.55):.3g} {interpolate(glow, 0.8):.3g} {interpolate(glow, 1.6):.3g}; "
          f"1.4 to 1.8 um {integral(swir):.3g} W m^-2 sr^-1; CTIO V in the figures 2.92e-06")
