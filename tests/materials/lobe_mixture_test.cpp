#include "materials/scattering/lobe_mixture.hpp"

#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace nadir;
using namespace nadir::materials;

// 1e-4: the quadrature for a lobe 20 degrees wide.
TEST_CASE("a mixture of folded lobes has a density of one", "[materials][lobe_mixture]") {
  const double b = GENERATE(0.0, 0.3, 0.7), mu = GENERATE(0.05, 0.6, 1.0);
  const LobeMixture mixture{{.uniform = 0.2, .backward = 0.4, .forward = 0.3, .b = b}};
  const Vec3 wo = support::direction(mu, 0.3);
  const double total = support::integrate_hemisphere([&](Vec3 wi) { return mixture.pdf(wi, wo); });
  CHECK(total == Approx(1.0).epsilon(1e-4));
}

// The mean of g(wi) / pdf over draws is the integral of g: of the cosine's square, 2 pi / 3, and of
// a term that is odd in the direction of the view, 0. Of 40,000 draws, 4.5 standard errors.
TEST_CASE("draws of a mixture follow its density", "[materials][lobe_mixture]") {
  const double b = GENERATE(5e-5, 0.3, 0.8);
  const LobeMixture mixture{{.uniform = 0.2, .backward = 0.4, .forward = 0.3, .b = b}};
  const Vec3 wo = support::direction(0.5, 0.3);
  Rng rng{21};
  constexpr int draws = 40'000;
  double square = 0.0, square2 = 0.0, odd = 0.0, odd2 = 0.0;
  for (int i = 0; i < draws; ++i) {
    const double choice = rng.next(), u = rng.next(), v = rng.next();
    const Vec3 wi = mixture.draw(wo, {choice, {u, v}});
    REQUIRE(wi.z >= 0.0);
    const double inverse = 1.0 / mixture.pdf(wi, wo);
    const double s = wi.z * wi.z * inverse, o = (wi.x * wo.x + wi.y * wo.y) * inverse;
    square += s;
    square2 += s * s;
    odd += o;
    odd2 += o * o;
  }
  const auto error = [](double sum, double sum2) {
    return std::sqrt((sum2 / draws - sum * sum / draws / draws) / draws);
  };
  CHECK(square / draws ==
        Approx(2.0 * std::numbers::pi / 3.0).margin(4.5 * error(square, square2)));
  CHECK(odd / draws == Approx(0.0).margin(4.5 * error(odd, odd2)));
}
