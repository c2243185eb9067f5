#pragma once

#include "core/quantity.hpp"
#include "core/vec.hpp"
#include "ephemeris/instant.hpp"
#include "ephemeris/lunar_geometry.hpp"
#include "ephemeris/refraction.hpp"
#include "ephemeris/site.hpp"

namespace nadir::ephemeris {

/// Where an observer sees the centre of a body: topocentric, light time and aberration included.
/// The distance is that of the instant. Between the observer now and the body when the light left,
/// it would depend on the frame: by 38 km for the moon, the earth's own way in that time.
struct BodyPosition {
  Angle azimuth;             ///< clockwise from north, 0 <= azimuth < 2 pi
  Angle elevation;           ///< above the plane normal to the ellipsoid, without refraction
  Angle apparent_elevation;  ///< the same, lifted by refraction
  Metres distance;           ///< from the observer, at the instant
  Angle angular_radius;      ///< asin(radius / distance)
  Vec3 direction_enu;        ///< unit vector in the site's axes, without refraction
};

/// How much of the moon's disc the sun lights, from the places of the instant: without light time
/// and aberration, which would change the angle by up to 20 arcsec, the fraction by 5e-5.
struct MoonPhase {
  Angle phase_angle;                ///< sun - moon - observer, at the moon: 0 full, pi new
  double illuminated_fraction = 0;  ///< of the disc's area, (1 + cos phase) / 2
};

struct SunAndMoon {
  BodyPosition sun;
  BodyPosition moon;
  MoonPhase phase;
  LunarGeometry lunar;  ///< as seen from the site
};

/// The celestial pole of a date, precession and nutation (IAU 2006/2000A): the dear part of a
/// position. It moves by 0.3 arcsec a day at most.
struct CelestialPole {
  double x = 0.0, y = 0.0;  ///< of the celestial intermediate pole
  double s = 0.0;           ///< CIO locator, rad
  double sp = 0.0;          ///< TIO locator, rad
};
[[nodiscard]] CelestialPole celestial_pole(TtDate tt);

/// The fraction of a distant sphere's disc that is lit, (1 + cos phase) / 2.
[[nodiscard]] double illuminated_fraction(Angle phase) noexcept;

/// Sun and moon as seen from a site.
///
/// Positions: Earth from VSOP2000 (abridged), moon from ELP2000-82 (abridged by Meeus);
/// precession and nutation IAU 2006/2000A; light time, aberration, the observer's own motion and
/// parallax. Not in it: polar motion (0.6 arcsec), deflection of light.
///
/// @param air  for `apparent_elevation` alone
/// Accuracy, 1900 to 2100, without refraction and with UT1 known: sun 0.1 arcsec and 15 km, moon
/// 20 arcsec and 15 km (largest measured against JPL DE423: 0.012 and 8.4 arcsec, 6 km), phase
/// angle 20 arcsec; oracle_test.cpp, docs/ephemeris.md. Source: ERFA 2.0 (IAU SOFA). About 1 ms.
/// @throws InputError for a site outside its ranges
[[nodiscard]] SunAndMoon sun_and_moon(const Instant& instant, const Site& site,
                                      const AirAtSite& air = {});

/// The same with a pole of that day, for many instants within it. About 0.1 ms.
[[nodiscard]] SunAndMoon sun_and_moon(const Instant& instant, const Site& site,
                                      const AirAtSite& air, const CelestialPole& pole);

/// Where the earth's shadow falls, as seen from the centre of the earth: light time and aberration
/// included.
struct ShadowGeometry {
  Angle offset;          ///< of the moon's centre from the point opposite the sun
  Metres moon_distance;  ///< from the earth's centre
  Metres sun_distance;   ///< from the earth's centre
};

[[nodiscard]] ShadowGeometry earth_shadow(const Instant& instant);

}  // namespace nadir::ephemeris
