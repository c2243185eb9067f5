// What tests/support offers decides about other code, so it is tested itself.
#include <cmath>
#include <numbers>
#include <vector>

#include "support/catch.hpp"
#include "support/directions.hpp"
#include "support/quadrature.hpp"
#include "support/statistics.hpp"

using namespace nadir;

// Upper 5 % and 0.1 % points: NIST/SEMATECH e-Handbook of Statistical Methods, section 1.3.6.7.4
// (three decimals: the density there turns 5e-4 into at most 3e-5 relative for 5 %).
TEST_CASE("chi-square tail agrees with the printed table", "[support]") {
  CHECK(support::chi_square_tail(3.841, 1) == Approx(0.05).epsilon(5e-4));
  CHECK(support::chi_square_tail(18.307, 10) == Approx(0.05).epsilon(5e-4));
  CHECK(support::chi_square_tail(124.342, 100) == Approx(0.05).epsilon(5e-4));
  CHECK(support::chi_square_tail(29.588, 10) == Approx(0.001).epsilon(5e-4));
}

// Closed forms: exp(-x/2) for two degrees, erfc(sqrt(x/2)) for one; both branches of the code.
TEST_CASE("chi-square tail agrees with its closed forms", "[support]") {
  for (const double x : {0.01, 0.5, 1.9, 2.1, 8.0, 60.0}) {
    CHECK(support::chi_square_tail(x, 2) == Approx(std::exp(-x / 2.0)).epsilon(1e-12));
    CHECK(support::chi_square_tail(x, 1) == Approx(std::erfc(std::sqrt(x / 2.0))).epsilon(1e-12));
    CHECK(support::normal_p_value(std::sqrt(x)) ==
          Approx(support::chi_square_tail(x, 1)).epsilon(1e-12));
  }
}

TEST_CASE("chi-square test pools rare cells and refuses impossible ones", "[support]") {
  CHECK(support::chi_square_p_value({10, 10, 10, 10}) == 1.0);
  CHECK(support::chi_square_p_value({400, 10, 10, 10}) < 1e-100);
  // 2 + 4 expected in the pooled cell, 6 found: no deviation at all.
  CHECK(support::chi_square_p_value({50, 6, 0}, {50, 2, 4}) == 1.0);
  CHECK(support::chi_square_p_value({50, 50, 1}, {50.5, 50.5, 0}) == 0.0);
}

TEST_CASE("Sidak's level gives n tests the joint level", "[support]") {
  CHECK(support::sidak(0.001, 1) == Approx(0.001).epsilon(1e-14));
  CHECK(1.0 - std::pow(1.0 - support::sidak(0.05, 20), 20) == Approx(0.05).epsilon(1e-13));
}

TEST_CASE("the double-exponential rule integrates to long double precision", "[support]") {
  const auto near = [](long double a, long double b) { return std::abs(a / b - 1.0L) < 1e-17L; };
  CHECK(near(support::integrate([](long double x) { return x * x; }, 0.0L, 3.0L), 9.0L));
  CHECK(near(support::integrate([](long double x) { return std::exp(x); }, 0.0L, 1.0L, 3),
             std::numbers::e_v<long double> - 1.0L));
  // Infinite slope at the end, where Gauss rules converge slowly.
  CHECK(near(support::integrate([](long double x) { return std::sqrt(x); }, 0.0L, 1.0L),
             2.0L / 3.0L));
}

// int cos^n over the hemisphere is 2 pi / (n + 1).
TEST_CASE("the hemisphere rule keeps its stated error", "[support]") {
  const double pi = std::numbers::pi;
  CHECK(support::integrate_hemisphere([](Vec3) { return 1.0; }) == Approx(2 * pi).epsilon(1e-12));
  CHECK(support::integrate_hemisphere([](Vec3 w) { return w.z; }) == Approx(pi).epsilon(1e-12));
  CHECK(support::integrate_hemisphere([](Vec3 w) { return w.z * w.z; }) ==
        Approx(2 * pi / 3).epsilon(1e-5));
}

TEST_CASE("random directions are uniform in solid angle", "[support]") {
  Rng rng{support::test_seed()};
  std::vector<double> upper(64, 0.0), sphere(64, 0.0);
  const auto cell = [](double height, Vec3 w) {
    const double turn = std::atan2(w.y, w.x) / (2.0 * std::numbers::pi) + 0.5;
    return std::min<std::size_t>(static_cast<std::size_t>(height * 8.0), 7) * 8 +
           std::min<std::size_t>(static_cast<std::size_t>(turn * 8.0), 7);
  };
  for (int i = 0; i < 40'000; ++i) {
    const Vec3 a = support::random_direction(rng), b = support::random_on_sphere(rng);
    upper[cell(a.z, a)] += 1.0;
    sphere[cell((b.z + 1.0) / 2.0, b)] += 1.0;
  }
  const double alpha = support::sidak(1e-3, 2);
  CHECK(support::chi_square_p_value(upper) > alpha);
  CHECK(support::chi_square_p_value(sphere) > alpha);
}
