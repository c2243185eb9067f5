"""Haze and clouds: optics, heights and phase functions, in one file of tables."""

import math
import pathlib

from library.tables import SCRIPT, number, read_csv

HUMIDITIES = (0, 70, 80, 99)
# name of ours -> (name in the optics, name in the choice of phase functions)
HUMID = {"rural": ("rural", "rural"), "urban": ("urban", "urban"),
         "maritime": ("maritime_oceanic", "maritime"),
         "tropospheric": ("tropospheric", "tropospheric")}
DRY = {"fog_advection": ("fog_advective", "advective_fog"),
       "fog_radiation": ("fog_radiative", "radiation_fog"),
       "stratospheric": ("strat_background", "stratospheric"),
       "volcanic_aged": ("aged_volcanic", "aged_volcanic"),
       "volcanic_fresh": ("fresh_volcanic", "fresh_volcanic"),
       "meteoric_dust": ("meteoric_dust", "meteoric_dust")}
CLOUDS = {"cumulus": "cumulus", "altostratus": "altostratus", "stratus": "stratus",
          "stratocumulus": "stratocumulus", "nimbostratus": "nimbostratus",
          "cirrus": "cirrus_64um", "cirrus_thin": "cirrus_4um"}
SEASONS = {"spring_summer": ("springsummer", "ss"), "autumn_winter": ("fallwinter", "fw")}
VOLCANIC = {"background": "background", "moderate": "moderate_volcanic",
            "high": "high_volcanic", "extreme": "extreme_volcanic"}
UPPER = {"background": "upper_normal", "moderate": "upper_volcanic_to_normal",
         "extreme": "upper_volcanic_to_extreme"}
# A forward peak counts as one where the function at least doubles over the last two degrees.
PEAK = 2.0


def row(labels: list, values: list) -> str:
    return ",".join([*labels, *(number(v) for v in values)])


def kind_rows(optics: list, name: str, extinction: str, absorption: str, asymmetry: str) -> list:
    quantities = (("extinction", extinction), ("absorption", absorption), ("asymmetry", asymmetry))
    return [row([name, quantity], [float(r[column]) for r in optics])
            for quantity, column in quantities]


def optics_section(reference: pathlib.Path) -> list:
    """The row at 300 um is empty in the source and left out."""
    optics = [r for r in read_csv(reference / "aerosol_cloud_optics.csv")
              if float(r["wavelength_um"]) <= 200.0]
    lines = [row(["kind", "quantity"], [float(r["wavelength_um"]) for r in optics])]
    for name, (source, _) in HUMID.items():
        for rh in HUMIDITIES:
            lines += kind_rows(optics, f"{name}_{rh}",
                               *(f"{source}_{q}_rh{rh}" for q in ("ext", "abs", "g")))
    dry = {name: source for name, (source, _) in DRY.items()} | CLOUDS
    for name, source in dry.items():
        lines += kind_rows(optics, name, *(f"{source}_{q}" for q in ("ext", "abs", "g")))
    return lines


def haze_section(reference: pathlib.Path) -> list:
    rows = read_csv(reference / "aerosol_profiles.csv")
    lines = [row(["profile"], [float(r["altitude_km"]) for r in rows])]

    def add(name: str, column: str, above_km: float = -1.0) -> None:
        lines.append(row([name], [float(r[column]) if float(r["altitude_km"]) > above_km else 0.0
                                  for r in rows]))
    for visibility in (50, 23, 10, 5, 2):
        add(f"boundary_{visibility}", f"haze_vis{visibility}")
    for season, (long, short) in SEASONS.items():
        for visibility in (50, 23):
            add(f"tropospheric_{season}_{visibility}", f"trop_{long}_vis{visibility}")
        for state, column in VOLCANIC.items():
            add(f"stratospheric_{season}_{state}", f"strat_{column}_{short}")
    for state, column in UPPER.items():
        # at 30 km the source has both the stratosphere's figure and this one, which is the same:
        # the stratosphere keeps it, so that it counts once
        add(f"upper_{state}", column, 30.0)
    return lines


def panel(p0: float, p1: float, a: float, b: float) -> tuple:
    """2 pi int P sin and 2 pi int P sin cos over [a, b], ln P linear in the angle (midpoint)."""
    total = mean = 0.0
    steps = 400
    for k in range(steps):
        t = (k + 0.5) / steps
        angle = a + (b - a) * t
        p = p0 ** (1.0 - t) * p1 ** t * math.sin(angle) * 2.0 * math.pi * (b - a) / steps
        total += p
        mean += p * math.cos(angle)
    return total, mean


def normalised(values: list, angles: list) -> tuple:
    """The function with integral 1, its asymmetry, and what its integral was.

    The diffraction peak is narrower than the table's first step of 2 degrees, so straight lines
    there miss its light by up to the function's whole integral. Where there is a peak its value at
    0 degrees is set so that the integral is 1, all else being kept; elsewhere all is scaled."""
    panels = [panel(values[i], values[i + 1], angles[i], angles[i + 1])
              for i in range(len(angles) - 1)]
    before = sum(p[0] for p in panels)
    rest = sum(p[0] for p in panels[1:])
    flat = panel(values[1], values[1], angles[0], angles[1])[0]
    if values[0] > PEAK * values[1] and rest + flat < 1.0:
        low, high = math.log(values[1]), math.log(1e9)
        for _ in range(60):
            middle = 0.5 * (low + high)
            within = panel(math.exp(middle), values[1], angles[0], angles[1])[0]
            low, high = (middle, high) if within + rest < 1.0 else (low, middle)
        values = [math.exp(low), *values[1:]]
        panels[0] = panel(values[0], values[1], angles[0], angles[1])
    total = sum(p[0] for p in panels)
    return [v / total for v in values], sum(p[1] for p in panels) / total, before


def phase_sections(reference: pathlib.Path) -> tuple:
    """Lines of both sections, asymmetry by number, and how far the integrals were from 1."""
    table = read_csv(reference / "aerosol_phase_functions.csv")
    columns = [c for c in table[0] if c.startswith("deg")]
    degrees = [float(c[3:]) for c in columns]
    angles = [math.radians(d) for d in degrees]
    functions, asymmetry, off = [row(["number"], degrees)], {}, {}
    for r in table:
        values, g, before = normalised([float(r[c]) for c in columns], angles)
        key = int(r["phase_id"])
        functions.append(row([str(key)], values))
        asymmetry[key], off[key] = g, before - 1.0
    index = read_csv(reference / "aerosol_phase_index.csv")
    wavelengths = [c for c in index[0] if c.startswith("um")]
    choice = [row(["kind"], [float(c[2:]) for c in wavelengths])]
    chosen = {}
    names = {f"{n}_{rh}": f"{source}_rh{rh}"
             for n, (_, source) in HUMID.items() for rh in HUMIDITIES}
    names |= {n: source for n, (_, source) in DRY.items()}
    for name, source in names.items():
        r = next(r for r in index if r["aerosol"] == source)
        chosen[name] = [(float(c[2:]), int(r[c])) for c in wavelengths]
        choice.append(row([name], [k for _, k in chosen[name]]))
    return functions, choice, asymmetry, off, chosen


def check(optics: list, asymmetry: dict, chosen: dict) -> str:
    """Phase functions against the asymmetry of the optics, where particles matter most."""
    grid = [float(x) for x in optics[0].split(",")[2:]]
    worst, squares, count = (0.0, ""), 0.0, 0
    for line in optics[1:]:
        name, quantity, *values = line.split(",")
        if quantity != "asymmetry" or name not in chosen:
            continue
        for x, key in chosen[name]:
            if not 0.29 < x < 2.3:
                continue
            i = max(k for k, g in enumerate(grid) if g <= x + 1e-9)
            t = (x - grid[i]) / (grid[i + 1] - grid[i])
            g = float(values[i]) * (1.0 - t) + float(values[i + 1]) * t
            worst = max(worst, (abs(asymmetry[key] - g), f"{name} at {x:g} um"))
            squares, count = squares + (asymmetry[key] - g) ** 2, count + 1
    return (f"asymmetry of phase functions against that of the optics, 0.3 to 2 um: rms "
            f"{math.sqrt(squares / count):.3f}, at most {worst[0]:.3f} ({worst[1]})")


def write(reference: pathlib.Path, output: pathlib.Path) -> None:
    folder = reference / "lowtran7"
    optics = optics_section(folder)
    functions, choice, asymmetry, off, chosen = phase_sections(folder)
    agreement = check(optics, asymmetry, chosen)
    moved = sum(abs(d) > 0.02 for d in off.values())
    header = [
        "nadir-particles: 1",
        "title: Haze and clouds: optics, extinction by height, phase functions",
        "source: LOWTRAN7 (Kneizys et al., AFGL-TR-88-0177, 1988), block data of revision 4.2: "
        "haze of Shettle & Fenn (AFGL-TR-79-0214, 1979), clouds and fog as cited there",
        "licence: work of the US Air Force, public domain; this arrangement Apache-2.0",
        f"made-by: {SCRIPT} from lowtran7/aerosol_cloud_optics.csv, lowtran7/aerosol_profiles.csv, "
        "lowtran7/aerosol_phase_functions.csv, lowtran7/aerosol_phase_index.csv",
        "note: [optics] extinction and absorption over the extinction at 0.55 um, asymmetry, by "
        "vacuum wavelength in um; haze that takes up water by relative humidity in per cent.",
        "note: [haze] extinction at 0.55 um in km^-1 by height in km; boundary layer and "
        "troposphere by visibility in km. The upper air begins above 30 km.",
        "note: [phase_functions] sr^-1 by scattering angle in degrees, logarithm linear in "
        "between. Integral 1: where there is a forward peak its value at 0 degrees is set for "
        "that (the peak is narrower than the step of 2 degrees), elsewhere all are scaled. "
        f"{moved} of {len(off)} had an integral more than 2 % off.",
        "note: [phase_choice] number of the phase function by vacuum wavelength in um; kinds that "
        "are not there scatter by Henyey & Greenstein's with their asymmetry.",
        f"note: {agreement}."]
    lines = [f"# {line}" for line in header]
    for name, section in (("optics", optics), ("haze", haze_section(folder)),
                          ("phase_functions", functions), ("phase_choice", choice)):
        lines += [f"[{name}]", *section]
    path = output / "atmosphere" / "particles.txt"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")
    print(f"particles: {len(lines)} lines; {agreement}")
