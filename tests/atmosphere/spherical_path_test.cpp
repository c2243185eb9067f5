#include "atmosphere/paths/spherical_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/catch.hpp"

namespace {

using namespace nadir::atmosphere;

constexpr double endless_m = std::numeric_limits<double>::infinity();

/// Height and cosine at a way along a line, from its coordinates in long double: 1e-12 m.
PathPoint by_coordinates(PathPoint start, double way_m) {
  const long double r0 = static_cast<long double>(earth_radius_m) + start.height_m;
  const long double mu = start.mu;
  const long double x = way_m * std::sqrt(1.0L - mu * mu), z = r0 + way_m * mu;
  const long double r = std::sqrt(x * x + z * z);
  // direction . radius
  const long double along = x * std::sqrt(1.0L - mu * mu) + z * mu;
  return {static_cast<double>(r - static_cast<long double>(earth_radius_m)),
          static_cast<double>(along / r)};
}

/// Levels every kilometre to 50 km, then to 100 km, from the top.
std::vector<double> shell_levels() {
  std::vector<double> z{100e3, 70e3};
  for (int km = 50; km >= 0; --km) z.push_back(1e3 * km);
  return z;
}

/// The air in thin even layers, as vertical depths for a total of 1.
struct Air {
  std::vector<double> level_m, depth;
  /// @param above  share of the air above a height
  template <class F>
  Air(F above, double step_m) {
    for (double z = 140e3; z > -0.5 * step_m; z -= step_m) level_m.push_back(std::max(z, 0.0));
    for (std::size_t k = 0; k + 1 < level_m.size(); ++k) {
      depth.push_back(above(level_m[k + 1]) - above(level_m[k]));
    }
  }
};

double sum_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum;
}

}  // namespace

// Coordinates in long double are good to 1e-12 m; double coordinates would be 1e-9 m off.
TEST_CASE("a point along a line has the height of its coordinates", "[atmosphere][paths]") {
  for (const double height_m : {0.0, 2.0, 1234.5, 800e3, 36e6}) {
    for (const double mu : {-1.0, -0.999999, -0.3, -1e-4, 0.0, 1e-9, 0.02, 0.7, 1.0}) {
      for (const double way_m : {1e-3, 1.0, 5e3, 4e5}) {
        CAPTURE(height_m, mu, way_m);
        const PathPoint there = advanced({height_m, mu}, way_m);
        const PathPoint expected = by_coordinates({height_m, mu}, way_m);
        // 1e-14 of the way, a rounding of the height, and the coordinates' own 2e-12 m
        CHECK(std::abs(there.height_m - expected.height_m) <=
              1e-14 * way_m + 4e-16 * height_m + 2e-12);
        CHECK(there.mu == Approx(expected.mu).epsilon(0).margin(4e-16));
      }
    }
  }
}

TEST_CASE("vertical ways are differences of height to the last digits", "[atmosphere][paths]") {
  CHECK(way_up_to_m({10.0, 1.0}, 10.001) == Approx(10.001 - 10.0).epsilon(1e-14));
  CHECK(way_down_to_m({36e6, -1.0}, 100e3) == Approx(35.9e6).epsilon(1e-15));
  CHECK(way_down_to_m({1.0, -1.0}, 0.999) == Approx(1.0 - 0.999).epsilon(1e-14));
  CHECK(way_to_end_m(1e5, 0.0, 0.0, 1.0) == Approx(1e5).epsilon(1e-15));
  CHECK(way_to_end_m(1e5, 120.0, 121.0, -1.0) == Approx(1.0).epsilon(1e-14));
}

// Tangent from a height h: sqrt(h (2 R + h)), dip acos(R / (R + h)).
TEST_CASE("the horizon lies at the tangent", "[atmosphere][paths]") {
  for (const double h : {0.001, 2.0, 1500.0, 12e3, 800e3, 36e6}) {
    CAPTURE(h);
    const double mu = horizon_mu(0.0, h), tangent_m = std::sqrt(h * (2.0 * earth_radius_m + h));
    CHECK(mu == Approx(-std::sin(std::acos(earth_radius_m / (earth_radius_m + h))))
                    .epsilon(h < 1.0 ? 1e-6 : 1e-9));  // acos near 1 loses half of the digits
    // a little below it meets the ground at about the tangent's way, a little above it never does
    CHECK(way_to_end_m(1e5, 0.0, h, mu * (1.0 + 1e-10)) == Approx(tangent_m).epsilon(1e-4));
    CHECK(way_down_to_m({h, mu * (1.0 - 1e-10)}, 0.0) < 0.0);
  }
  CHECK(horizon_mu(0.0, 0.0) == 0.0);
  CHECK(horizon_mu(100.0, 50.0) == 0.0);
}

TEST_CASE("ways end at the ground, at the top, or miss the air", "[atmosphere][paths]") {
  const double limb_m = std::sqrt(1e5 * (2.0 * earth_radius_m + 1e5));
  CHECK(way_to_end_m(1e5, 0.0, 0.0, 0.0) == Approx(limb_m).epsilon(1e-14));
  CHECK(way_to_end_m(1e5, 0.0, 0.0, -0.01) == 0.0);
  CHECK(way_to_end_m(1e5, 0.0, -3.0, -0.01) == 0.0);
  CHECK(way_to_end_m(1e5, 0.0, 1e5, 0.0) == 0.0);
  CHECK(way_to_end_m(1e5, 0.0, 36e6, 0.5) == 0.0);
  CHECK(way_to_end_m(1e5, 0.0, 36e6, -0.5) == 0.0);  // beside the earth
  CHECK(way_to_end_m(1e5, 0.0, -3.0, 1.0) == Approx(1e5 + 3.0));
}

TEST_CASE("the pieces of a path join and add up", "[atmosphere][paths]") {
  const auto z = shell_levels();
  for (const double height_m : {0.0, 1e-3, 1000.0, 1500.0, 50e3, 99e3, 100e3}) {
    for (const double mu : {-1.0, -0.6, -0.1, -0.01, -1e-3, 0.0, 1e-6, 0.3, 1.0}) {
      for (const double length_m : {1e-3, 700.0, 3e4, endless_m}) {
        CAPTURE(height_m, mu, length_m);
        double way = 0.0;
        PathPoint at{height_m, mu};
        for (const PathPiece& p : path_through(z, height_m, mu, length_m)) {
          CHECK(p.length_m > 0.0);
          CHECK(p.start_m == Approx(way).epsilon(1e-14).margin(1e-12));
          CHECK(p.height_in_m == Approx(at.height_m).epsilon(1e-12).margin(1e-9));
          CHECK(p.mu_in == Approx(at.mu).margin(1e-14));
          const auto k = static_cast<std::size_t>(p.layer);
          CHECK(std::min(p.height_in_m, p.height_out_m) >= z[k + 1]);
          CHECK(std::max(p.height_in_m, p.height_out_m) <= z[k]);
          CHECK(p.mu_in * p.mu_out >= 0.0);  // cut at the lowest point
          const PathPoint end = by_coordinates({height_m, mu}, p.start_m + p.length_m);
          CHECK(p.height_out_m == Approx(end.height_m).epsilon(0).margin(2e-8));
          way += p.length_m;
          at = {p.height_out_m, p.mu_out};
        }
        const double end_m = way_to_end_m(z.front(), z.back(), height_m, mu);
        CHECK(way == Approx(std::min(end_m, length_m)).epsilon(1e-13).margin(1e-12));
      }
    }
  }
}

TEST_CASE("a path that grazes a level stays above it", "[atmosphere][paths]") {
  const auto z = shell_levels();
  // lowest point 1 mm above the level at 10 km, seen from 20 km
  const double r = earth_radius_m + 20e3, lowest = earth_radius_m + 10e3 + 1e-3;
  const double mu = -std::sqrt((r - lowest) * (r + lowest)) / r;
  const auto pieces = path_through(z, 20e3, mu, endless_m);
  double least = endless_m;
  for (const PathPiece& p : pieces) least = std::min({least, p.height_in_m, p.height_out_m});
  CHECK(least == Approx(10e3 + 1e-3).epsilon(0).margin(1e-8));
  // ten layers down, all back up, and 10 to 20 km twice: the lowest layer in two pieces
  CHECK(pieces.size() == 10 + 42);
}

TEST_CASE("a vertical body is met through every depth above", "[atmosphere][paths]") {
  const std::vector<double> depth{0.1, 0.2, 0.4};
  const auto depths = slant_depths({3e3, 2e3, 1e3, 0.0}, depth, 1.0);
  REQUIRE(depths.size() == 4);
  CHECK(depths[0] == 0.0);
  CHECK(depths[1] == Approx(0.1).epsilon(1e-14));
  CHECK(depths[2] == Approx(0.3).epsilon(1e-14));
  CHECK(depths[3] == Approx(0.7).epsilon(1e-14));
}

// The same sum over the pieces of a path: another way through the code.
TEST_CASE("slant depths are those along the path to the body", "[atmosphere][paths]") {
  const auto z = shell_levels();
  std::vector<double> depth;
  for (std::size_t k = 0; k + 1 < z.size(); ++k) depth.push_back(0.01 * static_cast<double>(k + 1));
  for (const double mu0 : {-0.2, -0.09, -0.03, -1e-3, 0.0, 1e-3, 0.2, 1.0}) {
    const auto depths = slant_depths(z, depth, mu0);
    for (std::size_t level = 0; level < z.size(); ++level) {
      CAPTURE(mu0, z[level]);
      if (mu0 < 0.0 && mu0 <= horizon_mu(0.0, z[level])) {
        CHECK(std::isinf(depths[level]));
        continue;
      }
      double sum = 0.0;
      for (const PathPiece& p : path_through(z, z[level], mu0, endless_m)) {
        const auto k = static_cast<std::size_t>(p.layer);
        sum += depth[k] * p.length_m / (z[k] - z[k + 1]);
      }
      CHECK(depths[level] == Approx(sum).epsilon(1e-11).margin(1e-14));
    }
  }
}

// Straight lines through an exponential atmosphere: the Chapman function of X = R / H. For a body
// on the horizon it is exactly X e^X K1(X), sqrt(pi X / 2) (1 + 3 / 8 X - ...) (Chapman, Proc.
// Phys. Soc. 43, 483 (1931)); 37.2 for H = 7.2 km. Layers of 100 m, each with an even density, are
// 1e-4 off at the horizon.
TEST_CASE("an exponential atmosphere has Chapman's air mass", "[atmosphere][paths]") {
  const double scale_m = 7200.0, x = earth_radius_m / scale_m;
  const Air air{[&](double z) { return std::exp(-z / scale_m); }, 100.0};
  const double horizontal = slant_depths(air.level_m, air.depth, 0.0).back();
  const double expected = std::sqrt(0.5 * std::numbers::pi * x) * (1.0 + 3.0 / (8.0 * x));
  CHECK(horizontal == Approx(expected).epsilon(1e-3));
  CHECK(sum_of(air.depth) == Approx(1.0).epsilon(1e-6));
  // By quadrature over height at 80 degrees, in the variable z = scale * t^2.
  const double mu0 = std::cos(80.0 * std::numbers::pi / 180.0);
  double integral = 0.0;
  for (double t = 5e-4; t < 4.5; t += 1e-3) {
    const double z = scale_m * t * t;
    const double slant =
        1.0 /
        std::sqrt(1.0 - (1.0 - mu0 * mu0) * std::pow(earth_radius_m / (earth_radius_m + z), 2.0));
    integral += std::exp(-t * t) * slant * 2.0 * t * 1e-3;
  }
  CHECK(slant_depths(air.level_m, air.depth, mu0).back() == Approx(integral).epsilon(1e-4));
}

// Kasten & Young, Appl. Opt. 28, 4735 (1989), eq. 3: relative optical air mass of the ISO standard
// atmosphere 1972 against apparent elevation, within 0.5 % of their table. They follow bent rays,
// here they are straight: from 5 degrees up that is less than 0.5 %.
TEST_CASE("air masses are those of Kasten and Young", "[atmosphere][paths]") {
  // The standard's pressure: a gradient of 6.5 K/km up to 11 km, even temperature above.
  const auto pressure = [](double z) {
    return z < 11e3 ? std::pow(1.0 - z / 44330.8, 5.25588)
                    : 0.223361 * std::exp((11e3 - z) / 6341.62);
  };
  const Air air{pressure, 200.0};
  for (const double elevation : {90.0, 60.0, 30.0, 20.0, 10.0, 7.0, 5.0}) {
    CAPTURE(elevation);
    const double sine = std::sin(elevation * std::numbers::pi / 180.0);
    const double published = 1.0 / (sine + 0.50572 * std::pow(elevation + 6.07995, -1.6364));
    CHECK(slant_depths(air.level_m, air.depth, sine).back() / sum_of(air.depth) ==
          Approx(published).epsilon(0.01));
  }
  // 38 on the horizon for the bent ray; the straight one goes through less.
  const double horizontal = slant_depths(air.level_m, air.depth, 0.0).back();
  CHECK(horizontal > 34.0);
  CHECK(horizontal < 38.0);
}
