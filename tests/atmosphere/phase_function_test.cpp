#include "atmosphere/particles/phase_function.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "core/error.hpp"
#include "spectral/gauss_rule.hpp"
#include "support/catch.hpp"

using namespace nadir;
using atmosphere::PhaseFunction;

namespace {

using std::numbers::pi;

/// A fog's: a forward peak 2 degrees wide, a bow at 140 degrees.
PhaseFunction peaked() {
  std::vector<double> angles;
  for (const double deg : {0.0, 2.0, 4.0, 8.0, 20.0, 50.0, 90.0, 120.0, 140.0, 145.0, 180.0}) {
    angles.push_back(deg * pi / 180.0);
  }
  angles.back() = pi;
  return {angles, {900.0, 9.0, 6.0, 3.0, 0.7, 0.1, 0.01, 0.01, 0.04, 0.03, 0.02}};
}

/// A Henyey-Greenstein function as a table that is fine enough for its smooth parts.
PhaseFunction tabulated_henyey_greenstein(double g, int intervals) {
  std::vector<double> angles, values;
  const PhaseFunction exact = PhaseFunction::henyey_greenstein(g);
  for (int i = 0; i <= intervals; ++i) {
    angles.push_back(pi * i / intervals);
    values.push_back(7.5 * exact.at(std::cos(angles.back())));
  }
  return {angles, values};
}

/// 2 pi int P(angle) f(cos) sin dangle, by Gauss rules on pieces that end where the slope jumps.
double integral(const PhaseFunction& phase, const std::function<double(double)>& f) {
  const spectral::Rule rule = spectral::gauss_legendre(6);
  const int pieces = 720;  // a quarter of a degree: every angle of the tables above is an end
  double sum = 0.0;
  for (int k = 0; k < pieces; ++k) {
    for (std::size_t n = 0; n < rule.nodes.size(); ++n) {
      const double angle = pi * (k + 0.5 * (1.0 + rule.nodes[n])) / pieces;
      sum += phase.at(std::cos(angle)) * f(std::cos(angle)) * std::sin(angle) * rule.weights[n];
    }
  }
  return 2.0 * pi * pi / pieces * sum;
}

double legendre(int l, double x) { return std::legendre(static_cast<unsigned>(l), x); }

std::vector<PhaseFunction> all() {
  return {peaked(), tabulated_henyey_greenstein(0.8, 90), PhaseFunction::rayleigh(0.0279),
          PhaseFunction::henyey_greenstein(0.85), PhaseFunction::henyey_greenstein(-0.4)};
}

}  // namespace

TEST_CASE("every phase function integrates to 1 over the sphere", "[atmosphere][phase]") {
  for (const PhaseFunction& phase : all()) {
    // 1e-11: the piecewise Gauss rule; the table's own sum is a closed form
    CHECK(integral(phase, [](double) { return 1.0; }) == Approx(1.0).epsilon(1e-11));
    CHECK(phase.moments()[0] == Approx(1.0).epsilon(1e-12));
  }
}

TEST_CASE("the Legendre moments are those of the function that at() returns",
          "[atmosphere][phase]") {
  for (const PhaseFunction& phase : all()) {
    REQUIRE(phase.moments().size() == 129);
    CHECK(phase.asymmetry() == phase.moments()[1]);
    for (const int l : {1, 2, 3, 33, 64, 127, 128}) {
      CAPTURE(l);
      const double quadrature = integral(phase, [l](double x) { return legendre(l, x); });
      // stated: 1e-9
      CHECK(phase.moments()[static_cast<std::size_t>(l)] == Approx(quadrature).margin(1e-9));
    }
  }
}

TEST_CASE("Henyey and Greenstein's moments are powers of g", "[atmosphere][phase]") {
  for (const double g : {-0.9, 0.0, 0.5, 0.98}) {
    const PhaseFunction phase = PhaseFunction::henyey_greenstein(g);
    for (const int l : {0, 1, 2, 7, 128}) {
      CHECK(phase.moments()[static_cast<std::size_t>(l)] ==
            Approx(std::pow(g, l)).epsilon(1e-12).margin(1e-300));
    }
    // forward value (1 + g) / (1 - g)^2 / 4 pi
    CHECK(phase.at(1.0) == Approx((1.0 + g) / (4.0 * pi * (1.0 - g) * (1.0 - g))).epsilon(1e-12));
  }
}

TEST_CASE("a fine table of Henyey and Greenstein's function has its moments",
          "[atmosphere][phase]") {
  const PhaseFunction table = tabulated_henyey_greenstein(0.7, 1440);
  for (const int l : {1, 2, 5, 20}) {
    // 1e-5: straight lines between points an eighth of a degree apart
    CHECK(table.moments()[static_cast<std::size_t>(l)] == Approx(std::pow(0.7, l)).margin(1e-5));
  }
}

TEST_CASE("Rayleigh's moments are those of the closed form", "[atmosphere][phase]") {
  const PhaseFunction pure = PhaseFunction::rayleigh(0.0), air = PhaseFunction::rayleigh(0.0279);
  CHECK(pure.moments()[2] == Approx(0.1).epsilon(1e-14));
  CHECK(air.moments()[2] == Approx(0.9721 / (5.0 * 2.0279)).epsilon(1e-14));
  CHECK(pure.at(0.0) == Approx(3.0 / (16.0 * pi)).epsilon(1e-14));
  // what leaves at right angles to what goes on, for unpolarised light: (1 + d) / 2
  CHECK(air.at(0.0) / air.at(1.0) == Approx(1.0279 / 2.0).epsilon(1e-12));
  CHECK(air.at(-0.3) == air.at(0.3));
  for (const std::size_t l : {1U, 3U, 4U, 128U}) CHECK(air.moments()[l] == 0.0);
}

TEST_CASE("128 moments give a smooth phase function back", "[atmosphere][phase]") {
  // 0.75^129 < 1e-16; the kinked tables never converge that fast
  for (const PhaseFunction& phase :
       {PhaseFunction::rayleigh(0.0279), PhaseFunction::henyey_greenstein(0.75)}) {
    for (const double x : {-1.0, -0.4, 0.1, 0.8, 1.0}) {
      double sum = 0.0;
      for (int l = 0; l <= 128; ++l) {
        sum += (2 * l + 1) * phase.moments()[static_cast<std::size_t>(l)] * legendre(l, x);
      }
      CHECK(sum / (4.0 * pi) == Approx(phase.at(x)).epsilon(1e-11));
    }
  }
}

TEST_CASE("a table's logarithm runs linearly in angle and keeps its ratios",
          "[atmosphere][phase]") {
  const PhaseFunction phase = peaked();
  const auto at = [&](double deg) { return phase.at(std::cos(deg * pi / 180.0)); };
  // 1e-6: the arc cosine near 0 degrees loses half of a double's digits
  CHECK(at(0.0) / at(2.0) == Approx(100.0).epsilon(1e-6));
  CHECK(at(1.0) / at(2.0) == Approx(10.0).epsilon(1e-6));
  CHECK(at(160.0) * at(160.0) == Approx(at(150.0) * at(170.0)).epsilon(1e-10));
  CHECK(at(180.0) / at(140.0) == Approx(0.5).epsilon(1e-10));
  CHECK(phase.at(1.0 + 1e-12) == phase.at(1.0));
}

TEST_CASE("a phase function that is none is refused", "[atmosphere][phase]") {
  CHECK_THROWS_AS(PhaseFunction({0.0}, {1.0}), InputError);
  CHECK_THROWS_AS(PhaseFunction({0.0, pi}, {1.0}), InputError);
  CHECK_THROWS_AS(PhaseFunction({0.0, 3.0}, {1.0, 1.0}), InputError);
  CHECK_THROWS_AS(PhaseFunction({0.1, pi}, {1.0, 1.0}), InputError);
  CHECK_THROWS_AS(PhaseFunction({0.0, 2.0, 2.0, pi}, {1.0, 1.0, 1.0, 1.0}), InputError);
  CHECK_THROWS_AS(PhaseFunction({0.0, pi}, {1.0, 0.0}), InputError);
  CHECK_THROWS_AS(PhaseFunction({0.0, pi}, {1.0, std::nan("")}), InputError);
  CHECK_THROWS_AS(PhaseFunction::henyey_greenstein(1.0), InputError);
  CHECK_THROWS_AS(PhaseFunction::henyey_greenstein(std::nan("")), InputError);
  CHECK_THROWS_AS(PhaseFunction::rayleigh(-0.1), InputError);
  CHECK_NOTHROW(PhaseFunction({0.0, pi}, {1e300, 1e300}));
}
