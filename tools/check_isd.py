#!/usr/bin/env python3
"""Checks CSM image support data against `nadir project`.

An independent reader of what the program writes for the community sensor model: the frame and the
line scanner model of USGS as their documentation has them, from the ISD alone.

    check_isd.py ISD.json --points table.csv
        table.csv: what `nadir project ... --format csv` printed, with places
    check_isd.py ISD.json --nadir BUILD/nadir --scenario S.xml --array A [--heights 0,100]
        asks the program itself for a grid of image places at these heights

The program counts samples in the array, a module's ISD in the module: rows beside it are left out.
Every row is taken both ways: its place to the image, and its image place to the ground at its
height. Prints the largest difference of each, in pixels. Exit status: 0 all within --tolerance
(default 1e-3), 1 not, 2 wrong use, 77 numpy is missing.
"""
import argparse
import csv
import io
import json
import subprocess
import sys

try:
    import numpy as np
except ImportError:
    print("check_isd.py: numpy is missing", file=sys.stderr)
    sys.exit(77)


def rotation(q):
    """Matrix of a quaternion, scalar first: reference to sensor."""
    w, x, y, z = q / np.linalg.norm(q)
    return np.array(
        [
            [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ]
    )


def lagrange(times, values, t):
    """Even steps; eight points in the middle, six, four and two towards the ends."""
    n = len(times)
    if n == 1:
        return values[0]
    place = (t - times[0]) / (times[-1] - times[0]) * (n - 1)
    index = min(max(int(np.floor(place)), 0), n - 2)
    half = min(4, index + 1, n - 1 - index)
    nodes = np.arange(index - half + 1, index + half + 1)
    result = np.zeros(values.shape[1])
    for i in nodes:
        others = nodes[nodes != i]
        result += values[i] * np.prod((place - others) / (i - others))
    return result


class Table:
    """Something that an ISD gives at times; signs of quaternions made continuous."""

    def __init__(self, block, key, centre):
        self.times = np.array(block["ephemeris_times"]) - centre
        self.values = np.array(block[key], dtype=float)
        if key == "quaternions":
            for i in range(1, len(self.values)):
                if np.dot(self.values[i - 1], self.values[i]) < 0:
                    self.values[i] *= -1

    def at(self, t):
        return lagrange(self.times, self.values, t)


class SensorModel:
    def __init__(self, isd):
        self.is_line_scanner = isd["name_model"] == "USGS_ASTRO_LINE_SCANNER_SENSOR_MODEL"
        if not self.is_line_scanner and isd["name_model"] != "USGS_ASTRO_FRAME_SENSOR_MODEL":
            raise ValueError("unknown model " + isd["name_model"])
        self.lines, self.samples = isd["image_lines"], isd["image_samples"]
        centre = isd["center_ephemeris_time"]
        self.positions = Table(isd["instrument_position"], "positions", centre)  # km
        self.pointing = Table(isd["instrument_pointing"], "quaternions", centre)
        self.body = Table(isd["body_rotation"], "quaternions", centre)
        self.focal = isd["focal_length_model"]["focal_length"]
        self.to_lines = np.array(isd["focal2pixel_lines"])
        self.to_samples = np.array(isd["focal2pixel_samples"])
        self.start_sample = isd["starting_detector_sample"]  # of a module in its array
        self.centre_line = isd["detector_center"]["line"]
        self.centre_sample = isd["detector_center"]["sample"]
        self.radtan = isd["optical_distortion"]["radtan"]["coefficients"]
        unit = 1000.0 if isd["radii"]["unit"] == "km" else 1.0
        self.a, self.b = isd["radii"]["semimajor"] * unit, isd["radii"]["semiminor"] * unit
        if self.is_line_scanner:
            (self.line0, self.time0, self.rate), = isd["line_scan_rate"]

    # -- camera --

    def distorted(self, u):
        """Ideal to distorted place on the focal plane, mm; the polynomial is over the focal length."""
        k1, k2, p1, p2, k3 = self.radtan
        x, y = u / self.focal
        r2 = x * x + y * y
        radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
        return self.focal * np.array(
            [
                x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
                y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y,
            ]
        )

    def undistorted(self, d):
        u = d.copy()
        for _ in range(50):
            step = d - self.distorted(u)
            u += step
            if np.abs(step).max() < 1e-13:
                break
        return u

    def focal_of_pixel(self, line, sample):
        """The line scanner's detector has the line 0 only."""
        right = np.array(
            [
                (0.0 if self.is_line_scanner else line) - self.centre_line - self.to_lines[0],
                sample + self.start_sample - self.centre_sample - self.to_samples[0],
            ]
        )
        return np.linalg.solve(np.array([self.to_lines[1:], self.to_samples[1:]]), right)

    def pixel_of_focal(self, d):
        line = self.to_lines[0] + self.to_lines[1:] @ d + self.centre_line
        sample = self.to_samples[0] + self.to_samples[1:] @ d + self.centre_sample
        return line, sample - self.start_sample

    def pose(self, t):
        """Position, m, and the matrix from sensor to body axes."""
        body = rotation(self.body.at(t))
        return body @ self.positions.at(t) * 1000.0, body @ rotation(self.pointing.at(t)).T

    def time(self, line):
        return self.time0 + self.rate * (line - self.line0) if self.is_line_scanner else 0.0

    # -- both ways --

    def ray(self, line, sample):
        u = self.undistorted(self.focal_of_pixel(line, sample))
        position, axes = self.pose(self.time(line))
        look = axes @ np.array([u[0], u[1], self.focal])
        return position, look / np.linalg.norm(look)

    def detector(self, ground, t):
        """Line of the detector and sample at which a place appears at a time."""
        position, axes = self.pose(t)
        look = axes.T @ (ground - position)
        return self.pixel_of_focal(self.distorted(look[:2] * self.focal / look[2]))

    def ground_to_image(self, ground):
        if not self.is_line_scanner:
            return self.detector(ground, 0.0)
        low, high = -0.1 * self.lines, 1.1 * self.lines
        line = 0.5 * (low + high)
        for _ in range(50):  # secant: the detector's line must come to 0
            miss, sample = self.detector(ground, self.time(line))
            near, _ = self.detector(ground, self.time(line + 0.5))
            step = -miss * 0.5 / (near - miss)
            line = min(max(line + step, low), high)
            if abs(step) < 1e-9:
                break
        return line, self.detector(ground, self.time(line))[1]

    def image_to_ground(self, line, sample, height):
        position, look = self.ray(line, sample)
        scale = np.array([self.a + height, self.a + height, self.b + height])
        o, d = position / scale, look / scale
        dd, od = d @ d, o @ d
        distance = (-od - np.sqrt(od * od - dd * (o @ o - 1))) / dd
        for _ in range(20):
            place = position + distance * look
            _, _, h, up = self.geodetic(place)
            step = (height - h) / (up @ look)
            distance += step
            if abs(step) < 1e-7:
                break
        return position + distance * look

    # -- the ellipsoid --

    def geodetic(self, p):
        """Latitude and longitude in degrees, height, and the vertical's direction (Bowring)."""
        e2 = 1 - (self.b / self.a) ** 2
        r = np.hypot(p[0], p[1])
        beta = np.arctan2(self.a * p[2], self.b * r)
        for _ in range(5):
            latitude = np.arctan2(
                p[2] + e2 / (1 - e2) * self.b * np.sin(beta) ** 3, r - e2 * self.a * np.cos(beta) ** 3
            )
            beta = np.arctan2((1 - e2) ** 0.5 * np.sin(latitude), np.cos(latitude))
        longitude = np.arctan2(p[1], p[0])
        s, c = np.sin(latitude), np.cos(latitude)
        height = r * c + p[2] * s - self.a * np.sqrt(1 - e2 * s * s)
        up = np.array([c * np.cos(longitude), c * np.sin(longitude), s])
        return np.degrees(latitude), np.degrees(longitude), height, up

    def ecef(self, latitude, longitude, height):
        e2 = 1 - (self.b / self.a) ** 2
        s, c = np.sin(np.radians(latitude)), np.cos(np.radians(latitude))
        n = self.a / np.sqrt(1 - e2 * s * s)
        l = np.radians(longitude)
        return np.array(
            [(n + height) * c * np.cos(l), (n + height) * c * np.sin(l), (n * (1 - e2) + height) * s]
        )


def asked_of_program(options, model):
    """A table of image places at heights, answered by the program."""
    rows = ["sample,line,height_m"]
    for height in options.heights.split(","):
        for i in range(7):
            for j in range(7):
                sample = model.start_sample + 0.5 + i / 6 * (model.samples - 1)
                rows.append(f"{sample},{0.5 + j / 6 * (model.lines - 1)},{height}")
    path = options.isd + ".points.csv"
    with open(path, "w") as file:
        file.write("\n".join(rows) + "\n")
    command = [options.nadir, "project", options.scenario, "--file", path, "--format", "csv"]
    if options.array:
        command += ["--array", options.array]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("isd")
    parser.add_argument("--points")
    parser.add_argument("--nadir")
    parser.add_argument("--scenario")
    parser.add_argument("--array")
    parser.add_argument("--heights", default="0,500")
    parser.add_argument("--tolerance", type=float, default=1e-3)
    options = parser.parse_args()
    if not options.points and not (options.nadir and options.scenario):
        parser.error("--points, or --nadir and --scenario are wanted")
    with open(options.isd) as file:
        model = SensorModel(json.load(file))
    if options.points:
        with open(options.points) as file:
            text = file.read()
    else:
        text = asked_of_program(options, model)
    forward, backward, count = 0.0, 0.0, 0
    for row in csv.DictReader(io.StringIO(text)):
        if not row["sample"] or not row["latitude_deg"]:
            continue
        sample, line = float(row["sample"]) - model.start_sample, float(row["line"])
        if not 0 <= sample <= model.samples:
            continue  # another module's
        height = float(row["height_m"])
        ground = model.ecef(float(row["latitude_deg"]), float(row["longitude_deg"]), height)
        found_line, found_sample = model.ground_to_image(ground)
        forward = max(forward, np.hypot(found_line - line, found_sample - sample))
        met = model.image_to_ground(line, sample, height)
        aside = model.image_to_ground(line, sample + 1.0, height)
        backward = max(backward, np.linalg.norm(met - ground) / np.linalg.norm(aside - met))
        count += 1
    print(f"{count} places: ground to image {forward:.2e} px, image to ground {backward:.2e} px")
    sys.exit(0 if count > 0 and max(forward, backward) < options.tolerance else 1)


if __name__ == "__main__":
    main()
