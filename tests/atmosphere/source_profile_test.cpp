#include "atmosphere/transfer/source_profile.hpp"

#include <cmath>

#include "atmosphere/transfer/ordinates.hpp"
#include "support/catch.hpp"
#include "support/quadrature.hpp"

namespace nadir::atmosphere {
namespace {

/// The two integrals of the header by an independent quadrature, panels chosen so that it follows
/// every exponential.
template <class Strength>
SourceProfile::Response integrals(Strength&& e, double kappa) {
  const auto against = [&](bool even) {
    return static_cast<double>(support::integrate(
        [&](long double s) {
          // scaled by exp(-kappa / 2) so that nothing overflows
          const long double up = std::exp(kappa * (s - 0.5L)), down = std::exp(-kappa * (s + 0.5L));
          const long double share = 1.0L + std::exp(-static_cast<long double>(kappa));
          if (even) return e(s) * (up + down) / share;
          return kappa > 0.0 ? e(s) * (up - down) / (kappa * share) : e(s) * s;
        },
        -0.5L, 0.5L, 8));
  };
  return {against(true), against(false)};
}

TEST_CASE("a source that runs through a layer drives eigensolutions as its integrals say",
          "[atmosphere][transfer]") {
  const double kappa = GENERATE(0.0, 1e-9, 1e-3, 0.5, 1.999, 2.001, 3.0, 40.0);
  CAPTURE(kappa);
  for (const double rate : {0.0, 1e-10, 0.3, 2.0, 3.0, 3.0 + 1e-9, 19.0, 21.0, 40.0}) {
    for (const bool from_top : {true, false}) {
      CAPTURE(rate, from_top);
      const auto exact = integrals(
          [&](long double s) { return 0.7L * std::exp(-rate * (from_top ? 0.5L + s : 0.5L - s)); },
          kappa);
      const auto found =
          SourceProfile::fading(0.7, rate, from_top).response(SourceProfile::Kappa{kappa});
      // as the header promises: 1e-11 of the larger
      CHECK(found.even == Approx(exact.even).epsilon(1e-11));
      CHECK(found.odd == Approx(exact.odd).epsilon(1e-11).margin(1e-11 * exact.even));
    }
  }
  const auto exact = integrals([](long double s) { return 2.0L + 3.0L * s; }, kappa);
  const auto found = SourceProfile::linear(0.5, 3.5).response(SourceProfile::Kappa{kappa});
  CHECK(found.even == Approx(exact.even).epsilon(1e-12));
  CHECK(found.odd == Approx(exact.odd).epsilon(1e-11));
}

// p_l(cos Theta) = sum_m (2 - delta_0m) Lambda_l^m(mu) Lambda_l^m(mu') cos m phi.
TEST_CASE("associated Legendre functions obey the addition theorem", "[atmosphere][transfer]") {
  const int degrees = 64;
  const double a = 0.31, b = -0.88, azimuth = 2.1;
  const double cosine = a * b + std::sqrt((1 - a * a) * (1 - b * b)) * std::cos(azimuth);
  std::vector<double> sum(degrees, 0.0);
  for (int m = 0; m < degrees; ++m) {
    const LegendreTable table{m, degrees, {a, b}};
    for (int l = m; l < degrees; ++l) {
      sum[static_cast<std::size_t>(l)] +=
          (m == 0 ? 1.0 : 2.0) * table.row(l)[0] * table.row(l)[1] * std::cos(m * azimuth);
    }
  }
  double before = 0.0, now = 1.0;
  for (int l = 0; l < degrees; ++l) {
    CHECK(sum[static_cast<std::size_t>(l)] == Approx(now).margin(1e-13));
    const double next = ((2.0 * l + 1.0) * cosine * now - l * before) / (l + 1.0);
    before = now;
    now = next;
  }
}

}  // namespace
}  // namespace nadir::atmosphere
