#include "materials/scattering/oren_nayar.hpp"

#include <cmath>
#include <numbers>

#include "materials/bound_one.hpp"
#include "support/catch.hpp"
#include "support/quadrature.hpp"

using namespace nadir;
using materials::BoundOrenNayar;
using materials::OrenNayar;
using support::bound_one;
using support::direction;

TEST_CASE("an Oren-Nayar surface without slopes is Lambertian", "[materials][oren_nayar]") {
  const auto model = bound_one<BoundOrenNayar>(OrenNayar{0.0}, 0.3);
  const Vec3 wo = direction(0.3, 0.0);
  for (const double azimuth : {0.0, 1.0, 3.0}) {
    // float lanes
    CHECK(model.eval(direction(0.2, azimuth), wo)[0] ==
          Approx(0.3 / std::numbers::pi).epsilon(1e-6));
  }
  CHECK(model.albedo(wo).reflectance[0] == Approx(0.3).epsilon(1e-6));
}

// Equation 30 of the paper worked by hand for sigma = 0.5 rad (s = 0.25), facets of albedo
// rho / A: A = 1 - 0.125 / 0.58 = 0.7844828, B = 0.1125 / 0.34 = 0.3308824.
TEST_CASE("Oren-Nayar's equation 30 at hand-worked angles", "[materials][oren_nayar]") {
  constexpr double a = 0.7844828, b = 0.3308824, facet_albedo = 0.5;
  const auto model = bound_one<BoundOrenNayar>(OrenNayar{0.5}, facet_albedo * a);
  const Vec3 wo = direction(0.5, 0.0);                 // 60 degrees
  const double sine = std::sqrt(0.75), tangent = 1.0;  // sin 60, tan 45
  const Vec3 back = direction(std::sqrt(0.5), 0.0), forward = direction(std::sqrt(0.5), 3.0);
  const double expected = facet_albedo / std::numbers::pi * (a + b * sine * tangent);
  CHECK(model.eval(back, wo)[0] == Approx(expected).epsilon(1e-6));  // float lanes
  CHECK(model.eval(forward, wo)[0] == Approx(facet_albedo * a / std::numbers::pi).epsilon(1e-6));
}

// An independent rule of two dimensions against the closed form, 2e-4: its kink at theta_i =
// theta_o.
TEST_CASE("the Oren-Nayar lobe integrates to its closed form", "[materials][oren_nayar]") {
  const double angle = GENERATE(0.0, 20.0, 45.0, 70.0, 88.0);
  const auto model = bound_one<BoundOrenNayar>(OrenNayar{0.6}, 0.5);
  const Vec3 wo = direction(std::cos(support::radians(angle)), 0.4);
  const double albedo = support::integrate_hemisphere(
      [&](Vec3 wi) { return static_cast<double>(model.eval(wi, wo)[0]) * wi.z; });
  CAPTURE(angle);
  CHECK(model.albedo(wo).reflectance[0] == Approx(albedo).epsilon(2e-4));
}

TEST_CASE("every draw from an Oren-Nayar surface weighs its albedo", "[materials][oren_nayar]") {
  const double mu = GENERATE(0.001, 0.3, 0.9);
  const auto model = bound_one<BoundOrenNayar>(OrenNayar{0.6}, 0.5);
  const Vec3 wo = direction(mu, 2.0);
  const float albedo = model.albedo(wo).reflectance[0];
  for (const double choice : {0.05, 0.95}) {
    for (const double u : {0.01, 0.5, 0.99}) {
      const auto s = model.sample(wo, {choice, {u, 0.7}});
      REQUIRE(s.has_value());
      CHECK(s->weight[0] == Approx(albedo).epsilon(1e-5));  // float lanes, two terms
    }
  }
}

TEST_CASE("a rough surface never reflects more than it gets", "[materials][oren_nayar]") {
  const double rho = GENERATE(0.7, 0.9, 0.999, 1.0);
  const double sigma = GENERATE(0.1, 0.3, 1.5);
  const auto model = bound_one<BoundOrenNayar>(OrenNayar{sigma}, rho);
  CAPTURE(rho, sigma);
  CHECK(model.albedo({0.0, 0.0, 1.0}).reflectance[0] == Approx(rho).epsilon(1e-6));
  for (const double mu : {1e-6, 0.01, 0.1, 0.5}) {
    CHECK(model.albedo(direction(mu, 0.0)).reflectance[0] <= 1.0F + 2e-7F);  // 2 float roundings
  }
}
