"""What layers beneath surfaces are made of: conductivity, density, specific heat."""

import csv
import io
import math
import pathlib

from library.tables import SCRIPT, number, read_csv

REFERENCE = "thermal/material_thermal_properties.csv"
COLUMNS = ("substance", "conductivity_w_m_k", "density_kg_m3", "specific_heat_j_kg_k",
           "solar_absorptance", "emissivity", "checked", "source")
LICENCE = ("single figures from handbooks (facts, named row by row); selection and arrangement "
           "Apache-2.0")
NOTES = (
    "Conductivity, density and specific heat near 20 C (ice and snow: 0 C).",
    "solar_absorptance and emissivity are typical and for information: the heat balance takes "
    "those of the material's own spectra.",
    "checked: yes, the three figures were read again in the source named; partly, some of them; "
    "no, they are as commonly quoted from it; derived, computed from other rows as the source "
    "says.",
    "Densities, conductivities and heats of soils, wood and snow vary by a third and more from "
    "place to place: measure where it matters.")

# Vertical eddy diffusivity of the upper metre of lakes and ponds, m2 s-1: from 1e-5 in calm to 1e-2
# in storm (Imboden and Wuest 1995, in Physics and Chemistry of Lakes); mixes 1 m in 3 hours.
EDDY_M2_S = 1e-4
HALF = 0.5  # of the pores hold water


def moist(dry: dict, wet: dict, coarse: bool) -> list:
    """Conductivity, density and specific heat of a soil half of whose pores hold water.

    Heat capacities and masses of the parts add up. Conductivity: Johansen's Kersten number,
    k = k_dry + K (k_wet - k_dry), K = 1 + log10(S) for fine, 1 + 0.7 log10(S) for coarse grains.
    """
    rho = (1.0 - HALF) * dry["density"] + HALF * wet["density"]
    heat = ((1.0 - HALF) * dry["density"] * dry["heat"] + HALF * wet["density"] * wet["heat"])
    kersten = 1.0 + (0.7 if coarse else 1.0) * math.log10(HALF)
    k = dry["k"] + kersten * (wet["k"] - dry["k"])
    return [float(f"{x:.3g}") for x in (k, rho, heat / rho)]


def derived(rows: list) -> list:
    by_name = {r["material"]: {"k": float(r["conductivity_W_mK"]),
                               "density": float(r["density_kg_m3"]),
                               "heat": float(r["specific_heat_J_kgK"])} for r in rows}
    johansen = ("half of the pores filled, from the dry and the saturated row: Kersten number for "
                "{} grains by Johansen 1975 (Farouki 1981, CRREL Monograph 81-1)")
    water = by_name["water_still"]
    mixed_k = float(f"{EDDY_M2_S * water['density'] * water['heat']:.3g}")
    return [
        ["soil_sandy_moist", *moist(by_name["soil_sandy_dry"], by_name["soil_sandy_saturated"],
                                    True), 0.80, 0.94, "derived", johansen.format("coarse")],
        ["soil_clay_moist", *moist(by_name["soil_clay_dry"], by_name["soil_clay_saturated"],
                                   False), 0.80, 0.96, "derived", johansen.format("fine")],
        ["water_mixed", mixed_k, water["density"], water["heat"], 0.93, 0.985, "derived",
         "water_still with the conductivity of turbulent mixing: eddy diffusivity 1e-4 m2 s-1, "
         "from the range of Imboden and Wuest 1995 for a lake's surface layer"]]


def write(reference: pathlib.Path, output: pathlib.Path) -> None:
    rows = read_csv(reference / REFERENCE)
    table = [[r["material"], float(r["conductivity_W_mK"]), float(r["density_kg_m3"]),
              float(r["specific_heat_J_kgK"]), float(r["solar_absorptance"]),
              float(r["lwir_emissivity"]), r["checked"], r["source"]] for r in rows]
    table += derived(rows)
    text = io.StringIO()
    text.write("# title: Thermal properties of substances\n")
    text.write("# source: ASHRAE Handbook of Fundamentals 2005 ch. 30 (as in EnergyPlus' data "
               "set), Oke 1987, Incropera and DeWitt; each row names its own\n")
    text.write(f"# licence: {LICENCE}\n# made-by: {SCRIPT} from {REFERENCE}\n")
    text.writelines(f"# note: {note}\n" for note in NOTES)
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for row in table:
        writer.writerow([number(x) if isinstance(x, float) else x for x in row])
    (output / "thermal.csv").write_text(text.getvalue(), encoding="utf-8", newline="\n")
    print(f"thermal: {len(table)} substances")


def names(reference: pathlib.Path) -> set:
    """Of all substances that thermal.csv holds."""
    rows = read_csv(reference / REFERENCE)
    return {r["material"] for r in rows} | {row[0] for row in derived(rows)}
