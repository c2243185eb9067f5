#include "sensor/orbit/kepler_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "geometry/earth.hpp"

namespace nadir::sensor {
namespace {

// WGS84 (NIMA TR8350.2, 3rd ed.) and EGM96's J2.
constexpr double mu_m3_s2 = 3.986004418e14;
constexpr double equator_m = 6378137.0;
constexpr double j2 = 1.08262668e-3;

struct NamedRange {
  const char* name;
  double value, least, most;
  const char* text;
};

/// Every value outside its range; also those that are not finite.
void check_ranges(const std::vector<NamedRange>& values) {
  std::vector<InputIssue> issues;
  for (const NamedRange& v : values) {
    if (v.value >= v.least && v.value <= v.most) continue;
    issues.push_back(
        {{}, std::string{v.name} + " is " + number_text(v.value) + ", expected " + v.text, {}, {}});
  }
  if (!issues.empty()) throw InputError{issues};
}

/// Unit vectors towards the perigee and a quarter turn ahead, TEME.
struct OrbitPlane {
  Vec3 perigee, ahead, normal;
};

OrbitPlane plane_of(double inclination, double node, double perigee) {
  const double ci = std::cos(inclination), si = std::sin(inclination);
  const Vec3 to_node{std::cos(node), std::sin(node), 0.0};
  const Vec3 across{-ci * to_node.y, ci * to_node.x, si};
  const double c = std::cos(perigee), s = std::sin(perigee);
  return {c * to_node + s * across, c * across - s * to_node, cross(to_node, across)};
}

}  // namespace

KeplerElements checked(const KeplerElements& e) {
  constexpr double any_angle = 1e6;
  check_ranges(
      {{"the semi-major axis", e.semi_major_axis_m, equator_m, 1e9, "6378137 to 1e9 m"},
       {"the eccentricity", e.eccentricity, 0.0, std::nextafter(1.0, 0.0), "0 to below 1"},
       {"the inclination", e.inclination_deg, 0.0, 180.0, "0 to 180 degrees"},
       {"the ascending node", e.ascending_node_deg, -any_angle, any_angle, "an angle in degrees"},
       {"the argument of perigee", e.argument_of_perigee_deg, -any_angle, any_angle,
        "an angle in degrees"},
       {"the mean anomaly", e.mean_anomaly_deg, -any_angle, any_angle, "an angle in degrees"}});
  const double perigee_m = e.semi_major_axis_m * (1.0 - e.eccentricity);
  if (perigee_m < equator_m) {
    throw InputError{"the orbit's perigee lies " + number_text(std::round(equator_m - perigee_m)) +
                     " m below the earth's equatorial radius"};
  }
  return e;
}

SecularRates secular_rates(const KeplerElements& elements) noexcept {
  const double a = elements.semi_major_axis_m, e2 = elements.eccentricity * elements.eccentricity;
  const double i = degrees(elements.inclination_deg).value;
  const double n = std::sqrt(mu_m3_s2 / (a * a * a)), radii = equator_m / (a * (1.0 - e2));
  const double k = n * j2 * radii * radii, sine2 = std::sin(i) * std::sin(i);
  return {-1.5 * k * std::cos(i), 0.75 * k * (4.0 - 5.0 * sine2),
          n + 0.75 * k * std::sqrt(1.0 - e2) * (2.0 - 3.0 * sine2)};
}

// For 0 <= M <= pi the function E - e sin E - M is convex between 0 and pi, and not below 0 at the
// smaller of M + e and pi: from there Newton's steps fall to the root.
Angle eccentric_anomaly(Angle mean_anomaly, double e) noexcept {
  constexpr double pi = std::numbers::pi;
  const double m = std::remainder(mean_anomaly.value, 2.0 * pi), positive = std::abs(m);
  double anomaly = std::min(positive + e, pi);
  for (int i = 0; i < 50; ++i) {  // near the parabola's perigee each step takes a third off
    const double step =
        (anomaly - e * std::sin(anomaly) - positive) / (1.0 - e * std::cos(anomaly));
    anomaly -= step;
    if (std::abs(step) < 1e-14) break;
  }
  return Angle{mean_anomaly.value - m + std::copysign(anomaly, m)};
}

StateVector orbit_state(const KeplerElements& elements, const ephemeris::Instant& time) {
  const double t = (time - elements.epoch).value;
  const SecularRates rates = secular_rates(elements);
  const OrbitPlane plane =
      plane_of(degrees(elements.inclination_deg).value,
               degrees(elements.ascending_node_deg).value + rates.node * t,
               degrees(elements.argument_of_perigee_deg).value + rates.perigee * t);
  const double a = elements.semi_major_axis_m, e = elements.eccentricity;
  const double b = a * std::sqrt(1.0 - e * e);
  const double mean_anomaly = degrees(elements.mean_anomaly_deg).value + rates.mean_anomaly * t;
  const double anomaly = eccentric_anomaly(Angle{mean_anomaly}, e).value;
  const double c = std::cos(anomaly), s = std::sin(anomaly);
  const double anomaly_rate = rates.mean_anomaly / (1.0 - e * c);
  const Vec3 position = a * (c - e) * plane.perigee + b * s * plane.ahead;
  const Vec3 on_ellipse = anomaly_rate * (b * c * plane.ahead - a * s * plane.perigee);
  const Vec3 turning = rates.perigee * plane.normal + rates.node * Vec3{0.0, 0.0, 1.0};
  return ecef_from_teme({position, on_ellipse + cross(turning, position)}, time);
}

KeplerElements circular_orbit(const Overpass& overpass, const ephemeris::Instant& time) {
  check_ranges({{"the latitude", overpass.latitude_deg, -90.0, 90.0, "-90 to 90 degrees"},
                {"the longitude", overpass.longitude_deg, -360.0, 360.0, "-360 to 360 degrees"},
                {"the height of the orbit", overpass.height_m, 1.0, 1e9, "1 to 1e9 m"},
                {"the inclination", overpass.inclination_deg, 0.0, 180.0, "0 to 180 degrees"}});
  const geometry::LocalFrame above{
      {overpass.latitude_deg, overpass.longitude_deg, overpass.height_m}};
  const Vec3 at = teme_from_ecef({above.ecef({}), {}}, time).position;
  const double radius = length(at), sine_latitude = at.z / radius;
  const double i = degrees(overpass.inclination_deg).value, reach = std::sin(i);
  constexpr double rounding = 1e-12;  // 6 um on the ground: an orbit may just touch its latitude
  if (std::abs(sine_latitude) > reach + rounding) {
    throw InputError{
        "an orbit of inclination " + number_text(overpass.inclination_deg) +
        " degrees does not reach the latitude " + number_text(overpass.latitude_deg) +
        " degrees: the satellite's geocentric latitude there is " +
        number_text(std::round(1e5 * to_degrees(Angle{std::asin(sine_latitude)})) / 1e5)};
  }
  // From the node, along the orbit; an orbit in the equator's plane has its node where it is.
  const double rising =
      reach > rounding ? std::asin(std::clamp(sine_latitude / reach, -1.0, 1.0)) : 0.0;
  const double u = overpass.ascending ? rising : std::numbers::pi - rising;
  const double node = std::atan2(at.y, at.x) - std::atan2(std::cos(i) * std::sin(u), std::cos(u));
  return {time,
          radius,
          0.0,
          overpass.inclination_deg,
          to_degrees(Angle{node}),
          0.0,
          to_degrees(Angle{u})};
}

}  // namespace nadir::sensor
