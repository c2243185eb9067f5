#include <numbers>

#include "materials/bound_one.hpp"
#include "materials/scattering/lambertian.hpp"
#include "materials/scattering/leaf.hpp"
#include "support/catch.hpp"
#include "support/quadrature.hpp"

using namespace nadir;
using materials::BoundLambertian;
using materials::BoundLeaf;
using materials::Lambertian;
using materials::Leaf;
using support::bound_one;
using support::direction;

TEST_CASE("a Lambertian surface reflects its reflectance from every direction", "[materials]") {
  const double mu = GENERATE(1e-6, 0.3, 1.0, -0.5);
  const auto model = bound_one<BoundLambertian>(Lambertian{}, 0.7);
  const Vec3 wo = direction(mu, 1.0);
  CHECK(model.albedo(wo).reflectance[0] == 0.7F);
  CHECK(model.albedo(wo).transmittance[0] == 0.0F);
  CHECK(model.sample(wo, {0.1, {0.25, 0.5}})->weight[0] == 0.7F);
  CHECK(model.eval(direction(mu > 0.0 ? 0.4 : -0.4, 0.0), wo)[0] ==
        Approx(0.7 / std::numbers::pi).epsilon(1e-6));  // float lanes
}

TEST_CASE("a leaf shares its light between its sides", "[materials][leaf]") {
  const auto model = bound_one<BoundLeaf>(Leaf{}, 0.45, 0.15);
  const Vec3 wo = direction(0.6, 0.0), below = direction(-0.2, 1.0);
  // float lanes
  CHECK(model.eval(direction(0.2, 1.0), wo)[0] == Approx(0.45 / std::numbers::pi).epsilon(1e-6));
  CHECK(model.eval(below, wo)[0] == Approx(0.15 / std::numbers::pi).epsilon(1e-6));
  CHECK(model.albedo(below).reflectance[0] == 0.45F);
  CHECK(model.albedo(below).transmittance[0] == 0.15F);
  CHECK(model.traits().transmits);

  // three draws in four stay on the side of the view, and all weigh rho + tau
  const auto up = model.sample(wo, {0.749, {0.3, 0.2}}),
             down = model.sample(wo, {0.751, {0.3, 0.2}});
  REQUIRE(up.has_value());
  REQUIRE(down.has_value());
  CHECK(up->wi.z > 0.0);
  CHECK(down->wi.z < 0.0);
  CHECK(up->weight[0] == Approx(0.6).epsilon(1e-6));
  CHECK(down->weight[0] == Approx(0.6).epsilon(1e-6));
}

TEST_CASE("a black leaf draws nothing", "[materials][leaf]") {
  const auto model = bound_one<BoundLeaf>(Leaf{}, 0.0, 0.0);
  CHECK_FALSE(model.sample({0.0, 0.0, 1.0}, {0.5, {0.5, 0.5}}).has_value());
  CHECK_FALSE(model.traits().transmits);
}
