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

Metres metres(double au) { return Metres{au * astro::astronomical_unit_m}; }
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

// Where a body was some days before a moment whose earth is given. In the 1.3 s of the moon's light
// the earth leaves its straight line by 1 cm; in the 500 s of the sun's the earth's two places
// leave theirs together, and the sun is their difference.
Vec3 body_before(Body body, TtDate tt, const Earth& earth, double days) {
  const Vec3 barycentric = vec(earth.barycentric[0]) - days * vec(earth.barycentric[1]);
  if (body == Body::sun) {
    return barycentric - (vec(earth.heliocentric[0]) - days * vec(earth.heliocentric[1]));
  }
  double geocentric[2][3];
  eraMoon98(tt.day, tt.fraction - days, geocentric);
  return barycentric + vec(geocentric[0]);
}

// What ERFA keeps of an observer at a moment: place, velocity, axes. The same steps as eraApco13,
// which takes UTC alone and so cannot serve before 1960. No polar motion, no refraction.
eraASTROM observer_at(const Instant& instant, const Site& site, const CelestialPole& pole,
                      Earth earth) {
  const Ut1Date ut1 = instant.ut1();
  eraASTROM observer;
  eraApco(instant.tt().day, instant.tt().fraction, earth.barycentric, earth.heliocentric[0], pole.x,
          pole.y, pole.s, eraEra00(ut1.day, ut1.fraction), degrees(site.longitude_deg).value,
          degrees(site.latitude_deg).value, site.height_m, 0.0, 0.0, pole.sp, 0.0, 0.0, &observer);
  return observer;
}

// From an observer now to a body now, and to where it was when the light left it.
struct Paths {
  Vec3 now, seen;
};

Paths paths_to(Body body, Vec3 observer, TtDate tt, const Earth& earth) {
  const Vec3 now = body_before(body, tt, earth, 0.0) - observer;
  // The bodies move 1e-4 of the light's path while it is under way: one round leaves 1e-8 rad.
  const double under_way_days = length(now) * light_days_per_au;
  return {now, body_before(body, tt, earth, under_way_days) - observer};
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
  body.distance = metres(distance_au);
  body.angular_radius = Angle{std::asin(radius_m / body.distance.value)};
  body.direction_enu = direction_enu(sky.azimuth.value, sky.elevation.value);
  return body;
}

}  // namespace

double illuminated_fraction(Angle phase) noexcept { return (1.0 + std::cos(phase.value)) / 2.0; }

CelestialPole celestial_pole(TtDate tt) {
  double bias_precession_nutation[3][3];
  CelestialPole pole;
  eraPnm06a(tt.day, tt.fraction, bias_precession_nutation);
  eraBpn2xy(bias_precession_nutation, &pole.x, &pole.y);
  pole.s = eraS06(tt.day, tt.fraction, pole.x, pole.y);
  pole.sp = eraSp00(tt.day, tt.fraction);
  return pole;
}

SunAndMoon sun_and_moon(const Instant& instant, const Site& site, const AirAtSite& air,
                        const CelestialPole& pole) {
  const TtDate tt = instant.tt();
  const Earth earth = earth_at(tt);
  const eraASTROM observer = observer_at(instant, checked(site), pole, earth);
  const Paths to_sun = paths_to(Body::sun, vec(observer.eb), tt, earth);
  const Paths to_moon = paths_to(Body::moon, vec(observer.eb), tt, earth);
  const Sky sun = on_sky(to_sun.seen, observer), moon = on_sky(to_moon.seen, observer);
  constexpr double au = astro::astronomical_unit_m;
  const LunarGeometry lunar =
      lunar_geometry(au * (to_sun.now - to_moon.now), -au * to_moon.now, tt);
  return {position(sun, length(to_sun.now), astro::solar_radius_m, air),
          position(moon, length(to_moon.now), astro::lunar_radius_m, air),
          {lunar.phase, illuminated_fraction(lunar.phase)},
          lunar};
}

SunAndMoon sun_and_moon(const Instant& instant, const Site& site, const AirAtSite& air) {
  return sun_and_moon(instant, site, air, celestial_pole(instant.tt()));
}

// Aberration to first order, which is 1e-8 rad short.
ShadowGeometry earth_shadow(const Instant& instant) {
  const TtDate tt = instant.tt();
  const Earth earth = earth_at(tt);
  const Vec3 place = vec(earth.barycentric[0]);
  const Vec3 velocity = vec(earth.barycentric[1]) * light_days_per_au;  // of that of light
  const Paths to_sun = paths_to(Body::sun, place, tt, earth);
  const Paths to_moon = paths_to(Body::moon, place, tt, earth);
  const Vec3 sun = normalised(to_sun.seen) + velocity, moon = normalised(to_moon.seen) + velocity;
  const Angle offset{std::atan2(length(cross(sun, moon)), -dot(sun, moon))};
  return {offset, metres(length(to_moon.now)), metres(length(to_sun.now))};
}

}  // namespace nadir::ephemeris
