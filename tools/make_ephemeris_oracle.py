#!/usr/bin/env python3
"""Makes the tables of positions and of rise and set that the ephemeris is tested against.

oracle_de423.csv: sun and moon from JPL DE423 through Skyfield. Nothing here shares code with
Nadir's own chain: the positions are JPL's numerical
integration DE423 (the program uses analytical series), the observer chain (precession, nutation,
sidereal time, WGS84, light time, deflection, aberration) is Skyfield's, the time scales are
computed below from USNO's table of TAI-UTC, Skyfield's leap seconds and the Delta T polynomials.

    python3 -m venv venv && venv/bin/pip install skyfield==1.55 jplephem==2.24 de423==2010.1
    venv/bin/python tools/make_ephemeris_oracle.py de423 > tests/ephemeris/oracle_de423.csv

oracle_pyephem.csv and oracle_rise_set.csv: the same from PyEphem (VSOP87, Moshier's moon; Debian's
python3-ephem), at the poles and the date line too; `PyEphem` below says how its time scales are
made equal to Nadir's.

    tools/make_ephemeris_oracle.py pyephem > tests/ephemeris/oracle_pyephem.csv
    tools/make_ephemeris_oracle.py rise_set > tests/ephemeris/oracle_rise_set.csv
"""

import datetime
import math
import sys

try:
    import de423
    import numpy as np
    from jplephem.ephem import Ephemeris
    from skyfield.api import load, wgs84
    from skyfield.vectorlib import VectorFunction
except ImportError:  # only the table of that name needs them
    de423, VectorFunction = None, object

AU_KM = 149597870.7
DATES = 60
FIRST_YEAR, LAST_YEAR = 1900, 2100
SITES = [  # latitude north, longitude east, metres above the WGS84 ellipsoid
    (0.0, 0.0, 0.0),
    (48.8566, 2.3522, 35.0),  # Paris
    (-33.8688, 151.2093, 58.0),  # Sydney
    (69.6492, 18.9553, 10.0),  # Tromso
    (19.8207, -155.4681, 4205.0),  # Mauna Kea
]


class Body(VectorFunction):
    """A body of DE423, from the barycentre of the solar system, as Skyfield wants it."""

    center = 0
    kernel = Ephemeris(de423) if de423 else None
    moon_share = 1.0 / (1.0 + kernel.EMRAT) if de423 else None

    def __init__(self, name, target):
        self.name, self.target, self.ephemeris = name, target, None

    def _chebyshev(self, name, t):
        position, velocity = self.kernel.position_and_velocity(name, t.tdb)
        return np.squeeze(position) / AU_KM, np.squeeze(velocity) / AU_KM

    def _at(self, t):
        if self.name not in ("earth", "moon"):
            return (*self._chebyshev(self.name, t), None, None)
        earth_moon, moon = self._chebyshev("earthmoon", t), self._chebyshev("moon", t)
        share = -self.moon_share if self.name == "earth" else 1.0 - self.moon_share
        return (*(e + share * m for e, m in zip(earth_moon, moon)), None, None)


def modified_julian_date(when):
    return (when - datetime.datetime(1858, 11, 17)).total_seconds() / 86400.0


def polynomial_delta_t(when):
    """Espenak & Meeus 2006 (NASA/TP-2006-214141), seconds; y as they define it, by the month."""
    y = when.year + (when.month - 0.5) / 12.0
    if y < 1920:
        t = y - 1900
        return -2.79 + 1.494119 * t - 0.0598939 * t**2 + 0.0061966 * t**3 - 0.000197 * t**4
    if y < 1941:
        t = y - 1920
        return 21.20 + 0.84493 * t - 0.076100 * t**2 + 0.0020936 * t**3
    t = y - 1950
    return 29.07 + 0.407 * t - t**2 / 233 + t**3 / 2547


# USNO tai-utc.dat: from, seconds, reference day (MJD), seconds a day.
RUBBER_SECONDS = [
    (datetime.datetime(1960, 1, 1), 1.4178180, 37300, 0.0012960),
    (datetime.datetime(1961, 1, 1), 1.4228180, 37300, 0.0012960),
    (datetime.datetime(1961, 8, 1), 1.3728180, 37300, 0.0012960),
    (datetime.datetime(1962, 1, 1), 1.8458580, 37665, 0.0011232),
    (datetime.datetime(1963, 11, 1), 1.9458580, 37665, 0.0011232),
    (datetime.datetime(1964, 1, 1), 3.2401300, 38761, 0.0012960),
    (datetime.datetime(1964, 4, 1), 3.3401300, 38761, 0.0012960),
    (datetime.datetime(1964, 9, 1), 3.4401300, 38761, 0.0012960),
    (datetime.datetime(1965, 1, 1), 3.5401300, 38761, 0.0012960),
    (datetime.datetime(1965, 3, 1), 3.6401300, 38761, 0.0012960),
    (datetime.datetime(1965, 7, 1), 3.7401300, 38761, 0.0012960),
    (datetime.datetime(1965, 9, 1), 3.8401300, 38761, 0.0012960),
    (datetime.datetime(1966, 1, 1), 4.3131700, 39126, 0.0025920),
    (datetime.datetime(1968, 2, 1), 4.2131700, 39126, 0.0025920),
]


def tai_minus_utc(when, skyfield_scale):
    if when.year < 1972:
        _, seconds, day, rate = [row for row in RUBBER_SECONDS if row[0] <= when][-1]
        return seconds + (modified_julian_date(when) - day) * rate
    utc = skyfield_scale.utc(when.year, when.month, when.day, when.hour, when.minute, when.second)
    return round((utc.tai - (modified_julian_date(when) + 2400000.5)) * 86400.0)


def instants():
    """Dates that run through years, seasons, hours and UT1-UTC without a common period."""
    start = datetime.datetime(FIRST_YEAR, 1, 1, 0, 0, 5)
    days = (datetime.datetime(LAST_YEAR, 12, 31) - start).days
    scale = load.timescale(builtin=True)
    for i in range(DATES):
        seconds = round(86400.0 * days * i / (DATES - 1) + 86400.0 * ((i * 0.61803398875) % 1.0))
        when = start + datetime.timedelta(seconds=seconds)
        if when.year < 1960:
            yield when, 0.0, polynomial_delta_t(when), 0.0
        else:
            ut1_utc = round(0.8 * math.sin(1.7 * i), 3)
            tt_utc = tai_minus_utc(when, scale) + 32.184
            yield when, ut1_utc, tt_utc - ut1_utc, tt_utc


def row(when, ut1_utc, delta_t, tt_offset, site, bodies):
    scale = load.timescale(delta_t=delta_t, builtin=True)
    midnight = math.floor(modified_julian_date(when)) + 2400000.5
    seconds = when.hour * 3600 + when.minute * 60 + when.second
    tt_seconds = seconds + (tt_offset if tt_offset else delta_t)
    t = scale.tt_jd(midnight, tt_seconds / 86400.0)
    latitude, longitude, height = site
    place = bodies["earth"] + wgs84.latlon(latitude, longitude, elevation_m=height)
    observer = place.at(t)
    # where Skyfield looks for the bodies that deflect light, by their NAIF numbers
    observer._ephemeris = {body.target: body for body in bodies.values()}
    # distances and the phase angle are those of the instant, without light time
    to_sun, to_moon = ((bodies[name] - place).at(t).xyz.km for name in ("sun", "moon"))
    cells = [when.strftime("%Y-%m-%dT%H:%M:%SZ"), f"{ut1_utc:.3f}", f"{delta_t:.3f}",
             f"{latitude}", f"{longitude}", f"{height}"]
    for name, vector in (("sun", to_sun), ("moon", to_moon)):
        elevation, azimuth, _ = observer.observe(bodies[name]).apparent().altaz()
        cells += [f"{azimuth.degrees:.7f}", f"{elevation.degrees:.7f}",
                  f"{np.linalg.norm(vector):.3f}"]
    from_moon = to_sun - to_moon
    cosine = np.dot(from_moon, -to_moon) / np.linalg.norm(from_moon) / np.linalg.norm(to_moon)
    return ",".join(cells + [f"{math.degrees(math.acos(cosine)):.6f}"])


def write_de423():
    numbers = {"sun": 10, "moon": 301, "earth": 399, "jupiter": 599, "saturn": 699}
    bodies = {name: Body(name, number) for name, number in numbers.items()}
    print("# Sun and moon, topocentric, without refraction: JPL DE423 (PyPI de423 2010.1) through "
          "Skyfield 1.55.")
    print("# Made by tools/make_ephemeris_oracle.py; its head holds the command. Before 1960 the "
          "time is UT1.")
    print("time,ut1_utc_s,tt_ut1_s,latitude_deg,longitude_deg,height_m,"
          "sun_azimuth_deg,sun_elevation_deg,sun_distance_km,"
          "moon_azimuth_deg,moon_elevation_deg,moon_distance_km,moon_phase_angle_deg")
    for instant in instants():
        for site in SITES:
            print(row(*instant, site, bodies))


# Leap seconds: the first day with this TAI - UTC, from USNO's tai-utc.dat.
LEAP_SECONDS = [
    ("1972-01-01", 10), ("1972-07-01", 11), ("1973-01-01", 12), ("1974-01-01", 13),
    ("1975-01-01", 14), ("1976-01-01", 15), ("1977-01-01", 16), ("1978-01-01", 17),
    ("1979-01-01", 18), ("1980-01-01", 19), ("1981-07-01", 20), ("1982-07-01", 21),
    ("1983-07-01", 22), ("1985-07-01", 23), ("1988-01-01", 24), ("1990-01-01", 25),
    ("1991-01-01", 26), ("1992-07-01", 27), ("1993-07-01", 28), ("1994-07-01", 29),
    ("1996-01-01", 30), ("1997-07-01", 31), ("1999-01-01", 32), ("2006-01-01", 33),
    ("2009-01-01", 34), ("2012-07-01", 35), ("2015-07-01", 36), ("2017-01-01", 37)]


def tt_and_ut1(when, ut1_utc):
    """Seconds to add to the written time for TT and for UT1, as Nadir reads it."""
    if when.year < 1960:
        return polynomial_delta_t(when), 0.0
    if when.year < 1972:
        return tai_minus_utc(when, None) + 32.184, ut1_utc
    tai_utc = [s for day, s in LEAP_SECONDS if datetime.datetime.fromisoformat(day) <= when][-1]
    return tai_utc + 32.184, ut1_utc


class PyEphem:
    """An observer of PyEphem whose TT and UT1 are Nadir's.

    PyEphem takes one date for UT1 and adds a Delta T of its own. It is given the date that makes
    its TT right. Its UT1 is then off by Nadir's Delta T less its own, some seconds: the earth is
    turned back by moving the observer in longitude, 360.98565 degrees a day.
    """

    TURNS_A_DAY = 1.00273781191135448

    def __init__(self, when, ut1_utc, site):
        import ephem  # pylint: disable=import-outside-toplevel
        self.ephem = ephem
        tt, ut1 = tt_and_ut1(when, ut1_utc)
        date = ephem.Date(when)
        for _ in range(5):
            ephem_delta_t = ephem.delta_t(date)
            date = ephem.Date(ephem.Date(when) + (tt - ephem_delta_t) / 86400.0)
        turned_deg = 360.0 * self.TURNS_A_DAY * (ut1 - (tt - ephem_delta_t)) / 86400.0
        self.start = date
        self.observer = ephem.Observer()
        self.observer.lat = math.radians(site[0])
        self.observer.lon = math.radians(site[1] + turned_deg)
        self.observer.elevation = site[2]
        self.observer.pressure = 0.0
        self.bodies = {"sun": ephem.Sun(), "moon": ephem.Moon()}

    def see(self, name, seconds=0.0):
        self.observer.date = self.start + seconds / 86400.0
        body = self.bodies[name]
        body.compute(self.observer)
        return body


POLAR_SITES = [  # the poles, the polar circles, the date line from both sides
    (89.9, 0.0, 0.0), (89.9, -135.0, 3.0), (78.2, 15.6, 10.0), (66.56, -180.0, 100.0),
    (51.5, 179.99, 0.0), (43.0, 5.0, 312.0), (19.82, -155.47, 4205.0), (0.0, 180.0, 0.0),
    (-23.4, -179.99, 50.0), (-33.87, 151.21, 58.0), (-66.56, 90.0, 0.0), (-89.9, 60.0, 2800.0)]


def dates(count, first_year, last_year):
    """Spread evenly, the hour and UT1 - UTC without a common period."""
    start = datetime.datetime(first_year, 1, 1, 0, 0, 7)
    days = (datetime.datetime(last_year, 12, 30) - start).days
    for i in range(count):
        seconds = round(86400.0 * days * i / (count - 1) + 86400.0 * ((i * 0.61803398875) % 1.0))
        when = start + datetime.timedelta(seconds=seconds)
        yield when, 0.0 if when.year < 1960 else round(0.8 * math.sin(1.7 * i), 3)


def write_pyephem():
    import ephem  # pylint: disable=import-outside-toplevel
    print(f"# Sun and moon, topocentric, without refraction: PyEphem {ephem.__version__}, its TT and "
          "UT1 made Nadir's.")
    print("# Made by tools/make_ephemeris_oracle.py pyephem. Before 1960 the time is UT1.")
    print("time,ut1_utc_s,latitude_deg,longitude_deg,height_m,"
          "sun_azimuth_deg,sun_elevation_deg,moon_azimuth_deg,moon_elevation_deg")
    for when, ut1_utc in dates(30, 1950, 2050):
        for site in POLAR_SITES:
            cells = [when.strftime("%Y-%m-%dT%H:%M:%SZ"), f"{ut1_utc:.3f}", *map(str, site)]
            seen = PyEphem(when, ut1_utc, site)
            for name in ("sun", "moon"):
                body = seen.see(name)
                cells += [f"{math.degrees(body.az):.6f}", f"{math.degrees(body.alt):.6f}"]
            print(",".join(cells))


def crossings(seen, name):
    """Seconds after the start when the upper limb passes the horizon, + for a rise, - for a set."""
    def height(second):
        body = seen.see(name, second)
        radius_deg = 16.0 / 60.0 if name == "sun" else math.degrees(body.radius)
        return math.degrees(body.alt) + radius_deg + 34.0 / 60.0
    found, step = [], 120
    heights = [height(t) for t in range(0, 86401, step)]
    for i, (low, high) in enumerate(zip(heights, heights[1:])):
        if (low > 0.0) == (high > 0.0):
            continue
        a, b = i * step, (i + 1) * step
        while b - a > 0.01:
            middle = 0.5 * (a + b)
            a, b = (middle, b) if (height(middle) > 0.0) == (low > 0.0) else (a, middle)
        found.append(0.5 * (a + b) * (1.0 if high > 0.0 else -1.0))
    return heights[0] > 0.0, found


def write_rise_set():
    import ephem  # pylint: disable=import-outside-toplevel
    print(f"# Rise (+) and set (-) of the upper limb, seconds after the start: PyEphem "
          f"{ephem.__version__}, its TT and UT1 made Nadir's.")
    print("# Horizon: sun's centre 50 arcmin below, moon's upper limb 34 arcmin below. Made by "
          "tools/make_ephemeris_oracle.py rise_set.")
    print("time,latitude_deg,longitude_deg,height_m,body,above_at_start,seconds")
    for when, _ in dates(16, 1963, 2047):
        for site in POLAR_SITES:
            for name in ("sun", "moon"):
                above, found = crossings(PyEphem(when, 0.0, site), name)
                cells = [when.strftime("%Y-%m-%dT%H:%M:%SZ"), *map(str, site), name,
                         str(int(above)), " ".join(f"{t:.1f}" for t in found)]
                print(",".join(cells))


def main():
    tables = {"de423": write_de423, "pyephem": write_pyephem, "rise_set": write_rise_set}
    if len(sys.argv) != 2 or sys.argv[1] not in tables:
        sys.exit(f"usage: {sys.argv[0]} {' | '.join(tables)}")
    tables[sys.argv[1]]()


if __name__ == "__main__":
    main()
