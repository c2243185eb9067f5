#!/usr/bin/env python3
"""Measures `nadir ephemeris` against a table of positions, or of rise and set, and prints the
accuracy table of docs/ephemeris.md.

    tools/measure_ephemeris.py build/nadir tests/ephemeris/oracle_de423.csv
    tools/measure_ephemeris.py build/nadir tests/ephemeris/oracle_pyephem.csv
    tools/measure_ephemeris.py build/nadir tests/ephemeris/oracle_rise_set.csv
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
        arguments += [option, row.get(column, "0")]
    done = subprocess.run(arguments, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return json.loads(done.stdout)


def body_errors(row, name, body):
    found = {}
    expected = (float(row[f"{name}_azimuth_deg"]), float(row[f"{name}_elevation_deg"]))
    place = (body["azimuth_deg"], body["elevation_deg"])
    found[f"{name} separation, arcsec"] = separation_arcsec(place, expected)
    found[f"{name} elevation, arcsec"] = 3600.0 * (body["elevation_deg"] - expected[1])
    if f"{name}_distance_km" in row:
        distance_km = float(row[f"{name}_distance_km"])
        found[f"{name} distance, km"] = body["distance_m"] / 1000.0 - distance_km
    return found


def position_errors(row, seen):
    """The differences of one row, by name."""
    found = {**body_errors(row, "sun", seen["sun"]), **body_errors(row, "moon", seen["moon"])}
    if "moon_phase_angle_deg" in row:
        phase = float(row["moon_phase_angle_deg"])
        found["phase angle, arcsec"] = 3600.0 * (seen["moon"]["phase_angle_deg"] - phase)
        lit = (1.0 + math.cos(math.radians(phase))) / 2.0
        found["illuminated fraction"] = seen["moon"]["illuminated_fraction"] - lit
    return [(name, value) for name, value in found.items()]


def rise_set_errors(row, seen):
    """Seconds between the events of one row; an event more or less is an error that stops."""
    name, day = row["body"], seen["next_24_hours"]
    sign = {f"{name}rise": 1.0, f"{name}set": -1.0}
    events = [sign[e["event"]] * e["seconds_after"] for e in day["events"] if e["event"] in sign]
    expected = [float(t) for t in row["seconds"].split()]
    if len(events) != len(expected) or day[f"{name}_up_at_start"] != (row["above_at_start"] == "1"):
        sys.exit(f"{row}: found {events}")
    latitude = abs(float(row["latitude_deg"]))
    zone = "to 60" if latitude < 60 else "60 to 80" if latitude < 80 else "89.9"
    found = [("days without a difference in events", 0.0)]
    for event, wanted in zip(events, expected):
        found.append((f"{name}, latitude {zone}, s", event - wanted))
    return found


def main():
    command, table = sys.argv[1:]
    with open(table, encoding="ascii") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    errors = rise_set_errors if "seconds" in rows[0] else position_errors
    by_name = {}
    for row in rows:
        for name, value in errors(row, nadir(command, row)):
            by_name.setdefault(name, []).append(value)
    print(f"| quantity, {len(rows)} rows | number | largest | rms |")
    print("|---|---|---|---|")
    for name, values in by_name.items():
        rms = math.sqrt(sum(value * value for value in values) / len(values))
        print(f"| {name} | {len(values)} | {max(map(abs, values)):.2g} | {rms:.2g} |")


if __name__ == "__main__":
    main()
