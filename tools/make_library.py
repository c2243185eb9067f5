#!/usr/bin/env python3
"""Writes the shipped data under scenes/library/ from a folder of reference figures.

    tools/make_library.py REFERENCE_DIR [--output scenes/library] [--sunlight PROGRAM]

Python's standard library only; the same inputs give the same bytes. What each file is made of
stands in its header and in scenes/library/README.md.
"""

import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from library import (  # noqa: E402
    air_gases, air_particles, atmosphere, illumination, lunar, night_sky, optics, responses,
    sunlight, surfaces, thermal)


def main() -> int:
    root = pathlib.Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("reference_dir", type=pathlib.Path)
    parser.add_argument("--output", type=pathlib.Path, default=root / "scenes" / "library")
    parser.add_argument("--sunlight", type=pathlib.Path, metavar="PROGRAM",
                        help="bench/sunlight_at_ground, built; without it its table stays")
    options = parser.parse_args()
    if not (options.reference_dir / "surfaces_manmade" / "index.csv").is_file():
        parser.error(f"{options.reference_dir} holds no surfaces_manmade/index.csv")
    surfaces.write(options.reference_dir, options.output)
    optics.write(options.reference_dir, options.output)
    responses.write(options.reference_dir, options.output)
    solar = illumination.write(options.reference_dir, options.output)
    lunar.write(options.reference_dir, options.output)
    atmosphere.write(options.reference_dir, options.output, solar)
    air_gases.write(options.reference_dir, options.output)
    air_particles.write(options.reference_dir, options.output)
    night_sky.write(options.reference_dir, options.output, solar)
    thermal.write(options.reference_dir, options.output)
    if options.sunlight:
        sunlight.write(options.output, options.sunlight)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
