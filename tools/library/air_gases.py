"""Absorption by the gases of the air, and standard profiles of the air.

The band model of LOWTRAN7 (Kneizys et al. 1988), laid out anew: runs of evenly spaced figures.
"""

import pathlib

from library.tables import SCRIPT, read_csv

SOURCE = ("LOWTRAN7 revision 4.2, block data (Kneizys et al. 1988, Users Guide to LOWTRAN 7, "
          "AFGL-TR-88-0177)")
LICENCE = "work of the US Air Force, public domain"
GASES = ["h2o", "co2", "o3", "n2o", "co", "ch4", "o2", "no", "so2", "no2", "nh3", "hno3"]


def short(text: str) -> str:
    """The shortest spelling of the same number."""
    value = float(text)
    return f"{value:.0f}" if value == int(value) and abs(value) < 1e6 else repr(value)


def header(kind: str, title: str, made_from: str, notes: list, source: str = SOURCE) -> list:
    lines = [f"# {kind}: 1"] if kind else []
    return lines + [f"# title: {title}", f"# source: {source}", f"# licence: {LICENCE}",
                    f"# made-by: {SCRIPT} from {made_from}", *[f"# note: {n}" for n in notes]]


def run(name: str, first: str, step: float, values: list) -> list:
    """One run: a line that says what it is, then its values, twelve a line."""
    lines = [f"run {name} {short(first)} {step:g} {len(values)}"]
    return lines + [" ".join(values[i:i + 12]) for i in range(0, len(values), 12)]


def even_runs(name: str, rows: list, step: float, value_columns: list) -> list:
    """Rows of (wavenumber, figures ...), cut where the grid is broken: one run a column and cut;
    the columns' names follow the run's."""
    lines, start = [], 0
    for i in range(1, len(rows) + 1):
        if i < len(rows) and abs(float(rows[i][0]) - float(rows[i - 1][0]) - step) < 1e-6:
            continue
        for column, label in enumerate(value_columns):
            lines += run(name + label, rows[start][0], step,
                         [short(r[column + 1]) for r in rows[start:i]])
        start = i
    return lines


def columns(path: pathlib.Path, *names: str) -> list:
    return [tuple(row[n] for n in names) for row in read_csv(path)]


def write_bands(folder: pathlib.Path, output: pathlib.Path) -> None:
    by_slot = {}
    for row in read_csv(folder / "band_cprime.csv"):
        by_slot.setdefault((row["molecule"].lower(), row["slot"]), []).append(
            (row["wavenumber_cm-1"], row["log10_cprime"]))
    lines = header("nadir-gas-runs", "Band model of the gases: log10 of the absorption coefficient",
                   "lowtran7/band_cprime.csv",
                   ["run GAS/SET FIRST STEP COUNT, wavenumbers in cm^-1, then the figures.",
                    "log10 C of T = exp(-(10^C W)^a), W the amount scaled as gas_sets.csv says, "
                    "g cm^-2 for water vapour, atm cm for the others; means over 20 cm^-1."])
    for (gas, slot), rows in by_slot.items():
        lines += even_runs(f"{gas}/{slot}", rows, 5.0, [""])
    (output / "gas_bands.txt").write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")
    print(f"gas bands: {sum(map(len, by_slot.values()))} figures in {len(by_slot)} sets")


def write_sets(folder: pathlib.Path, output: pathlib.Path) -> None:
    fits = {}
    for row in read_csv(folder / "exp_sum_10term.csv"):
        fits.setdefault(row["slot"], []).append((row["k"], row["weight"]))
    lines = header("", "Band model of the gases: sets of parameters",
                   "lowtran7/band_params.csv and exp_sum_10term.csv",
                   ["Amounts are scaled by (p/1013.25 hPa)^n (273.15 K/T)^m.",
                    "exp(-x^a) is the sum of w exp(-k x) over ten terms, within 3e-4: a fit to the "
                    "exponent a."])
    terms = range(1, 11)
    lines.append(",".join(["gas", "set", "a", "n", "m", *[f"k{i}" for i in terms],
                           *[f"w{i}" for i in terms]]))
    for row in read_csv(folder / "band_params.csv"):
        fit = fits[row["slot"]]
        cells = [row["molecule"].lower(), row["slot"], short(row["exponent_a"]),
                 short(row["pressure_exp_n"]), short(row["temperature_exp_m"]),
                 *[short(k) for k, _ in fit], *[short(w) for _, w in fit]]
        lines.append(",".join(cells))
    (output / "gas_sets.csv").write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


def write_continua(folder: pathlib.Path, output: pathlib.Path) -> None:
    lines = header("nadir-gas-runs", "Absorption of the gases that is smooth over wavelength",
                   "lowtran7/h2o_continuum.csv, n2_continuum.csv, o2_continuum.csv, hno3.csv, "
                   "o3_chappuis.csv, o3_huggins.csv, o3_hartley_uv.csv",
                   ["run NAME FIRST STEP COUNT, wavenumbers in cm^-1, then the figures.",
                    "h2o/self296, self260, foreign: 1e-20 cm^3 molecule^-1. n2: km^-1 of air at "
                    "1013.25 hPa, 273.15 K.",
                    "o2: strength, and its change with temperature by K^-1 and K^-2 from 220 K. "
                    "hno3, o3/visible, o3/far: (atm cm)^-1.",
                    "o3/c0, c1, c2: 0.269 c0 (1 + c1 t + c2 t^2) (atm cm)^-1 at t degrees C; "
                    "o3/far has the factor 0.269 already."])
    water = [r for r in columns(folder / "h2o_continuum.csv", "wavenumber_cm-1", "self_296K",
                                "self_260K", "foreign_296K") if float(r[0]) >= 0.0]
    lines += even_runs("h2o", water, 10.0, ["/self296", "/self260", "/foreign"])
    lines += even_runs("n2", columns(folder / "n2_continuum.csv", "wavenumber_cm-1",
                                     "coeff_km-1"), 5.0, ["/continuum"])
    lines += even_runs("o2", columns(folder / "o2_continuum.csv", "wavenumber_cm-1", "strength_S0",
                                     "A_per_K", "B_per_K2"), 5.0,
                       ["/strength", "/per_k", "/per_k2"])
    lines += even_runs("hno3", columns(folder / "hno3.csv", "wavenumber_cm-1",
                                       "coeff_per_atm_cm"), 5.0, ["/bands"])
    visible = [r for r in columns(folder / "o3_chappuis.csv", "wavenumber_cm-1",
                                  "coeff_per_atm_cm") if float(r[0]) <= 24200.0]
    lines += even_runs("o3", visible, 200.0, ["/visible"])
    lines += even_runs("o3", columns(folder / "o3_huggins.csv", "wavenumber_cm-1",
                                     "c0_per_atm_cm", "c1_per_K", "c2_per_K2"), 5.0,
                       ["/c0", "/c1", "/c2"])
    far = [(v, f"{0.269 * float(c):.6g}") for v, c in
           columns(folder / "o3_hartley_uv.csv", "wavenumber_cm-1", "coeff_per_atm_cm")
           if float(v) <= 50000.0]
    lines += even_runs("o3", far, 100.0, ["/far"])
    (output / "gas_continua.txt").write_text("\n".join(lines) + "\n", encoding="utf-8",
                                             newline="\n")


def write_profiles(folder: pathlib.Path, output: pathlib.Path) -> None:
    rows = read_csv(folder / "atmosphere_profiles.csv")
    lines = header("", "Six standard profiles of the air", "lowtran7/atmosphere_profiles.csv",
                   ["Volume mixing ratios in 1e-6 of the air. Carbon dioxide is that of 1986 "
                    "(330); it is scaled when read."],
                   "Anderson et al. 1986, AFGL Atmospheric Constituent Profiles (0-120 km), "
                   "AFGL-TR-86-0110, as in LOWTRAN7")
    lines.append(",".join(["profile", "height_m", "pressure_hpa", "temperature_k", *GASES]))
    for row in rows:
        gases = [short(row[f"{gas}_ppmv"]) for gas in GASES]
        lines.append(",".join([row["model"], short(str(float(row["altitude_km"]) * 1000.0)),
                               short(row["pressure_mb"]), short(row["temperature_K"]), *gases]))
    (output / "standard_profiles.csv").write_text("\n".join(lines) + "\n", encoding="utf-8",
                                                  newline="\n")


def write(reference: pathlib.Path, output: pathlib.Path) -> None:
    folder, target = reference / "lowtran7", output / "atmosphere"
    target.mkdir(parents=True, exist_ok=True)
    write_sets(folder, target)
    write_bands(folder, target)
    write_continua(folder, target)
    write_profiles(folder, target)
