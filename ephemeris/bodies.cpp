#include "ephemeris/bodies.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "core/frame.hpp"
#include "ephemeris/curve_product.hpp"
#include "ephemeris/number_text.hpp"

namespace nadir::ephemeris {
namespace {

using spectral::Curve;

Curve scaled(const Curve& curve, double factor) {
  if (curve.is_constant()) return Curve::constant(curve.max_value() * factor);
  std::vector<double> values = curve.values();
  for (double& value : values) value *= factor;
  return {curve.wavelengths_um(), std::move(values), outside_of(curve)};
}

// Ends beyond what any scene asks for, steps of 4 %: the reddest of eclipses is smooth over them.
std::vector<double> eclipse_grid_um() {
  constexpr int points = 121;
  constexpr double first_um = 0.2, last_um = 20.0;
  std::vector<double> um;
  for (int i = 0; i < points; ++i) {
    um.push_back(first_um * std::pow(last_um / first_um, i / (points - 1.0)));
  }
  return um;
}

Curve eclipsed(const Curve& curve, const Eclipse& eclipse) {
  if (!eclipse.any()) return curve;
  return product(curve, eclipse_grid_um(), [&](Micrometres um) { return eclipse.factor(um); });
}

InputIssue mistake(const char* quantity, const std::string& name, double value,
                   const char* problem) {
  InputIssue issue;
  issue.message = std::string{quantity} + " of \"" + name + "\" is " + number_text(value) + problem;
  return issue;
}

constexpr const char* negative = " at its lowest, expected 0 or more everywhere";

LightSource source(const std::string& name, const BodyPosition& body, Curve irradiance) {
  const double lowest = irradiance.min_value();
  if (lowest < 0.0) throw InputError{mistake("irradiance", name, lowest, negative)};
  return {name, body.direction_enu, body.angular_radius, std::move(irradiance)};
}

}  // namespace

LightSource sun_light(const BodyPosition& sun, const Curve& irradiance_1au,
                      const Eclipse& eclipse) {
  const double distance_au = sun.distance.value / astro::astronomical_unit_m;
  return source("sun", sun,
                eclipsed(scaled(irradiance_1au, 1.0 / (distance_au * distance_au)), eclipse));
}

LightSource moon_light(const BodyPosition& moon, const Curve& irradiance, const Eclipse& eclipse) {
  return source("moon", moon, eclipsed(irradiance, eclipse));
}

Illumination illumination(const SunAndMoon& positions, const Curve& solar_irradiance_1au,
                          const std::optional<Curve>& moon_irradiance) {
  Illumination bodies{sun_light(positions.sun, solar_irradiance_1au, solar_eclipse(positions))};
  if (moon_irradiance) bodies.push_back(moon_light(positions.moon, *moon_irradiance));
  return bodies;
}

LightSource fixed_light(const FixedBody& body, const Curve& irradiance) {
  const double elevation_deg = to_degrees(body.elevation);
  const double radius_deg = to_degrees(body.angular_radius);
  const double lowest = irradiance.min_value();
  std::vector<InputIssue> issues;
  const auto check = [&](bool legal, const char* quantity, double value, const char* problem) {
    if (!legal) issues.push_back(mistake(quantity, body.name, value, problem));
  };
  check(std::isfinite(body.azimuth.value), "azimuth", to_degrees(body.azimuth),
        " deg, expected a finite number");
  // a rounding of margin: 90 degrees may come back from radians as 90.00000000000001
  check(std::abs(elevation_deg) <= 90.0 + 1e-12, "elevation", elevation_deg,
        " deg, allowed range is [-90, 90]");
  check(radius_deg > 0.0 && radius_deg < 90.0, "angular radius", radius_deg,
        " deg, expected more than 0 and less than 90");
  check(lowest >= 0.0, "irradiance", lowest, negative);
  if (!issues.empty()) throw InputError{std::move(issues)};
  return {body.name, direction_enu(body.azimuth.value, body.elevation.value), body.angular_radius,
          irradiance};
}

}  // namespace nadir::ephemeris
