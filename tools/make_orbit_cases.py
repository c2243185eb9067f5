#!/usr/bin/env python3
"""Makes the table of orbits that SGP4 is tested against.

    tools/make_orbit_cases.py FIGURES OUTPUT

FIGURES is a folder with SGP4-VER.TLE and tcppver.out, the verification set of Vallado et al., AIAA
2006-6753. OUTPUT is a CSV: one row `orbit` for each element set, and below it one row `state` for
each moment. Where the source only repeats the last state of the orbit before (object 33334), its
program had an error and nothing of its own to write: one row `error`.
"""
import pathlib
import sys

HEAD = """\
# title: Verification of SGP4: 33 orbits and where they are, TEME, WGS-72
# source: Vallado, Crawford, Hujsak, Kelso, Revisiting Spacetrack Report 3, AIAA 2006-6753, files \
SGP4-VER.TLE and tcppver.out
# licence: public verification set; the copy read is part of python-sgp4, MIT
# note: made by tools/make_orbit_cases.py
# note: orbit,catalogue number,epoch year,day of year,B* per earth radius,inclination,node,\
eccentricity,argument of perigee,mean anomaly (deg),rev/day
# note: state,minutes,x,y,z (km),vx,vy,vz (km/s); error,minutes: no state is to be given
"""


def with_point(field):
    """A number of the form -12345-3, which has its point before the digits."""
    field = field.strip()
    if not field:
        return "0"
    sign = "-" if field[0] == "-" else ""
    digits = field.lstrip("+-")
    mantissa, exponent = digits[:-2], digits[-2:]
    return f"{sign}0.{mantissa}e{int(exponent)}"


def orbit_row(first, second):
    year = int(first[18:20])
    year += 1900 if year >= 57 else 2000
    fields = [first[2:7], year, first[20:32], with_point(first[53:61]), second[8:16], second[17:25],
              "0." + second[26:33].replace(" ", "0"), second[34:42], second[43:51], second[52:63]]
    return "orbit," + ",".join(str(field).strip() for field in fields)


def element_sets(text):
    lines = [line for line in text.splitlines() if line.startswith(("1 ", "2 "))]
    return list(zip(lines[0::2], lines[1::2], strict=True))


def blocks(text):
    """The rows of each orbit, in the file's order: catalogue number, list of rows."""
    found = []
    for line in text.splitlines():
        words = line.split()
        if len(words) == 2 and words[1] == "xx":
            found.append((int(words[0]), []))
        elif words:
            found[-1][1].append(words[:7])
    return found


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    figures = pathlib.Path(sys.argv[1])
    sets = element_sets((figures / "SGP4-VER.TLE").read_text())
    states = blocks((figures / "tcppver.out").read_text())
    rows, last = [], None
    for (first, second), (number, moments) in zip(sets, states, strict=True):
        if int(first[2:7]) != number:
            sys.exit(f"{number} stands where {first[2:7]} is expected")
        rows.append(orbit_row(first, second))
        for minutes, *state in moments:
            row = ["error", minutes] if state == last else ["state", minutes, *state]
            rows.append(",".join(row))
            last = state
    pathlib.Path(sys.argv[2]).write_text(HEAD + "\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
