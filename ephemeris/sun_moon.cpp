#include "ephemeris/sun_moon.hpp"

#include <erfa.h>
#include <erfam.h>

#include <array>
#include <cmath>

#include "core/constants.hpp"
#include "core/frame.hpp"

namespace nadir::ephemeris {
namespace {

enum class Body { sun, moon };

// Positions in this file are in au, from the barycentre of the solar system, on the axes of the
// BCRS, unless the name says otherwise.
constexpr double light_days_per_au = ERFA_AULT / ERFA_DAYSEC;

Vec3 vec(const double (&v)[3]) { return {v[0], v[1], v[2]}; }

struct Earth {
  double heliocentric[2][3];
  double barycentric[2][3];
};

// TT stands for TDB: they differ by 2 ms, in which the moon moves 0.001 arcsec.
Earth earth_at(TtDate tt) {
  Earth earth{};
  eraEpv00(tt.day, tt.fraction, earth.heliocentric, earth.barycentric);
  return earth;
}

Vec3 body_at(Body body, TtDate tt) {
  const Earth earth = earth_at(tt);
  const Vec3 barycentric = vec(earth.barycentric[0]);
  if (body == Body::sun) return barycentric - vec(earth.heliocentric[0]);
  double geocentric[2][3];
  eraMoon98(tt.day, tt.fraction, geocentric);
  return barycentric + vec(geocentric[0]);
}

// What ERFA keeps of an observer at a moment: place, velocity, axes. The same steps as eraApco13,
// which takes UTC alone and so cannot serve before 1960. No polar motion, no refraction.
eraASTROM observer_at(const Instant& instant, const Site& site) {
  const TtDate tt = instant.tt();
  const Ut1Date ut1 = instant.ut1();
  Earth earth = earth_at(tt);
  double bias_precession_nutation[3][3], x = 0.0, y = 0.0;
  eraPnm06a(tt.day, tt.fraction, bias_precession_nutation);
  eraBpn2xy(bias_precession_nutation, &x, &y);
  const double s = eraS06(tt.day, tt.fraction, x, y);
  eraASTROM observer;
  eraApco(tt.day, tt.fraction, earth.barycentric, earth.heliocentric[0], x, y, s,
          eraEra00(ut1.day, ut1.fraction), degrees(site.longitude_deg).value,
          degrees(site.latitude_deg).value, site.height_m, 0.0, 0.0, eraSp00(tt.day, tt.fraction),
          0.0, 0.0, &observer);
  return observer;
}

// From the observer to where the body was when the light left it.
Vec3 seen_from(const eraASTROM& observer, Body body, TtDate tt) {
  Vec3 path = body_at(body, tt) - vec(observer.eb);
  // The bodies move 1e-4 of the light's path: two rounds leave 1e-12.
  for (int round = 0; round < 2; ++round) {
    const TtDate emitted{tt.day, tt.fraction - length(path) * light_days_per_au};
    path = body_at(body, emitted) - vec(observer.eb);
  }
  return path;
}

struct Sky {
  Angle azimuth, elevation;
};

// Aberration (the observer's velocity, that of the earth's turning included), then the axes of
// the date, then those of the site.
Sky on_sky(Vec3 from_observer, eraASTROM observer) {
  const Vec3 u = normalised(from_observer);
  double natural[3] = {u.x, u.y, u.z}, proper[3], intermediate[3];
  eraAb(natural, observer.v, observer.em, observer.bm1, proper);
  eraRxp(observer.bpn, proper, intermediate);
  double right_ascension = 0.0, declination = 0.0;
  eraC2s(intermediate, &right_ascension, &declination);
  std::array<double, 5> observed{};  // azimuth, zenith distance, and three not used here
  eraAtioq(right_ascension, declination, &observer, &observed[0], &observed[1], &observed[2],
           &observed[3], &observed[4]);
  return {Angle{eraAnp(observed[0])}, Angle{ERFA_DPI / 2.0 - observed[1]}};
}

BodyPosition position(const Sky& sky, double distance_au, double radius_m, const AirAtSite& air) {
  BodyPosition body;
  body.azimuth = sky.azimuth;
  body.elevation = sky.elevation;
  body.apparent_elevation = sky.elevation + refraction(sky.elevation, air);
  body.distance = Metres{distance_au * astro::astronomical_unit_m};
  body.angular_radius = Angle{std::asin(radius_m / body.distance.value)};
  body.direction_enu = direction_enu(sky.azimuth.value, sky.elevation.value);
  return body;
}

MoonPhase phase_of(Vec3 moon_to_sun, Vec3 moon_to_observer) {
  const double sine = length(cross(moon_to_sun, moon_to_observer));
  const Angle phase{std::atan2(sine, dot(moon_to_sun, moon_to_observer))};
  return {phase, illuminated_fraction(phase)};
}

}  // namespace

double illuminated_fraction(Angle phase) noexcept { return (1.0 + std::cos(phase.value)) / 2.0; }

SunAndMoon sun_and_moon(const Instant& instant, const Site& site, const AirAtSite& air) {
  const eraASTROM observer = observer_at(instant, checked(site));
  const TtDate tt = instant.tt();
  const Vec3 to_sun = body_at(Body::sun, tt) - vec(observer.eb);
  const Vec3 to_moon = body_at(Body::moon, tt) - vec(observer.eb);
  const Sky sun = on_sky(seen_from(observer, Body::sun, tt), observer);
  const Sky moon = on_sky(seen_from(observer, Body::moon, tt), observer);
  return {position(sun, length(to_sun), astro::solar_radius_m, air),
          position(moon, length(to_moon), astro::lunar_radius_m, air),
          phase_of(to_sun - to_moon, -to_moon)};
}

}  // namespace nadir::ephemeris
