#!/usr/bin/env python3
"""Writes the geometry of the demo place scenes/jacksboro/ from a folder of reference figures.

    tools/make_jacksboro.py REFERENCE_DIR [--output scenes/jacksboro]

Python's standard library only; the same input gives the same bytes. Vegetation and air
are derived from the spectra in scenes/library/ (tools/make_library.py). The scenarios beside the
geometry (day.xml, night.xml) are written by hand.
"""

import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from jacksboro import (air, buildings, cover, forest, layout, mixtures, # noqa: E402
                       raster, trees)
from jacksboro.ground import Ground  # noqa: E402

# North-west corner and size of the cut, in posts of the source: 10 x 10 km, the village in its
# south-east, so that the view to the north-west ends on mountains and not on an edge.
FIRST_COLUMN, FIRST_ROW, COLUMNS, ROWS, FACTOR = 135, 91, 405, 324, 3
QUANTUM_M = 1.0 / 16.0


def make_terrain(reference_dir: pathlib.Path, output: pathlib.Path) -> raster.Grid:
    source = raster.read_geotiff(reference_dir / "terrain" / "jacksboro_dem.tif")
    west = source.west_deg + FIRST_COLUMN * source.step_deg
    north = source.north_deg - FIRST_ROW * source.step_deg
    grid = raster.refine(source, west, north, COLUMNS, ROWS, FACTOR)
    raster.round_heights(grid, QUANTUM_M)
    raster.write_geotiff(output / "terrain.tif", grid, "Jacksboro fault, Tennessee: height in m", {
        "SOURCE": "US Geological Survey elevation at 3 arc seconds, as in matplotlib's sample data",
        "LICENCE": "public domain (US government)",
        "PROCESSING": "cut out and resampled to 1 arc second (cubic B-spline on level ground, "
                      "Catmull-Rom on steep ground), rounded to 1/16 m; no detail was added",
        "MADE_BY": "tools/make_jacksboro.py",
    })
    return grid


def write_list(path: pathlib.Path, rows: list) -> None:
    """Rows of east, north, yaw, scale; they stand on the terrain."""
    lines = ["east_m,north_m,yaw_deg,scale"]
    lines += [f"{east:.1f},{north:.1f},{yaw:.0f},{scale:.2f}" for east, north, yaw, scale in rows]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def make_buildings(plan: layout.Plan, output: pathlib.Path) -> dict:
    kinds = {"cottage": buildings.cottage(), "farmhouse": buildings.farmhouse(),
             "ranch": buildings.ranch(), "shed": buildings.shed(), "barn": buildings.barn(),
             "church": buildings.church()}
    for name, mesh in kinds.items():
        what = getattr(buildings, name).__doc__.splitlines()[0]
        mesh.write(output / f"{name}.obj", what)
    for style in layout.STYLES:
        write_list(output / f"{style}.csv",
                   [(h.east, h.north, h.yaw_deg, 1.0) for h in plan.houses if h.style == style])
    write_list(output / "shed.csv", [(*place, 1.0) for place in plan.sheds])
    return {name: mesh.triangles() for name, mesh in kinds.items()}


def make_forest(ground: Ground, plan: layout.Plan, output: pathlib.Path) -> dict:
    planter = forest.Planter(ground, plan, seed=1)
    forest.plant_village(planter)
    forest.plant_woods(planter)
    counts = {}
    for kind, make in trees.PROTOTYPES.items():
        mesh = make()
        mesh.write(output / f"{kind}.obj", f"A tree: {kind}")
        rows = [tree[1:] for tree in planter.trees if tree[0] == kind]
        write_list(output / f"{kind}.csv", rows)
        counts[kind] = (mesh.triangles(), len(rows))
    return counts


def main() -> int:
    root = pathlib.Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("reference_dir", type=pathlib.Path)
    parser.add_argument("--output", type=pathlib.Path, default=root / "scenes" / "jacksboro")
    options = parser.parse_args()
    if not (options.reference_dir / "terrain" / "jacksboro_dem.tif").is_file():
        parser.error(f"{options.reference_dir} holds no terrain/jacksboro_dem.tif")
    options.output.mkdir(parents=True, exist_ok=True)
    library = root / "scenes" / "library"
    mixtures.write(library / "spectra", options.output / "vegetation.csv")
    air.write(library / "atmosphere", options.output / "air.csv")
    ground = Ground(make_terrain(options.reference_dir, options.output), layout.SITE)
    plan = layout.make_plan()
    cover_mesh = cover.make_cover(ground, plan)
    cover_mesh.write(options.output / "cover.obj", "What lies on the ground, in scene axes")
    pond, level = cover.make_pond(ground, plan)
    pond.write(options.output / "pond.obj", "A pond and its banks, in scene axes")
    print(f"houses {len(plan.houses)}, sheds {len(plan.sheds)}, water level {level:.2f} m")
    print(f"triangles: cover {cover_mesh.triangles()}, pond {pond.triangles()}")
    print(f"triangles: {make_buildings(plan, options.output)}")
    print(f"trees (triangles, number): {make_forest(ground, plan, options.output)}")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
