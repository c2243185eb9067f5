#!/usr/bin/env python3
"""Makes tests/ephemeris/oracle_de423.csv: sun and moon from JPL DE423 through Skyfield.

Nothing here shares code with Nadir's own chain: the positions are JPL's numerical
integration DE423 (the program uses analytical series), the observer chain (precession, nutation,
sidereal time, WGS84, light time, deflection, aberration) is Skyfield's, the time scales are
computed below from USNO's table of TAI-UTC, Skyfield's leap seconds and the Delta T polynomials.

    python3 -m venv venv && venv/bin/pip install skyfield==1.55 jplephem==2.24 de423==2010.1
    venv/bin/python tools/make_ephemeris_oracle.py > tests/ephemeris/oracle_de423.csv
"""

import datetime
import math

import de423
import numpy as np
from jplephem.ephem import Ephemeris
from skyfield.api import load, wgs84
from skyfield.vectorlib import VectorFunction

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
    kernel = Ephemeris(de423)
    moon_share = 1.0 / (1.0 + kernel.EMRAT)

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


def main():
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


if __name__ == "__main__":
    main()
