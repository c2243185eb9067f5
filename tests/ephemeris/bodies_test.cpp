#include "ephemeris/bodies.hpp"

#include <cmath>
#include <limits>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "support/catch.hpp"

namespace {

using namespace nadir;
using namespace nadir::ephemeris;
using spectral::Curve;
using spectral::Outside;

BodyPosition at_distance(double metres) {
  BodyPosition body;
  body.distance = Metres{metres};
  body.angular_radius = 0.266_deg;
  body.direction_enu = {0.6, 0.0, 0.8};
  return body;
}

Curve table(Outside outside) { return {{0.5, 1.0}, {1900.0, 700.0}, outside}; }

}  // namespace

TEST_CASE("the sun's irradiance falls with the square of the distance", "[ephemeris][bodies]") {
  const LightSource near = sun_light(at_distance(astro::astronomical_unit_m), table(Outside::zero));
  const LightSource far =
      sun_light(at_distance(2.0 * astro::astronomical_unit_m), table(Outside::zero));
  CHECK(near.name == "sun");
  CHECK(near.direction_enu == Vec3{0.6, 0.0, 0.8});
  CHECK(near.angular_radius == 0.266_deg);
  CHECK(near.irradiance.at(0.75_um) == Approx(1300.0).epsilon(1e-14));
  CHECK(far.irradiance.at(0.75_um) == Approx(325.0).epsilon(1e-14));
  // the same through the solid angle: E = L pi sin^2(radius), and L does not change with distance
  const double ratio = far.irradiance.at(1.0_um) / near.irradiance.at(1.0_um);
  const auto sine2 = [](double d) { return std::pow(astro::solar_radius_m / d, 2.0); };
  CHECK(ratio == Approx(sine2(2.0 * astro::astronomical_unit_m) / sine2(astro::astronomical_unit_m))
                     .epsilon(1e-14));
}

TEST_CASE("a constant irradiance stays constant", "[ephemeris][bodies]") {
  const LightSource sun =
      sun_light(at_distance(2.0 * astro::astronomical_unit_m), Curve::constant(8.0));
  CHECK(sun.irradiance.is_constant());
  CHECK(sun.irradiance.at(0.55_um) == Approx(2.0).epsilon(1e-14));
}

TEST_CASE("a scaled irradiance keeps its rule outside the table", "[ephemeris][bodies]") {
  const BodyPosition far = at_distance(2.0 * astro::astronomical_unit_m);
  const auto outside = [&](const Curve& curve, Micrometres wavelength) {
    return sun_light(far, curve).irradiance.at(wavelength);
  };
  CHECK(std::isnan(outside(table(Outside::reject), 0.4_um)));
  CHECK(std::isnan(outside(table(Outside::reject), 1.1_um)));
  CHECK(outside(table(Outside::zero), 0.4_um) == 0.0);
  CHECK(outside(table(Outside::zero), 1.1_um) == 0.0);
  CHECK(outside(table(Outside::hold), 0.4_um) == Approx(475.0).epsilon(1e-14));
  CHECK(outside(table(Outside::hold), 1.1_um) == Approx(175.0).epsilon(1e-14));
  const Curve ends_in_zero{{0.5, 1.0}, {1900.0, 0.0}, Outside::hold};
  CHECK(outside(ends_in_zero, 0.4_um) == Approx(475.0).epsilon(1e-14));
  CHECK(outside(ends_in_zero, 1.1_um) == 0.0);
}

TEST_CASE("the moon lights only where its irradiance is given", "[ephemeris][bodies]") {
  SunAndMoon positions;
  positions.sun = at_distance(astro::astronomical_unit_m);
  positions.moon = at_distance(384.4e6);
  CHECK(illumination(positions, table(Outside::zero)).size() == 1);
  const Illumination both = illumination(positions, table(Outside::zero), Curve::constant(1e-3));
  REQUIRE(both.size() == 2);
  CHECK(both[0].name == "sun");
  CHECK(both[1].name == "moon");
  CHECK(both[1].irradiance.at(0.55_um) == 1e-3);  // as given, not scaled
}

TEST_CASE("an eclipse takes its share of a body's light", "[ephemeris][bodies]") {
  const Eclipse half{{0.5, 0.4}, 0.0, 0.6};
  const BodyPosition at_1au = at_distance(astro::astronomical_unit_m);
  const Curve sun = table(Outside::reject);
  const LightSource eclipsed = sun_light(at_1au, sun, half);
  for (const Micrometres wavelength : {0.5_um, 0.62_um, 1.0_um}) {
    // 4 % steps of the factor's table, straight between
    CHECK(eclipsed.irradiance.at(wavelength) ==
          Approx(sun.at(wavelength) * half.factor(wavelength)).epsilon(1e-4));
  }
  CHECK(std::isnan(eclipsed.irradiance.at(1.1_um)));
  CHECK(eclipsed.angular_radius == at_1au.angular_radius);
  const LightSource moon = moon_light(at_distance(384.4e6), Curve::constant(1e-3), half);
  CHECK(moon.irradiance.at(0.55_um) == Approx(1e-3 * half.factor(0.55_um)).epsilon(1e-3));
}

TEST_CASE("both bodies in one place are a total eclipse, whose moon stays as given",
          "[ephemeris][bodies]") {
  SunAndMoon positions;
  positions.sun = at_distance(astro::astronomical_unit_m);
  positions.moon = at_distance(384.4e6);
  positions.moon.angular_radius = 0.27_deg;
  const Illumination both = illumination(positions, table(Outside::zero), Curve::constant(1e-3));
  CHECK(both[0].irradiance.max_value() == 0.0);
  CHECK(both[1].irradiance.at(0.55_um) == 1e-3);
}

TEST_CASE("a fixed body stands where it is put", "[ephemeris][bodies]") {
  const LightSource east =
      fixed_light({"lamp", 90.0_deg, 30.0_deg, 0.25_deg}, Curve::constant(5.0));
  CHECK(east.name == "lamp");
  CHECK(east.direction_enu.x == Approx(std::sqrt(0.75)).epsilon(1e-14));
  CHECK(east.direction_enu.y == Approx(0.0).margin(1e-15));
  CHECK(east.direction_enu.z == Approx(0.5).epsilon(1e-14));
  CHECK(east.irradiance.at(10.0_um) == 5.0);
  CHECK(
      fixed_light({"zenith", 0.0_deg, 90.0_deg, 0.25_deg}, Curve::constant(5.0)).direction_enu.z ==
      1.0);
}

TEST_CASE("a fixed body outside the sky is refused with every mistake", "[ephemeris][bodies]") {
  CHECK_THROWS_WITH(
      fixed_light({"lamp", Angle{std::numeric_limits<double>::infinity()}, Angle{2.0}, 0.0_deg},
                  Curve::constant(-5.0)),
      "error: azimuth of \"lamp\" is inf deg, expected a finite number\n"
      "error: elevation of \"lamp\" is 114.59155902616465 deg, allowed range is "
      "[-90, 90]\n"
      "error: angular radius of \"lamp\" is 0 deg, expected more than 0 and less "
      "than 90\n"
      "error: irradiance of \"lamp\" is -5 at its lowest, expected 0 or more "
      "everywhere\n");
  CHECK_THROWS_WITH(moon_light(at_distance(384.4e6), Curve::constant(-1.0)),
                    "error: irradiance of \"moon\" is -1 at its lowest, expected 0 or more "
                    "everywhere\n");
}
