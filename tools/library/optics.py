"""Complex refractive indices of metals, minerals, water, ice and glass."""

import pathlib

from library.tables import SCRIPT, first_comment, read_csv, write_spectrum

RANGE_UM = (0.29, 14.2)  # a little beyond 0.3 to 14 um, so that every band is inside

FILM = "An opaque, smooth, clean film. Oxide, dirt and cold-worked surfaces reflect less."
# name: (file, title, notes)
CONSTANTS = {
    "aluminium": ("aluminium_rakic_1995", "Aluminium", [
        FILM + " Without the oxide that grows on it in air."]),
    "chromium": ("chromium_rakic_bb", "Chromium", [
        "The Brendel-Bormann model that the paper fits to measurements."]),
    "copper": ("copper_querry", "Copper", []),
    "gold": ("gold_olmon_evap_2012", "Gold, evaporated", [FILM]),
    "hematite": ("hematite_querry_o", "Hematite (iron oxide), ordinary ray", []),
    "ice": ("ice_warren_brandt_2008", "Ice, 266 K", []),
    "iron": ("iron_querry", "Iron", []),
    "nickel": ("nickel_ordal", "Nickel", []),
    "silver": ("silver_yang_2015", "Silver", [FILM]),
    "soda_lime_glass": ("soda_lime_glass_rubin_ir_1985", "Soda lime glass (window panes)", [
        "From 5 um only, where panes are opaque. For a clear pane in sunlight give n = 1.52."]),
    "titanium": ("titanium_ordal", "Titanium", []),
    "water": ("water_segelstein_1981", "Water", [
        "Pure. Sea water has an n 0.006 higher in sunlight."]),
}


def read(path: pathlib.Path) -> dict:
    """Columns n and k in the range, with the neighbours outside of it."""
    rows = [(float(r["wavelength_um"]), float(r["n"]), float(r["k"])) for r in read_csv(path)]
    lo, hi = RANGE_UM
    first = max((i for i, r in enumerate(rows) if r[0] <= lo), default=0)
    last = min((i for i, r in enumerate(rows) if r[0] >= hi), default=len(rows) - 1)
    rows = rows[first:last + 1]
    if any(n <= 0.0 or k < 0.0 for _, n, k in rows):
        raise ValueError(f"{path.name}: an index is not that of a passive medium")
    return {"n": [(x, n) for x, n, _ in rows], "k": [(x, k) for x, _, k in rows]}


def write(reference: pathlib.Path, output: pathlib.Path) -> None:
    for name, (stem, title, notes) in CONSTANTS.items():
        file = f"optics_nk/{stem}.csv"
        columns = read(reference / file)
        write_spectrum(
            output / "optics" / f"{name}.csv",
            {"title": f"{title}: complex refractive index", "quantity": "refractive_index",
             "unit": "1", "wavelength": "um, vacuum",
             "source": f"{first_comment(reference / file)} (refractiveindex.info database)",
             "licence": "CC0-1.0", "made-by": f"{SCRIPT} from {file}", "note": notes},
            columns)
        grid = [x for x, _ in columns["n"]]
        print(f"optics: {name:16} {len(grid):3} rows, {grid[0]:g} to {grid[-1]:g} um")
