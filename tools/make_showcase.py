#!/usr/bin/env python3
"""Writes the geometry, maps, plume and spectra of the invented harbour in scenes/showcase/.

    tools/make_showcase.py [--output scenes/showcase]

Python's standard library only; the same bytes each time. The scenarios (harbour.xml,
harbour_night.xml) are written by hand.
"""

import argparse
import pathlib
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from showcase import harbour, images, mesh, plume, spectra  # noqa: E402


def write_rows(path: pathlib.Path, head: str, rows: list) -> None:
    lines = [head] + [",".join(f"{value:g}" for value in row) for row in rows]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def make_meshes(output: pathlib.Path) -> int:
    kinds = {name: getattr(harbour, name) for name in
             ("ground", "warehouse", "office", "panes", "crane", "ship", "breakwater")}
    shapes = {name: make() for name, make in kinds.items()}
    for name, shape in shapes.items():
        shape.write(output / f"{name}.obj", kinds[name].__doc__.splitlines()[0])
    shapes["tree"], shapes["car"] = mesh.tree(seed=7), mesh.car()
    shapes["tree"].write(output / "tree.obj", "A broad-leaved tree 9 m high")
    shapes["car"].write(output / "car.obj", "A saloon car 4.4 m long, front towards +y")
    return sum(shape.triangles() for shape in shapes.values())


def make_lists(output: pathlib.Path) -> None:
    rng = random.Random(5)
    (x0, y0), (x1, y1) = harbour.LAWN
    places = [(x0 + 5 + 11 * i + rng.uniform(-2, 2), y0 + 6 + 11.5 * j + rng.uniform(-2, 2))
              for i in range(4) for j in range(4) if (i, j) not in ((1, 1), (2, 1), (1, 2))]
    write_rows(output / "trees.csv", "east_m,north_m,yaw_deg,scale",
               [(round(x, 1), round(y, 1), rng.randrange(360), round(rng.uniform(0.75, 1.15), 2))
                for x, y in places if x < x1 and y < y1])
    cars = {name: [] for name in ("cars_red", "cars_blue", "cars_white", "cars_dark")}
    west, south = harbour.PARKING[0]
    for row in (2.0, 12.4, 26.0, 36.4):
        for bay in range(images.BAYS):
            if rng.random() < 0.55:
                cars[rng.choice(sorted(cars))].append(
                    (round(west + 1.8 + images.BAY_M * (bay + 0.5), 2),
                     round(south + row + 2.6 + rng.uniform(-0.3, 0.3), 2), rng.choice((0, 180))))
    for name, rows in cars.items():
        write_rows(output / f"{name}.csv", "east_m,north_m,yaw_deg", rows)
    # yaw 270: the arm (along the row's north) points west, over the quay
    street = [(18.5, north, 270) for north in range(-100, 121, 36)]
    street += [(92.0, south + 10.0, 0), (92.0, south + 34.0, 0)]
    street += [(69.0, south + 22.0, 90), (115.0, south + 22.0, 270)]
    street += [(57.5, north, 90) for north in (8, 40, 72)]
    write_rows(output / "street.csv", "east_m,north_m,yaw_deg", street)


def make_images(output: pathlib.Path) -> None:
    for name, make, (lo, hi) in (("parking", images.markings, harbour.PARKING),
                                 ("yard", images.furrows, harbour.YARD)):
        images.write_png(output / f"{name}.png", make((hi[0] - lo[0], hi[1] - lo[1])))
    images.write_png(output / "lawn.png", images.patches())


def main() -> int:
    root = pathlib.Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=pathlib.Path, default=root / "scenes" / "showcase")
    output = parser.parse_args().output
    output.mkdir(parents=True, exist_ok=True)
    library = root / "scenes" / "library"
    triangles = make_meshes(output)
    make_lists(output)
    make_images(output)
    plume.write(output)
    spectra.paints(output)
    spectra.leaf(output)
    spectra.ground(library, output)
    spectra.glass(library, output)
    spectra.water_body(output)
    spectra.smoke(output)
    spectra.moon(library, output)
    spectra.night_sky(library, output)
    spectra.lamps(output)
    spectra.street_ies(output / "street.ies")
    size = sum(path.stat().st_size for path in output.iterdir())
    print(f"triangles {triangles}, {size // 1024} kB in {output}")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
