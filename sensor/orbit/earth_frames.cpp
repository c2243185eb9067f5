#include "sensor/orbit/earth_frames.hpp"

#include <cmath>
#include <numbers>

#include "ephemeris/sun_moon.hpp"

namespace nadir::sensor {
namespace {

constexpr double turn_rad = 2.0 * std::numbers::pi;
constexpr double j2000 = 2451545.0;
constexpr double radians_per_arcsecond = radians_per_degree / 3600.0;
constexpr Vec3 pole{0.0, 0.0, 1.0};

double in_one_turn(double turns) { return turn_rad * (turns - std::floor(turns)); }

/// The axes turned by an angle about x, y or z: a vector's components in the turned axes. The
/// matrices R1, R2 and R3 of the sources.
Mat3 axes_turned(Vec3 about, double angle_rad) { return rotation(about, -angle_rad); }

StateVector over_turning_earth(const StateVector& state, const Mat3& to_earth) {
  const Vec3 position = to_earth * state.position;
  return {position, to_earth * state.velocity - cross(earth_rate_rad_s * pole, position)};
}

/// IERS Conventions (2010), eq. 5.15.
double earth_rotation_angle(ephemeris::Ut1Date ut1) {
  const double days = (ut1.day - j2000) + ut1.fraction;
  const double day_share = std::fmod(ut1.day - j2000, 1.0) + ut1.fraction;
  return in_one_turn(0.7790572732640 + 0.00273781191135448 * days + day_share);
}

/// IERS Conventions (2010), eqs. 5.6 to 5.10: by the pole's place and the origin's.
Mat3 earth_from_gcrf(const ephemeris::Instant& time) {
  const ephemeris::CelestialPole at = ephemeris::celestial_pole(time.tt());
  const double e = std::atan2(at.y, at.x), sine2 = at.x * at.x + at.y * at.y;
  const double d = std::atan(std::sqrt(sine2 / (1.0 - sine2)));
  return axes_turned(pole, earth_rotation_angle(time.ut1()) + at.sp - (e + at.s)) *
         axes_turned({0.0, 1.0, 0.0}, d) * axes_turned(pole, e);
}

/// The bias of the frames: IERS Conventions (2010), eqs. 5.21, 5.33 and 5.34, as R3 R2 R1.
Mat3 gcrf_from_eme2000() {
  constexpr double obliquity = 84381.448 * radians_per_arcsecond;
  constexpr double longitude = -0.041775 * radians_per_arcsecond;
  constexpr double tilt = -0.0068192 * radians_per_arcsecond;
  constexpr double equinox = -0.0146 * radians_per_arcsecond;
  const Mat3 bias = axes_turned({1.0, 0.0, 0.0}, -tilt) *
                    axes_turned({0.0, 1.0, 0.0}, longitude * std::sin(obliquity)) *
                    axes_turned(pole, equinox);
  return bias.transposed();
}

}  // namespace

Angle mean_sidereal_time(ephemeris::Ut1Date ut1) noexcept {
  constexpr double days_per_century = 36525.0, seconds_per_day = 86400.0;
  const double t = ((ut1.day - j2000) + ut1.fraction) / days_per_century;
  // The 876600 hours are one turn a day: only the share of the day remains.
  const double day_share = std::fmod(ut1.day - j2000, 1.0) + ut1.fraction;
  const double seconds = 67310.54841 + t * (8640184.812866 + t * (0.093104 - t * 6.2e-6));
  return Angle{in_one_turn(seconds / seconds_per_day + day_share)};
}

StateVector ecef_from_teme(const StateVector& teme, const ephemeris::Instant& time) {
  return over_turning_earth(teme, axes_turned(pole, mean_sidereal_time(time.ut1()).value));
}

StateVector teme_from_ecef(const StateVector& ecef, const ephemeris::Instant& time) {
  const Mat3 to_sky = axes_turned(pole, mean_sidereal_time(time.ut1()).value).transposed();
  return {to_sky * ecef.position,
          to_sky * (ecef.velocity + cross(earth_rate_rad_s * pole, ecef.position))};
}

StateVector ecef_from_gcrf(const StateVector& gcrf, const ephemeris::Instant& time) {
  return over_turning_earth(gcrf, earth_from_gcrf(time));
}

StateVector ecef_from_eme2000(const StateVector& eme2000, const ephemeris::Instant& time) {
  const Mat3 to_gcrf = gcrf_from_eme2000();
  return ecef_from_gcrf({to_gcrf * eme2000.position, to_gcrf * eme2000.velocity}, time);
}

}  // namespace nadir::sensor
