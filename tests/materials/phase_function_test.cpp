#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"
#include "materials/volume/bound_phase.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"
#include "support/statistics.hpp"

namespace nadir::materials {
namespace {

using spectral::Curve;
using spectral::Lanes;
using spectral::Outside;

constexpr double pi = std::numbers::pi;

Lanes three_lanes() { return Lanes{{Micrometres{0.5}, Micrometres{1.0}, Micrometres{10.0}}}; }

/// 5 degree steps; a forward peak at 0.5 um, even at 2 um and beyond.
TabulatedPhase table() {
  TabulatedPhase phase;
  phase.wavelength_um = {0.4, 2.0, 12.0};
  for (int i = 0; i <= 36; ++i) phase.angle_rad.push_back(degrees(5.0 * i).value);
  for (const double peak : {30.0, 2.0, 0.0}) {
    for (const double angle : phase.angle_rad) {
      phase.value.push_back(0.2 + peak * std::exp(-angle * angle / 0.1));
    }
  }
  return phase;
}

struct Case {
  const char* name;
  PhaseFunction phase;
};
std::vector<Case> cases() {
  return {
      {"isotropic", HenyeyGreenstein{}},
      {"forward", HenyeyGreenstein{Curve::constant(0.85)}},
      {"backward", HenyeyGreenstein{Curve::constant(-0.6)}},
      {"coloured", HenyeyGreenstein{Curve{{0.5, 1.0, 10.0}, {0.9, 0.3, -0.5}, Outside::reject}}},
      {"nearly even", HenyeyGreenstein{Curve::constant(3e-6)}},
      {"rayleigh", RayleighPhase{}},
      {"table", table()}};
}

Vec3 at_cosine(double cosine, Vec3 wo) {
  // wo along z: light that comes from wi is scattered by the angle between -wi and wo.
  REQUIRE(wo.z == 1.0);
  return support::direction(-cosine, 0.4);
}

TEST_CASE("every phase function integrates to 1 over the sphere at every lane",
          "[materials][phase]") {
  const Vec3 wo{0.0, 0.0, 1.0};
  for (const Case& c : cases()) {
    const BoundPhase phase{c.phase, three_lanes()};
    // Midpoint rule in the cosine: the peaks of g = 0.9 and of the table are 0.005 wide.
    constexpr int steps = 20000;
    std::vector<double> sum(3, 0.0);
    for (int i = 0; i < steps; ++i) {
      const double cosine = 2.0 * (i + 0.5) / steps - 1.0;
      const auto p = phase.eval(at_cosine(cosine, wo), wo);
      for (int lane = 0; lane < 3; ++lane) {
        sum[static_cast<std::size_t>(lane)] += 4.0 * pi / steps * static_cast<double>(p[lane]);
      }
    }
    CAPTURE(c.name);
    // 2e-5: the rule at the narrowest peak, and float.
    for (const double integral : sum) CHECK(integral == Approx(1.0).epsilon(2e-5));
  }
}

TEST_CASE("a phase function depends on the angle between the two directions alone",
          "[materials][phase]") {
  Rng rng{support::test_seed(), 1};
  for (const Case& c : cases()) {
    const BoundPhase phase{c.phase, three_lanes()};
    for (int i = 0; i < 20; ++i) {
      const Vec3 wi = support::random_on_sphere(rng), wo = support::random_on_sphere(rng);
      const Vec3 z{0.0, 0.0, 1.0};
      CAPTURE(c.name);
      for (int lane = 0; lane < 3; ++lane) {
        const float value = phase.eval(wi, wo)[lane];
        CHECK(value == Approx(phase.eval(wo, wi)[lane]).epsilon(1e-6));  // reciprocal; float
        CHECK(value == Approx(phase.eval(at_cosine(-dot(wi, wo), z), z)[lane]).epsilon(1e-5));
        CHECK(value >= 0.0F);
      }
    }
  }
}

// 60,000 draws in 40 x 8 cells: a slip of 2 % in the density of half the sphere would show.
TEST_CASE("directions follow the density, and weights are the function over it",
          "[materials][phase]") {
  constexpr int draws = 60000, rows = 40, columns = 8;
  Rng rng{support::test_seed(), 2};
  const Vec3 wo{0.0, 0.0, 1.0};
  for (const Case& c : cases()) {
    const BoundPhase phase{c.phase, three_lanes()};
    std::vector<double> drawn(rows * columns, 0.0), expected(rows * columns, 0.0);
    bool weights_right = true;
    for (int i = 0; i < draws; ++i) {
      const double choice = rng.next(), u = rng.next(), v = rng.next();
      const PhaseSample s = phase.sample(wo, choice, {u, v});
      const double turn = std::atan2(s.direction.y, s.direction.x) / (2.0 * pi) + 0.5;
      const int row = std::clamp(static_cast<int>(0.5 * (1.0 + s.direction.z) * rows), 0, rows - 1);
      const int column = std::min(static_cast<int>(turn * columns), columns - 1);
      drawn[static_cast<std::size_t>(row * columns + column)] += 1.0;
      const auto p = phase.eval(s.direction, wo);
      for (int lane = 0; lane < 3; ++lane) {
        const double product = static_cast<double>(s.weight[lane]) * s.pdf;
        // 3e-5: the direction's rounding, as a narrow peak in float shows it.
        weights_right = weights_right && std::abs(product - static_cast<double>(p[lane])) <=
                                             3e-5 * static_cast<double>(p[lane]);
      }
      weights_right = weights_right && s.weight.max() <= 3.0001F;  // no more than the lanes
    }
    constexpr int fine = 50;
    for (int i = 0; i < rows * fine; ++i) {
      const double z = 2.0 * (i + 0.5) / (rows * fine) - 1.0;
      const double share = phase.pdf(support::direction(z, 0.3), wo) * 4.0 * pi / (rows * fine);
      for (int j = 0; j < columns; ++j) {
        expected[static_cast<std::size_t>(i / fine * columns + j)] += draws * share / columns;
      }
    }
    CAPTURE(c.name);
    CHECK(weights_right);
    CHECK(support::chi_square_p_value(drawn, expected) > support::sidak(0.001, 7));
  }
}

TEST_CASE("the mean cosine of Henyey and Greenstein's function is g", "[materials][phase]") {
  constexpr int draws = 20000;
  Rng rng{support::test_seed(), 3};
  for (const double g : {-0.99, -0.5, 0.0, 0.2, 0.85, 0.99}) {
    const BoundPhase phase{HenyeyGreenstein{Curve::constant(g)}, three_lanes()};
    const Vec3 wo = support::random_on_sphere(rng);
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < draws; ++i) {
      const double choice = rng.next(), u = rng.next(), v = rng.next();
      const double cosine = -dot(phase.sample(wo, choice, {u, v}).direction, wo);
      sum += cosine;
      squares += cosine * cosine;
    }
    const double mean = sum / draws, variance = squares / draws - mean * mean;
    CAPTURE(g, mean);
    CHECK(support::normal_p_value((mean - g) / std::sqrt(variance / draws)) >
          support::sidak(0.001, 6));
  }
}

TEST_CASE("phase functions have their published values", "[materials][phase]") {
  const Vec3 wo{0.0, 0.0, 1.0};
  // Henyey and Greenstein at 0, 90 and 180 degrees, g = 0.5, from the formula by hand:
  // 0.75 / 4 pi over (0.25, 1.25, 2.25)^1.5.
  const BoundPhase hg{HenyeyGreenstein{Curve::constant(0.5)}, three_lanes()};
  CHECK(hg.eval(at_cosine(1.0, wo), wo)[0] == Approx(0.75 / (4 * pi) / 0.125).epsilon(1e-6));
  CHECK(hg.eval(at_cosine(0.0, wo), wo)[1] == Approx(0.75 / (4 * pi) / 1.3975425).epsilon(1e-6));
  CHECK(hg.eval(at_cosine(-1.0, wo), wo)[2] == Approx(0.75 / (4 * pi) / 3.375).epsilon(1e-6));
  // Rayleigh: twice as much forward and backward as to the side; the mean of cos^2 is 2/5.
  const BoundPhase rayleigh{RayleighPhase{}, three_lanes()};
  CHECK(rayleigh.eval(at_cosine(1.0, wo), wo)[0] == Approx(3.0 / (8.0 * pi)).epsilon(1e-6));
  CHECK(rayleigh.eval(at_cosine(0.0, wo), wo)[0] == Approx(3.0 / (16.0 * pi)).epsilon(1e-6));
  // A table's scale does not matter, and one wavelength holds everywhere.
  TabulatedPhase one{{0.0, 0.5 * pi, pi}, {0.55}, {6.0, 2.0, 2.0}};
  const BoundPhase flat{one, three_lanes()};
  // Integral over x = 1 - cos: 2 pi (4 + 2) = 12 pi.
  CHECK(flat.eval(at_cosine(1.0, wo), wo)[2] == Approx(6.0 / (12.0 * pi)).epsilon(1e-6));
  CHECK(flat.eval(at_cosine(-0.3, wo), wo)[0] == Approx(2.0 / (12.0 * pi)).epsilon(1e-6));
}

std::string refusal(const PhaseFunction& phase) {
  try {
    const BoundPhase bound{phase, three_lanes()};
    return "(accepted)";
  } catch (const InputError& error) {
    return error.issues().front().message;
  }
}

TEST_CASE("phase functions that make no sense are refused", "[materials][phase]") {
  CHECK(refusal(HenyeyGreenstein{Curve::constant(1.0)}) ==
        "g of the Henyey-Greenstein phase function is 1; it must be above -1 and below 1");
  CHECK(refusal(HenyeyGreenstein{Curve{{0.6, 20.0}, {0.1, 0.2}, Outside::reject}}) ==
        "g of the Henyey-Greenstein phase function is not tabulated at 0.5 um");
  TabulatedPhase bad = table();
  bad.value[40] = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal(bad) ==
        "phase table: the value at 15 deg and 2 um is nan; it must be finite and not negative");
  bad = table();
  bad.value.pop_back();
  CHECK(refusal(bad) == "phase table: expected 111 values, found 110");
  bad = table();
  bad.angle_rad.back() = degrees(179.0).value;
  CHECK(refusal(bad) == "phase table: angles must reach from 0 to 180 deg, found 0 to 179 deg");
  bad = table();
  bad.wavelength_um = {0.6, 2.0, 12.0};
  CHECK(refusal(bad) == "phase table: it is tabulated from 0.6 to 12 um, 0.5 um is simulated");
  bad = table();
  std::fill(bad.value.begin(), bad.value.begin() + 37, 0.0);
  CHECK(refusal(bad) == "phase table: the values at 0.4 um cannot be normalised");
}

}  // namespace
}  // namespace nadir::materials
