#include "ephemeris/lunar_geometry.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace nadir::ephemeris {
namespace {

// One argument E = at_epoch + rate d, and its share in the pole and the meridian; degrees, d days
// of TDB (here TT: 2 ms) from J2000.
struct Term {
  double at_epoch, rate;
  double right_ascension, declination, meridian;  // sine, cosine, sine
};

constexpr std::array<Term, 13> terms{{
    {125.045, -0.0529921, -3.8787, 1.5419, 3.5610},
    {250.089, -0.1059842, -0.1204, 0.0239, 0.1208},
    {260.008, 13.0120009, 0.0700, -0.0278, -0.0642},
    {176.625, 13.3407154, -0.0172, 0.0068, 0.0158},
    {357.529, 0.9856003, 0.0, 0.0, 0.0252},
    {311.589, 26.4057084, 0.0072, -0.0029, -0.0066},
    {134.963, 13.0649930, 0.0, 0.0009, -0.0047},
    {276.617, 0.3287146, 0.0, 0.0, -0.0046},
    {34.226, 1.7484877, 0.0, 0.0, 0.0028},
    {15.134, -0.1589763, -0.0052, 0.0008, 0.0052},
    {119.743, 0.0036096, 0.0, 0.0, 0.0040},
    {239.961, 0.1643573, 0.0, 0.0, 0.0019},
    {25.053, 12.9590088, 0.0043, -0.0009, -0.0044},
}};

struct Orientation {
  Angle right_ascension, declination;  // of the north pole
  Angle meridian;                      // of the prime meridian, from the node on the ICRS equator
};

Orientation orientation(double days) {
  const double centuries = days / 36525.0;
  double right_ascension = 269.9949 + 0.0031 * centuries;
  double declination = 66.5392 + 0.0130 * centuries;
  double meridian = 38.3213 + (13.17635815 - 1.4e-12 * days) * days;
  for (const Term& term : terms) {
    const double e = degrees(std::fmod(term.at_epoch + term.rate * days, 360.0)).value;
    right_ascension += term.right_ascension * std::sin(e);
    declination += term.declination * std::cos(e);
    meridian += term.meridian * std::sin(e);
  }
  return {degrees(right_ascension), degrees(declination), degrees(std::fmod(meridian, 360.0))};
}

}  // namespace

Selenographic selenographic(Vec3 from_moon, TtDate tt) noexcept {
  constexpr double j2000 = 2451545.0;
  const Orientation moon = orientation((tt.day - j2000) + tt.fraction);
  const double a = moon.right_ascension.value, d = moon.declination.value;
  const Vec3 pole{std::cos(d) * std::cos(a), std::cos(d) * std::sin(a), std::sin(d)};
  const Vec3 node{-std::sin(a), std::cos(a), 0.0};  // 90 degrees east of the pole on the equator
  const Vec3 u = normalised(from_moon);
  const double from_node = std::atan2(dot(u, cross(pole, node)), dot(u, node));
  const double longitude = std::remainder(from_node - moon.meridian.value, 2.0 * std::numbers::pi);
  return {Angle{longitude}, Angle{std::asin(dot(u, pole))}};
}

LunarGeometry lunar_geometry(Vec3 moon_to_sun, Vec3 moon_to_observer, TtDate tt) noexcept {
  const double sine = length(cross(moon_to_sun, moon_to_observer));
  return {Angle{std::atan2(sine, dot(moon_to_sun, moon_to_observer))},
          selenographic(moon_to_sun, tt), selenographic(moon_to_observer, tt),
          Metres{length(moon_to_sun)}, Metres{length(moon_to_observer)}};
}

}  // namespace nadir::ephemeris
