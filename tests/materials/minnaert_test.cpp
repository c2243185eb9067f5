#include "materials/scattering/minnaert.hpp"

#include <cmath>
#include <numbers>

#include "materials/bound_one.hpp"
#include "support/catch.hpp"
#include "support/quadrature.hpp"

using namespace nadir;
using materials::BoundMinnaert;
using materials::Minnaert;
using support::bound_one;
using support::direction;

TEST_CASE("Minnaert's law for limb darkening has its closed forms", "[materials][minnaert]") {
  const double k = GENERATE(1.0, 1.4, 2.0, 3.0);
  const auto model = bound_one<BoundMinnaert>(Minnaert{k}, 0.6);
  CAPTURE(k);
  const double f = 0.6 * (k + 1.0) / (2.0 * std::numbers::pi) * std::pow(0.5 * 0.8, k - 1.0);
  // float lanes
  CHECK(model.eval(direction(0.5, 0.0), direction(0.8, 2.0))[0] == Approx(f).epsilon(1e-6));
  for (const double mu : {0.01, 0.4, 1.0}) {
    CHECK(model.albedo(direction(mu, 0.0)).reflectance[0] ==
          Approx(0.6 * std::pow(mu, k - 1.0)).epsilon(1e-6));
  }
}

TEST_CASE("limb brightening stops 84 degrees from the zenith", "[materials][minnaert]") {
  const auto model = bound_one<BoundMinnaert>(Minnaert{0.5}, 0.2);
  const double mu = GENERATE(0.03, 0.1, 0.4, 1.0);
  const double albedo = support::integrate_hemisphere(
      [&](Vec3 wi) { return static_cast<double>(model.eval(wi, direction(mu, 1.0))[0]) * wi.z; });
  const double expected = 0.2 / std::sqrt(std::max(mu, 0.1));
  CHECK(albedo == Approx(expected).epsilon(1e-4));  // the midpoint rule across the kink at mu = 0.1
  CHECK(model.albedo(direction(mu, 0.0)).reflectance[0] == Approx(expected).epsilon(1e-6));
}

TEST_CASE("every draw from a Minnaert surface weighs its albedo", "[materials][minnaert]") {
  const double k = GENERATE(0.6, 1.0, 2.2);
  const auto model = bound_one<BoundMinnaert>(Minnaert{k}, 0.2);
  const Vec3 wo = direction(0.3, 2.0);
  for (const double u : {0.001, 0.5, 0.999}) {
    const auto s = model.sample(wo, {0.5, {u, 0.3}});
    REQUIRE(s.has_value());
    CHECK(s->weight[0] == Approx(model.albedo(wo).reflectance[0]).epsilon(1e-6));  // float lanes
  }
}

// 0.1^(0.5 - 1) = 3.1623, so that the limit of the reflectance is 0.31623.
TEST_CASE("a Minnaert surface that would be brighter than its light is refused",
          "[materials][minnaert]") {
  const auto bind = [](double rho) {
    return support::refusal([&] { (void)bound_one<BoundMinnaert>(Minnaert{0.5}, rho); });
  };
  CHECK(bind(0.316) == "no error");
  CHECK_THAT(bind(0.317), Catch::Matchers::Contains("minnaert: k is 0.5 and the reflectance"));
  CHECK_THAT(bind(0.317), Catch::Matchers::Contains("must be at most 0.3162"));
}
