#include "materials/scattering/facet_slopes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"
#include "support/statistics.hpp"

using namespace nadir;
using materials::FacetSlopes;
using materials::SlopeDistribution;

namespace {

constexpr double pi = std::numbers::pi;

SlopeDistribution kind_of(bool ggx) {
  return ggx ? SlopeDistribution::ggx : SlopeDistribution::beckmann;
}

// Cells of the normals' hemisphere: 16 in the cosine, 24 in azimuth.
constexpr int rows = 16, columns = 24;
std::size_t cell(Vec3 h) {
  const double turn = std::atan2(h.y, h.x) / (2.0 * pi);
  const int row = std::clamp(static_cast<int>(h.z * rows), 0, rows - 1);
  const int column =
      std::clamp(static_cast<int>((turn < 0.0 ? turn + 1.0 : turn) * columns), 0, columns - 1);
  return static_cast<std::size_t>(row * columns + column);
}

}  // namespace

TEST_CASE("facets cover the ground below them once", "[materials][facets]") {
  const bool ggx = GENERATE(true, false);
  const FacetSlopes slopes{kind_of(ggx), {0.7, 0.4}, 0.6};
  const double ground =
      support::integrate_hemisphere([&](Vec3 h) { return slopes.density(h) * h.z; });
  CHECK(ground == Approx(1.0).epsilon(1e-4));  // the midpoint rule for lobes this narrow
}

// Heitz (2014), eq. 14: what decides whether a facet model conserves energy.
TEST_CASE("the facets that a direction sees fill its projected area", "[materials][facets]") {
  const bool ggx = GENERATE(true, false);
  const double mu = GENERATE(0.05, 0.3, 0.8, 1.0);
  CAPTURE(ggx, mu);
  const FacetSlopes slopes{kind_of(ggx), {0.7, 0.4}, 0.6};
  const Vec3 wo = support::direction(mu, 2.0);
  const double seen =
      support::integrate_hemisphere([&](Vec3 h) { return slopes.visible_density(h, wo); });
  // The midpoint rule over the kink where a facet turns away, and in the 1/z of grazing ones.
  CHECK(seen == Approx(1.0).epsilon(2e-3));
}

// Lambda is the masked over the visible projected area (Heitz 2014, eq. 71); the integral over
// slopes steeper than the view is done here by a rule that shares nothing with the closed form.
TEST_CASE("Smith's Lambda of Gaussian slopes is its integral", "[materials][facets]") {
  const double mu = GENERATE(0.02, 0.2, 0.5, 0.9);
  const double alpha = 0.6;
  const FacetSlopes slopes{SlopeDistribution::beckmann, {alpha, alpha}, 0.0};
  const double cot = mu / std::sqrt(1.0 - mu * mu);
  const long double masked = support::integrate(
      [&](long double p) {
        return (p - static_cast<long double>(cot)) *
               std::exp(-p * p / static_cast<long double>(alpha * alpha));
      },
      static_cast<long double>(cot), static_cast<long double>(cot) + 12.0L * alpha, 8);
  const double expected = static_cast<double>(masked) / (alpha * std::sqrt(pi) * cot);
  // rounding; for views near the normal Lambda is the difference of two numbers 100 times as large
  CHECK(slopes.lambda(support::direction(mu, 1.0)) ==
        Approx(expected).epsilon(1e-11).margin(1e-16));
}

TEST_CASE("GGX slopes of 45 degrees and roughness 1 mask (sqrt(2) - 1) / 2",
          "[materials][facets]") {
  const FacetSlopes slopes{SlopeDistribution::ggx, {1.0, 1.0}, 0.0};
  const double expected = (std::sqrt(2.0) - 1.0) / 2.0;
  CHECK(slopes.lambda(support::direction(std::sqrt(0.5), 0.0)) == Approx(expected).epsilon(1e-14));
}

TEST_CASE("from above every facet is seen, from the horizon none", "[materials][facets]") {
  const bool ggx = GENERATE(true, false);
  const FacetSlopes slopes{kind_of(ggx), {0.3, 0.3}, 0.0};
  CHECK(slopes.visible({0.0, 0.0, 1.0}) == 1.0);
  CHECK(slopes.visible(support::direction(1e-9, 0.0)) < 1e-7);
  double before = 1.0;
  for (const double mu : {0.9, 0.5, 0.2, 0.05, 0.01}) {
    const double seen = slopes.visible(support::direction(mu, 0.0));
    CHECK(seen <= before);
    before = seen;
  }
  const Vec3 a = support::direction(0.2, 0.0), b = support::direction(0.3, 2.0);
  CHECK(slopes.visible(a, b) >= slopes.visible(a) * slopes.visible(b));  // heights correlate
  CHECK(slopes.visible(a, b) <= std::min(slopes.visible(a), slopes.visible(b)));
}

TEST_CASE("facets of roughness 1e-4 keep their digits", "[materials][facets]") {
  const bool ggx = GENERATE(true, false);
  const double alpha = 1e-4, tilt = 2.5e-4;
  const FacetSlopes slopes{kind_of(ggx), {alpha, alpha}, 0.0};
  const double t = std::pow(std::tan(tilt) / alpha, 2), z4 = std::pow(std::cos(tilt), 4);
  const double shape = ggx ? 1.0 / std::pow(1.0 + t, 2) : std::exp(-t);
  const Vec3 h{std::sin(tilt) * std::cos(0.4), std::sin(tilt) * std::sin(0.4), std::cos(tilt)};
  // sin and tan of the test round to 1e-16, times the exponent's slope of 12
  CHECK(slopes.density(h) == Approx(shape / (pi * alpha * alpha * z4)).epsilon(1e-13));
}

TEST_CASE("drawn normals are those that are seen", "[materials][facets]") {
  const bool ggx = GENERATE(true, false);
  const double mu = GENERATE(0.05, 0.5, 1.0);
  CAPTURE(ggx, mu);
  const FacetSlopes slopes{kind_of(ggx), {0.9, 0.5}, 0.6};
  const Vec3 wo = support::direction(mu, 2.0);
  constexpr int draws = 50'000, fine = 10;
  std::vector<double> drawn(rows * columns, 0.0), expected(rows * columns, 0.0);
  Rng rng{support::test_seed(), static_cast<std::uint64_t>(1000.0 * mu) + (ggx ? 1U : 0U)};
  for (int i = 0; i < draws; ++i) {
    const double u = rng.next(), v = rng.next();
    drawn[cell(slopes.draw(wo, {u, v}))] += 1.0;
  }
  for (int i = 0; i < rows * fine; ++i) {
    for (int j = 0; j < columns * fine; ++j) {
      const Vec3 h =
          support::direction((i + 0.5) / (rows * fine), 2.0 * pi * (j + 0.5) / (columns * fine));
      const double share = 2.0 * pi / (rows * columns * fine * fine);
      expected[cell(h)] += slopes.visible_density(h, wo) * share * draws;
    }
  }
  const double alpha = support::sidak(0.001, 6);
  CHECK(support::chi_square_p_value(drawn, expected) > alpha);
}

TEST_CASE("the corners of the unit square draw unit vectors above the surface",
          "[materials][facets]") {
  const bool ggx = GENERATE(true, false);
  const double mu = GENERATE(1e-12, 1e-6, 0.5, 1.0);
  const double alpha = GENERATE(1e-4, 0.1, 1.0);
  CAPTURE(ggx, mu, alpha);
  constexpr double last = 1.0 - 0x1.0p-53;
  const FacetSlopes slopes{kind_of(ggx), {alpha, alpha}, 0.0};
  for (const double u : {0.0, 1e-9, 0.5, last}) {
    for (const double v : {0.0, 1e-9, 0.5, last}) {
      const Vec3 h = slopes.draw(support::direction(mu, pi), {u, v});
      CHECK(h.z > 0.0);
      CHECK(dot(h, h) == Approx(1.0).epsilon(1e-14));
    }
  }
}
