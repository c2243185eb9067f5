#!/usr/bin/env python3
"""Measures `nadir ephemeris` against a table of positions and prints the accuracy table of
docs/ephemeris.md.

    tools/measure_ephemeris.py build/nadir tests/ephemeris/oracle_de423.csv
"""

import csv
import json
import math
import subprocess
import sys


def direction(azimuth_deg, elevation_deg):
    azimuth, elevation = math.radians(azimuth_deg), math.radians(elevation_deg)
    horizontal = math.cos(elevation)
    return (horizontal * math.sin(azimuth), horizontal * math.cos(azimuth), math.sin(elevation))


def separation_arcsec(a, b):
    """Through the chord, which keeps its digits at small angles."""
    chord = math.dist(direction(*a), direction(*b))
    return math.degrees(2.0 * math.asin(chord / 2.0)) * 3600.0


def nadir(command, row):
    arguments = [command, "ephemeris", "--format", "json", "--time", row["time"]]
    for option, column in (("--latitude", "latitude_deg"), ("--longitude", "longitude_deg"),
                           ("--height", "height_m"), ("--ut1-utc", "ut1_utc_s")):
        arguments += [option, row[column]]
    done = subprocess.run(arguments, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return json.loads(done.stdout)


def errors(row, seen):
    """The differences of one row, by name."""
    found = {}
    for name in ("sun", "moon"):
        expected = [float(row[f"{name}_{key}"])
                    for key in ("azimuth_deg", "elevation_deg", "distance_km")]
        body = seen[name]
        place = (body["azimuth_deg"], body["elevation_deg"])
        found[f"{name} separation, arcsec"] = separation_arcsec(place, expected[:2])
        found[f"{name} elevation, arcsec"] = 3600.0 * (body["elevation_deg"] - expected[1])
        found[f"{name} distance, km"] = body["distance_m"] / 1000.0 - expected[2]
    phase = float(row["moon_phase_angle_deg"])
    found["phase angle, arcsec"] = 3600.0 * (seen["moon"]["phase_angle_deg"] - phase)
    lit = (1.0 + math.cos(math.radians(phase))) / 2.0
    found["illuminated fraction"] = seen["moon"]["illuminated_fraction"] - lit
    return found


def main():
    command, table = sys.argv[1:]
    with open(table, encoding="ascii") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    all_errors = [errors(row, nadir(command, row)) for row in rows]
    print(f"| quantity, {len(rows)} positions | largest | rms |")
    print("|---|---|---|")
    for name in all_errors[0]:
        values = [found[name] for found in all_errors]
        rms = math.sqrt(sum(value * value for value in values) / len(values))
        print(f"| {name} | {max(map(abs, values)):.2g} | {rms:.2g} |")


if __name__ == "__main__":
    main()
