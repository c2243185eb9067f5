"""Relative spectral responses of real sensors."""

import pathlib

from library.tables import SCRIPT, read_csv, write_spectrum

# 0.27 nm at 1 um: what an air wavelength would be off by, were the source's one.
MEDIUM = ("The source does not say whether its wavelengths are in air or in vacuum; taken as "
          "vacuum. The difference is 0.03 % of the wavelength, below the 1 nm sampling to 3 um.")
NASA = "Public domain (NASA/USGS data)"

LONG_FORM = {
    "landsat8_oli": ("Landsat 8 OLI relative spectral response, 9 bands", "srf/landsat8_oli.csv",
                     "NASA/USGS pre-launch band-average response; values below 1e-4 are left "
                     "out", NASA),
    "landsat9_oli2": ("Landsat 9 OLI-2 relative spectral response, 9 bands",
                      "srf/landsat9_oli2.csv",
                      "NASA/USGS pre-launch band-average response; values below 1e-4 are left "
                      "out", NASA),
    "landsat_thermal": ("Thermal bands of Landsat 4, 5, 7 (band 6) and 8 (TIRS band 10)",
                        "srf/landsat_thermal.csv",
                        "US Geological Survey response tables (LD01 Landsat surface temperature)",
                        "Public domain (USGS; Unlicense)"),
    "modis_aqua": ("MODIS on Aqua, in-band relative spectral response, 36 bands",
                   "srf/modis_aqua.csv",
                   "NASA MODIS Characterization Support Team, FM1 in-band files; mean over the "
                   "detectors of a band on a 1 nm grid (5 nm above 2.6 um), peak set to 1",
                   "Public domain (NASA data)"),
}

SENTINEL = ("Sentinel-2A MSI relative spectral response, 13 bands",
            "European Space Agency (ESA), S2-SRF, COPE-GSEG-EOPG-TN-15-0007",
            "ESA data, name ESA as the source; copy taken from an MIT-licensed repository "
            "(pyeosim); "
            "ESA's own terms for the table were not checked")


def stretches(curve: list) -> list:
    """Cuts a response where its source leaves out rows: at steps of more than 3.5 times both
    neighbouring ones."""
    steps = [b[0] - a[0] for a, b in zip(curve, curve[1:])]
    parts, first = [], 0
    for i, step in enumerate(steps):
        around = [steps[j] for j in (i - 1, i + 1) if 0 <= j < len(steps)]
        if step > 3.5 * max(around):
            parts.append(curve[first:i + 1])
            first = i + 1
    return [*parts, curve[first:]]


def drop_repeats(bands: dict) -> tuple:
    """Drops a stretch of a band that repeats, row by row, the rows of an earlier band (a slip of
    the source: Landsat 9's Cirrus, SWIR1 and SWIR2 carry those of NIR and of each other before
    their own). Also a note that names these bands."""
    seen, kept, names = [], {}, []
    for name, curve in bands.items():
        parts = [part for part in stretches(curve) if part not in seen]
        if len(parts) < len(stretches(curve)):
            names.append(name)
        seen += parts
        kept[name] = [p for part in parts for p in part]
    note = ("Rows of other bands that the source repeats were dropped from: "
            + ", ".join(names) + "." if names else "")
    return kept, note


def close_gaps(curve: list) -> tuple:
    """Where the source leaves out rows (its values there are negligible) the response is taken to
    zero one step from either side, so that no line is drawn across. Also the number of gaps."""
    parts = stretches(curve)
    closed = list(parts[0])
    for part in parts[1:]:
        before, after = closed[-1][0], part[0][0]
        step = min(closed[-1][0] - closed[-2][0], (after - before) / 3.0)
        closed += [(before + step, 0.0), (after - step, 0.0), *part]
    return closed, len(parts) - 1


def close_all(bands: dict) -> tuple:
    """All bands, and a note that names those with gaps."""
    closed = {name: close_gaps(curve) for name, curve in bands.items()}
    names = [name for name, (_, gaps) in closed.items() if gaps]
    note = ("Zeros stand on both sides of stretches that the source leaves out, in: "
            + ", ".join(names) + "." if names else "")
    return {name: curve for name, (curve, _) in closed.items()}, note


def long_form(path: pathlib.Path) -> dict:
    """Rows band, wavelength_nm, rsr as band -> curve in um."""
    bands = {}
    for row in read_csv(path):
        name = row["band"] if not row["band"].isdigit() else f"band_{row['band']}"
        bands.setdefault(name, []).append((float(row["wavelength_nm"]) * 1e-3, float(row["rsr"])))
    return {name: sorted(curve) for name, curve in bands.items()}


def wide_form(path: pathlib.Path) -> dict:
    """One column a band; the zeros on both sides of a response are left out."""
    rows = read_csv(path)
    bands = {}
    for name in [n for n in rows[0] if n != "wavelength_nm"]:
        curve = [(float(r["wavelength_nm"]) * 1e-3, float(r[name])) for r in rows]
        used = [i for i, p in enumerate(curve) if p[1] > 0.0]
        bands[name] = curve[used[0]:used[-1] + 1]
    return bands


def write_one(path: pathlib.Path, bands: dict, facts: tuple, made_from: str) -> None:
    title, source, licence = facts
    bands, repeats = drop_repeats(bands)
    bands, gaps = close_all(bands)
    write_spectrum(path, {"title": title, "quantity": "response", "unit": "1",
                          "wavelength": "um, vacuum", "source": source, "licence": licence,
                          "made-by": f"{SCRIPT} from {made_from}",
                          "note": [MEDIUM, "An empty cell: the band is not tabulated there.",
                                   repeats, gaps]},
                   bands)


def write(reference: pathlib.Path, output: pathlib.Path) -> None:
    for name, (title, file, source, licence) in LONG_FORM.items():
        write_one(output / "responses" / f"{name}.csv", long_form(reference / file),
                  (title, source, licence), file)
    file = "sensor/sentinel2a_msi_srf.csv"
    write_one(output / "responses" / "sentinel2a_msi.csv", wide_form(reference / file), SENTINEL,
              file)
    print(f"responses: {len(LONG_FORM) + 1} files")
