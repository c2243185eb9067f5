#include "atmosphere/paths/ray_bending.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/error.hpp"
#include "ephemeris/refraction.hpp"
#include "support/catch.hpp"

namespace {

using namespace nadir;
using namespace nadir::atmosphere;

constexpr double degree = std::numbers::pi / 180.0, arcsecond = degree / 3600.0;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// Dry standard atmosphere (ISO 2533, US 1976): 6.5 K/km up to 11 km, 216.65 K to 20 km, then
/// warmer by 1 K/km, 2.8 K/km; hydrostatic. Levels as close as `step_m`.
Profile standard_air(double step_m = 250.0, double offset_k = 0.0) {
  struct Base {
    double height_m, lapse_k_m;
  };
  const std::vector<Base> bases{{0.0, -0.0065}, {11e3, 0.0},     {20e3, 0.001},  {32e3, 0.0028},
                                {47e3, 0.0},    {51e3, -0.0028}, {71e3, -0.002}, {85e3, 0.0}};
  constexpr double hydrostatic = 9.80665 * 0.0289644 / 8.31446;  // K/m
  Profile profile{"standard", {}};
  double t = 288.15 + offset_k, p = 1013.25, z = 0.0;
  std::size_t k = 0;
  while (z <= 85e3) {
    profile.levels.push_back({z, p, t, {}});
    // In geopotential metres: gravity falls with height.
    const double r = earth_radius_m, next = z + step_m;
    const double lapse = bases[k].lapse_k_m;
    const double rise = r * next / (r + next) - r * z / (r + z);
    const double warmer = t + lapse * rise;
    p *= lapse == 0.0 ? std::exp(-hydrostatic * rise / t)
                      : std::pow(warmer / t, -hydrostatic / lapse);
    t = warmer;
    z = next;
    if (k + 1 < bases.size() && r * z / (r + z) >= bases[k + 1].height_m) ++k;
  }
  return profile;
}

Profile vacuum() {
  return {"nearly nothing", {{0.0, 1e-12, 288.15, {}}, {50e3, 1e-13, 288.15, {}}}};
}

double lift(const Refractivity& air, double elevation_deg, double height_m = 0.0) {
  const auto lifted = lift_rad(air, 0.0, {height_m, std::sin(elevation_deg * degree)});
  REQUIRE(lifted.has_value());
  return lifted.value_or(0.0);
}

Vec3 towards(double elevation_deg) {
  return {0.0, std::cos(elevation_deg * degree), std::sin(elevation_deg * degree)};
}

double height(Vec3 p) { return std::hypot(p.x, p.y, p.z + earth_radius_m) - earth_radius_m; }

/// Distance of a point from a chain.
double off_chain(const BentPath& path, Vec3 p) {
  double least = infinite;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    const Vec3 a = path.points[i].position, ab = path.points[i + 1].position - a;
    const double at = std::clamp(dot(p - a, ab) / dot(ab, ab), 0.0, 1.0);
    least = std::min(least, length(p - a - ab * at));
  }
  return least;
}

}  // namespace

// refractiveindex.info, Ciddor 1996: n = 1.00027717 at 0.5876 um (15 C, 450 ppm of CO2).
TEST_CASE("standard air has its published refractivity", "[atmosphere][paths]") {
  CHECK(standard_refractivity(Micrometres{0.5876}) == Approx(2.7717e-4).epsilon(3e-5));
  CHECK(standard_refractivity(Micrometres{10.0}) == Approx(2.7262e-4).epsilon(1e-4));
  const Refractivity air{standard_air(), Micrometres{0.5876}};
  CHECK(air.at(0.0) == Approx(standard_refractivity(Micrometres{0.5876})).epsilon(1e-12));
  CHECK(air.at(85.5e3) == 0.0);
}

// Birch & Downs 1993: 1000 Pa of vapour at 20 C lower n - 1 at 0.633 um by 3.6e-7.
TEST_CASE("vapour lowers the refractivity", "[atmosphere][paths]") {
  Profile moist = standard_air();
  moist.levels.front().temperature_k = 293.15;
  const Refractivity dry{moist, Micrometres{0.633}};
  moist.levels.front().ppmv[static_cast<std::size_t>(Gas::h2o)] = 1e6 * 1000.0 / 100325.0;
  const Refractivity wet{moist, Micrometres{0.633}};
  CHECK(dry.at(0.0) - wet.at(0.0) == Approx(3.63e-7).epsilon(0.01));
}

TEST_CASE("refractivity refuses levels that make no air", "[atmosphere][paths]") {
  Profile bad = standard_air();
  std::swap(bad.levels[3], bad.levels[4]);
  CHECK_THROWS_AS((Refractivity{bad, Micrometres{0.5}}), InputError);
  bad = standard_air();
  bad.levels[2].temperature_k = 0.0;
  CHECK_THROWS_AS((Refractivity{bad, Micrometres{0.5}}), InputError);
  bad.levels.resize(1);
  CHECK_THROWS_AS((Refractivity{bad, Micrometres{0.5}}), InputError);
}

// Pulkovo refraction tables (Abalakin, 5th ed., 1985) at 15 C, 1013.25 hPa, 0.590 um, dry, sea
// level: 1977.971" on the horizon; above, J.-M. Baillard's fit to them within 0.29". Measured: 2.4"
// apart on the horizon, 0.7" at 1 degree, 0.3" from 5 degrees up.
TEST_CASE("bodies are lifted as in the Pulkovo tables", "[atmosphere][paths]") {
  const Refractivity air{standard_air(), Micrometres{0.590}};
  for (const double h : {0.0, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 45.0, 70.0}) {
    const double argument = h + 4.2206 / (h + 15.1115 / (h + 5.9431));
    const double published = 3600.0 / 62.8093 / std::tan(argument * degree);
    CAPTURE(h, published, lift(air, h) / arcsecond);
    CHECK(lift(air, h) / arcsecond == Approx(published).epsilon(0.0015).margin(0.3));
  }
  CHECK(lift(air, 90.0) == Approx(0.0).margin(1e-12));
}

// The ephemeris' formula is for 0.55 um. The rule of the almanacs, 34', is for 10 C and 1010 hPa.
TEST_CASE("bodies are lifted as the ephemeris says", "[atmosphere][paths]") {
  const Refractivity air{standard_air(), Micrometres{0.55}};
  for (const double apparent : {5.0, 7.0, 10.0, 15.0, 30.0, 60.0}) {
    const double here = lift(air, apparent);
    const Angle there = ephemeris::refraction(degrees(apparent - here / degree));
    CAPTURE(apparent);
    CHECK((here - there.value) / arcsecond == Approx(0.0).margin(0.6));
  }
  Profile almanac = standard_air(250.0, -5.0);
  for (Level& level : almanac.levels) level.pressure_hpa *= 1010.0 / 1013.25;
  const Refractivity cool{almanac, Micrometres{0.59}};
  CHECK(lift(cool, 0.0) / arcsecond / 60.0 == Approx(34.0).epsilon(0).margin(0.5));
}

TEST_CASE("an eye above the ground sees bodies below its level", "[atmosphere][paths]") {
  const Refractivity air{standard_air(), Micrometres{0.55}};
  const double level = lift(air, 0.0, 10e3);
  CHECK(level < lift(air, 0.0));
  // 10 km up the ray goes down, through denser air, and up again.
  CHECK(lift(air, -2.0, 10e3) > level);
  CHECK(lift(air, -2.95, 10e3) / arcsecond > 3000.0);
  CHECK_FALSE(lift_rad(air, 0.0, {10e3, std::sin(-4.0 * degree)}).has_value());
  CHECK(lift(air, 1.0, 36e6) == 0.0);
  // The ray whose lowest point lies at 2 km: both ends together turn by twice what is seen there.
  const double r = earth_radius_m + 10e3, lowest = earth_radius_m + 2e3;
  const double sine = (1.0 + air.at(2e3)) * lowest / ((1.0 + air.at(10e3)) * r);
  const double dip = std::acos(sine) / degree;
  CHECK(lift(air, -dip, 10e3) + lift(air, dip, 10e3) ==
        Approx(2.0 * lift(air, 0.0, 2e3)).epsilon(2e-6));
}

// Level rays in a standard atmosphere turn k = -R dn/dz of the earth's own curvature: 0.17 for 6.5
// K/km in the visible (Brunner, Geodetic Refraction, 1984; 0.13 is Gauss' mean over daytime land).
TEST_CASE("level rays bend with the refraction coefficient of geodesy", "[atmosphere][paths]") {
  const Refractivity air{standard_air(), Micrometres{0.55}};
  const double k = -earth_radius_m * air.bending(0, 10.0);
  CHECK(k > 0.13);
  CHECK(k < 0.18);
  // After 20 km the ray lies s^2 (1 - k) / 2 R above the sphere of the eye.
  const BentPath path = bent_path(air, 0.0, {0.0, 0.0, 10.0}, towards(0.0), 20e3);
  const double rise = height(path.points.back().position) - 10.0;
  CHECK(rise == Approx(20e3 * 20e3 * (1.0 - k) / (2.0 * earth_radius_m)).epsilon(2e-3));
}

TEST_CASE("rays are straight where there is nearly no air", "[atmosphere][paths]") {
  const Refractivity air{vacuum(), Micrometres{0.55}};
  for (const double elevation : {-90.0, -30.0, -1.0, 0.0, 3.0, 90.0}) {
    const Vec3 direction = towards(elevation), eye{300.0, -50.0, 2000.0};
    CAPTURE(elevation);
    const BentPath path = bent_path(air, 0.0, eye, direction, 2100.0);
    CHECK(length(path.points.back().position - (eye + direction * 2100.0)) < 1e-7);
    CHECK(path.points.back().way_m == Approx(2100.0).epsilon(1e-12));
    // a cosine of nearly 1 gives the angle to 2e-8
    CHECK(length(path.end_direction - direction) < (std::abs(elevation) > 89.0 ? 2e-8 : 1e-12));
  }
}

// The product n r sin(zenith) is kept: the ray's equation by another route.
TEST_CASE("bent rays keep Bouguer's invariant", "[atmosphere][paths]") {
  const Refractivity air{standard_air(), Micrometres{0.55}};
  for (const double elevation : {-1.2, -0.5, 0.0, 1.0, 20.0, 80.0}) {
    const Vec3 eye{0.0, 0.0, 1500.0};
    const BentPath path = bent_path(air, 0.0, eye, towards(elevation), 80e3);
    const Vec3 centre{0.0, 0.0, -earth_radius_m};
    const auto invariant = [&](Vec3 p, Vec3 direction) {
      return (1.0 + air.at(height(p))) * length(cross(p - centre, direction));
    };
    CAPTURE(elevation);
    const double start = invariant(eye, towards(elevation));
    const double end = invariant(path.points.back().position, path.end_direction);
    CHECK(end == Approx(start).epsilon(1e-11));  // 0.06 mm of the lowest point's height
  }
}

TEST_CASE("a ray that is sent back comes home", "[atmosphere][paths]") {
  const Refractivity air{standard_air(), Micrometres{0.55}};
  for (const double elevation : {-50.0, -1.0, 0.0, 0.3, 30.0}) {
    const double reach = elevation < -10.0 ? 5e3 : 150e3;
    const Vec3 eye{0.0, 0.0, 4000.0};
    const BentPath out = bent_path(air, 0.0, eye, towards(elevation), reach);
    const Vec3 far = out.points.back().position;
    const BentPath back = bent_path(air, 0.0, far, -out.end_direction, reach);
    CAPTURE(elevation);
    CHECK(length(back.points.back().position - eye) < 1e-4);
    CHECK(length(back.end_direction + towards(elevation)) < 1e-9);
  }
}

// The truth: the same curve with chords of a few metres.
TEST_CASE("chains of pieces lie within their tolerance of the curve", "[atmosphere][paths]") {
  const Refractivity air{standard_air(), Micrometres{0.55}};
  for (const double reach : {2e3, 30e3, 300e3}) {
    for (const double elevation : {-0.9, 0.0, 2.0, 40.0}) {
      const Vec3 eye{0.0, 0.0, 1000.0};
      const BentPath path = bent_path(air, 0.0, eye, towards(elevation), reach);
      const double tolerance = std::max(bent_path_tolerance_m, bent_path_tolerance_share * reach);
      double most = 0.0;
      for (int i = 1; i < 40; ++i) {
        const BentPath part = bent_path(air, 0.0, eye, towards(elevation), reach * i / 40.0);
        const double far = path.points.back().way_m;
        if (part.points.back().way_m <= far) {
          most = std::max(most, off_chain(path, part.points.back().position));
        }
      }
      CAPTURE(reach, elevation, path.points.size());
      CHECK(most < tolerance);
      CHECK(path.points.size() < 200);
    }
  }
}

TEST_CASE("rays from space are straight down to the air", "[atmosphere][paths]") {
  const Refractivity air{standard_air(), Micrometres{0.55}};
  const Vec3 eye{0.0, 0.0, 800e3};
  const BentPath down = bent_path(air, 0.0, eye, {0.0, 0.0, -1.0}, 800e3);
  CHECK(length(down.points.back().position) < 1e-6);
  CHECK(down.points.size() <= 4);
  const BentPath away = bent_path(air, 0.0, eye, {0.0, 0.0, 1.0}, 1e6);
  CHECK(away.points.back().position == Vec3{0.0, 0.0, 1800e3});
  CHECK(bent_path(air, 0.0, eye, {0.0, 0.0, 1.0}, infinite).points.size() == 1);
  // out of the air the ray runs on straight
  const BentPath up = bent_path(air, 0.0, {}, towards(10.0), 2e6);
  CHECK(up.points.back().way_m == 2e6);
  const auto& last = up.points[up.points.size() - 2];
  CHECK(length(normalised(up.points.back().position - last.position) - up.end_direction) < 1e-9);
  // below the ground it stops
  const BentPath ends = bent_path(air, 0.0, {}, towards(-30.0), infinite);
  CHECK(height(ends.points.back().position) < -500.0);
  CHECK(bent_path(air, 0.0, {}, towards(0.0), 0.0).points.size() == 1);
}
