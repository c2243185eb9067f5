"""Reflectance spectra of surfaces and the material library that names them."""

import pathlib
from xml.sax.saxutils import quoteattr

from library import thermal
from library.surface_list import FRESNEL, MANMADE, NPOESS, STACKS
from library.tables import (SCRIPT, first_comment, interpolate, number, read_csv, thin_to,
                            window, write_spectrum)

RANGE_UM = (0.35, 14.0)
TOLERANCE = 5e-4  # of reflectance: a tenth of what the best of these measurements claim
MOST_ROWS = 300

JPL_NOTICE = ("Reproduced from the ECOSTRESS Spectral Library through the courtesy of the Jet "
              "Propulsion Laboratory, California Institute of Technology")
ECOSTRESS_LICENCE = (f"Originated by the US government; keep this notice: \"{JPL_NOTICE}\"")
MEDIUM = ("The source does not say whether its wavelengths are in air or in vacuum; taken as "
          "vacuum. "
          "The difference, 0.03 %, is below its sampling.")


def finish(output: pathlib.Path, name: str, curve: list, header: dict) -> None:
    """Takes a curve to the common range, thins it and writes it."""
    lo, hi = RANGE_UM
    clipped = sum(1 for _, y in curve if not 0.0 <= y <= 1.0)
    curve = [(x, min(1.0, max(0.0, y))) for x, y in sorted(curve)]
    full, held = window(curve, lo, hi)
    thinned, tolerance = thin_to(full, TOLERANCE, MOST_ROWS)
    notes = header.pop("note", [])
    if clipped:
        notes.append(f"{clipped} values outside [0, 1] were clipped.")
    write_spectrum(
        output / "spectra" / f"{name}.csv",
        {**header, "extended": held,
         "thinned": f"linear interpolation is within {tolerance:.1e} of the source's points",
         "note": notes},
        {"reflectance": [(x, round(y, 5)) for x, y in thinned]})


def base_header(title: str, source: str, licence: str, made_from: str, notes: list) -> dict:
    return {"title": title, "quantity": "reflectance", "unit": "1", "wavelength": "um, vacuum",
            "source": source, "licence": licence, "made-by": f"{SCRIPT} from {made_from}",
            "note": list(notes)}


def write_manmade(reference: pathlib.Path, output: pathlib.Path) -> list:
    index = {row["file"]: row for row in read_csv(reference / "surfaces_manmade" / "index.csv")}
    entries = []
    for name, (stem, description, notes) in MANMADE.items():
        file = next(f for f in index if stem in f)
        curve = [(float(r["wavelength_um"]), float(r["reflectance_percent"]) / 100.0)
                 for r in read_csv(reference / "surfaces_manmade" / file)]
        sample = index[file]["sample"]
        source = (f"Sample {sample}, US National Photographic Interpretation Center, directional "
                  "(10 "
                  "degree) hemispherical reflectance; ASTER/ECOSTRESS spectral library "
                  "(Baldridge et "
                  f"al. 2009, Meerdink et al. 2019). {JPL_NOTICE}")
        finish(output, name, curve,
               base_header(description, source, ECOSTRESS_LICENCE, f"surfaces_manmade/{file}",
                           [MEDIUM, *notes]))
        entries.append((name, description))
    return entries


def join(low: list, high: list, last_low_um: float, first_high_um: float) -> list:
    return [p for p in low if p[0] <= last_low_um] + [p for p in high if p[0] >= first_high_um]


def write_npoess(reference: pathlib.Path, output: pathlib.Path) -> list:
    file = "surfaces_npoess/npoess_land_reflectance.csv"
    rows = read_csv(reference / file)

    def read_class(name: str) -> list:
        return [(float(r["wavelength_um"]), float(r[name])) for r in rows]

    entries = []
    for name, (land_class, infrared, description, notes) in NPOESS.items():
        curve = read_class(land_class)
        classes = land_class
        if infrared:
            # 2.0 and 2.5 um are neighbours in the table: the join is one of its own steps.
            curve = join(curve, read_class(infrared), 2.0, 2.5)
            classes = f"{land_class} (to 2.0 um) and {infrared} (from 2.5 um)"
        source = (f"NPOESS land reflectance table, class {classes}, from the Community Radiative "
                  "Transfer Model (CRTM v3, IRVISlandCoeff)")
        finish(output, name, curve,
               base_header(description, source, "CC0-1.0 (JCSDA CRTM)", file,
                           [MEDIUM, "A value every 25 nm to 1 um, every 50 nm to 2 um, every 0.5 "
                                    "um "
                            "to 10 um, then every 1 um.", *notes]))
        entries.append((name, description))
    return entries


def fresnel_normal(n: float, k: float) -> float:
    """Reflectance of a smooth surface in air at normal incidence, the same for both
    polarisations: ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2) (Born & Wolf, section 14.2)."""
    return ((n - 1.0) ** 2 + k * k) / ((n + 1.0) ** 2 + k * k)


def write_fresnel(reference: pathlib.Path, output: pathlib.Path) -> list:
    entries = []
    for name, (stem, description, notes) in FRESNEL.items():
        file = f"optics_nk/{stem}.csv"
        curve = [(float(r["wavelength_um"]), fresnel_normal(float(r["n"]), float(r["k"])))
                 for r in read_csv(reference / file)]
        source = (f"Fresnel reflectance at normal incidence from the refractive index of "
                  f"{first_comment(reference / file)} (refractiveindex.info database)")
        finish(output, name, curve,
               base_header(description, source, "CC0-1.0", file,
                           ["Computed for a smooth, clean surface at normal incidence.", *notes]))
        entries.append((name, description))
    return entries


def attributes(values: dict) -> str:
    return "".join(f" {key}={quoteattr(v if isinstance(v, str) else number(v))}"
                   for key, v in values.items())


def heat_balance(name: str) -> list:
    """Lines of what lies beneath a surface; none where nothing usual does."""
    if name not in STACKS:
        return []
    layers, values, _ = STACKS[name]
    lines = [f"    <heat_balance{attributes(values)}>"]
    for substance, thickness_m in layers:
        deep = {} if thickness_m is None else {"thickness_m": thickness_m}
        lines.append(f"      <layer{attributes({'substance': substance, **deep})}/>")
    return [*lines, "    </heat_balance>"]


def write_materials(output: pathlib.Path, entries: list) -> None:
    lines = ['<?xml version="1.0" encoding="UTF-8"?>',
             "<!-- Materials that ship with Nadir. Written by tools/make_library.py; format:",
             "     docs/formats.md, sources and licences: the top of each spectrum and "
             "README.md;",
             "     what lies beneath the surfaces and why: docs/thermal-database.md. -->",
             "<materials>"]
    for name, description in entries:
        below = heat_balance(name)
        lines += [f"  <material name={quoteattr(name)}",
                  f"            description={quoteattr(description)}",
                  f"            reflectance={quoteattr(f'spectra/{name}.csv')}"
                  f"{'>' if below else '/>'}"]
        lines += [*below, "  </material>"] if below else []
    lines.append("</materials>")
    (output / "materials.xml").write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


def check_stacks(entries: list, substances: set) -> None:
    """Stacks belong to materials that ship and are made of substances that do."""
    unknown = set(STACKS) - {name for name, _ in entries}
    for layers, _, _ in STACKS.values():
        unknown |= {substance for substance, _ in layers} - substances
        unknown |= {substance for substance, depth in layers[:-1] if depth is None}
    if unknown:
        raise ValueError(f"stacks name what there is not: {', '.join(sorted(unknown))}")


def report(output: pathlib.Path, names: list) -> None:
    """Prints what a reader would check by eye: reflectance in the visible to shortwave infrared,
    emissivity in the thermal infrared."""
    for name in names:
        rows = read_csv(output / "spectra" / f"{name}.csv")
        curve = [(float(r["wavelength_um"]), float(r["reflectance"])) for r in rows]
        rho = " ".join(f"{interpolate(curve, x):.3f}" for x in (0.48, 0.56, 0.66, 0.86, 1.61, 2.2))
        eps = " ".join(f"{1.0 - interpolate(curve, x):.3f}" for x in (3.9, 8.5, 10.9, 12.0))
        print(f"  {name:28} rows {len(curve):3}  rho {rho}  eps {eps}")


def write(reference: pathlib.Path, output: pathlib.Path) -> None:
    entries = (write_npoess(reference, output) + write_fresnel(reference, output) +
               write_manmade(reference, output))
    check_stacks(entries, thermal.names(reference))
    write_materials(output, entries)
    print(f"surfaces: {len(entries)} materials; reflectance at 0.48 0.56 0.66 0.86 1.61 2.20 um, "
          "emissivity at 3.9 8.5 10.9 12.0 um")
    report(output, [name for name, _ in entries])
