#!/usr/bin/env python3
"""Puts three one-band images of a run together into a picture, red, green and blue.

    tools/three_bands.py OUT PICTURE.png [--arrays red green blue] [--window X Y WIDTH HEIGHT] [--scale N]

OUT is the folder of a run of scenes/jacksboro/pass.xml. Each band is stretched from a dark point (0.9
of its 0.5th percentile) to its 99.3rd percentile, with a square root. Needs numpy and GDAL's Python
binding (Debian: python3-numpy, python3-gdal).
"""
import argparse
import pathlib

import numpy
from osgeo import gdal


def stretched(radiance: numpy.ndarray) -> numpy.ndarray:
    low = 0.9 * numpy.percentile(radiance, 0.5)
    high = numpy.percentile(radiance, 99.3)
    return numpy.sqrt(numpy.clip((radiance - low) / (high - low), 0.0, 1.0))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("run", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--arrays", nargs=3, default=["red", "green", "blue"])
    parser.add_argument("--window", nargs=4, type=int, metavar=("X", "Y", "WIDTH", "HEIGHT"))
    parser.add_argument("--scale", type=int, default=1, help="magnification")
    options = parser.parse_args()
    gdal.UseExceptions()
    bands = []
    for name in options.arrays:
        image = gdal.Open(str(options.run / f"{name}_radiance.img"))
        bands.append(stretched(image.GetRasterBand(1).ReadAsArray().astype(float)))
    picture = numpy.round(255.0 * numpy.stack(bands)).astype(numpy.uint8)
    if options.window:
        x, y, width, height = options.window
        picture = picture[:, y:y + height, x:x + width]
    picture = picture.repeat(options.scale, 1).repeat(options.scale, 2)
    memory = gdal.GetDriverByName("MEM").Create("", picture.shape[2], picture.shape[1], 3)
    for band, plane in enumerate(picture, start=1):
        memory.GetRasterBand(band).WriteArray(plane)
    gdal.GetDriverByName("PNG").CreateCopy(str(options.picture), memory)
    options.picture.with_suffix(".png.aux.xml").unlink(missing_ok=True)


if __name__ == "__main__":
    main()
