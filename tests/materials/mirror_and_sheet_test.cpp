#include <cmath>
#include <optional>

#include "materials/bound_one.hpp"
#include "materials/scattering/clear_sheet.hpp"
#include "materials/scattering/fresnel.hpp"
#include "materials/scattering/mirror.hpp"
#include "support/catch.hpp"
#include "support/quadrature.hpp"

using namespace nadir;
using materials::BoundClearSheet;
using materials::BoundMirror;
using materials::ClearSheet;
using materials::fresnel_dielectric;
using materials::fresnel_reflectance;
using materials::Mirror;
using spectral::Curve;
using support::bound_one;
using support::direction;

TEST_CASE("a mirror sends light the other way at the same height", "[materials][mirror]") {
  const auto model = bound_one<BoundMirror>(Mirror{}, 0.9);
  const double mu = GENERATE(0.4, -0.4);
  const Vec3 wo = direction(mu, 0.3);
  const auto s = model.sample(wo, {0.5, {0.5, 0.5}});
  REQUIRE(s.has_value());
  CHECK(s->delta);
  CHECK(s->wi == Vec3{-wo.x, -wo.y, wo.z});
  CHECK(s->weight[0] == 0.9F);
}

// Textbook values: ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2) at normal incidence. Gold at 1 um:
// n = 0.26, k = 6.8 gives 0.97791; and everything is reflected along the surface.
TEST_CASE("a metal mirror reflects by n and k", "[materials][mirror]") {
  const auto model = bound_one<BoundMirror>(Mirror{Curve::constant(0.26), Curve::constant(6.8)});
  const double normal = (0.74 * 0.74 + 46.24) / (1.26 * 1.26 + 46.24);
  CHECK(model.albedo({0.0, 0.0, 1.0}).reflectance[0] == Approx(normal).epsilon(1e-6));
  CHECK(model.albedo(direction(1e-9, 0.0)).reflectance[0] == Approx(1.0).epsilon(1e-6));
}

// Without absorption a plate reflects 2 r / (1 + r) of each polarisation (Stokes 1862).
TEST_CASE("a clear plate reflects from both faces", "[materials][clear_sheet]") {
  const auto model = bound_one<BoundClearSheet>(ClearSheet{Curve::constant(1.5), {}});
  const auto normal = model.albedo({0.0, 0.0, 1.0});
  constexpr double r = 0.04;
  CHECK(normal.reflectance[0] == Approx(2.0 * r / (1.0 + r)).epsilon(1e-6));  // float lanes
  CHECK(normal.transmittance[0] == Approx((1.0 - r) / (1.0 + r)).epsilon(1e-6));

  // Brewster's angle, tan = n: r_p = 0 and r_s = ((1 - n^2) / (1 + n^2))^2 = (1.25 / 3.25)^2
  const auto brewster = model.albedo(direction(1.0 / std::sqrt(1.0 + 2.25), 0.0));
  const double r_s = std::pow(1.25 / 3.25, 2);
  CHECK(brewster.reflectance[0] == Approx(r_s / (1.0 + r_s)).epsilon(1e-6));
  CHECK(brewster.reflectance[0] + brewster.transmittance[0] == Approx(1.0).epsilon(1e-6));
}

// R = r + r t^2 a^2 / (1 - r^2 a^2), T = t^2 a / (1 - r^2 a^2) with t = 1 - r.
TEST_CASE("an absorbing plate loses light on its way to and fro", "[materials][clear_sheet]") {
  const double depth = GENERATE(0.2, 3.0, 1e5);
  const auto model =
      bound_one<BoundClearSheet>(ClearSheet{Curve::constant(1.5), Curve::constant(depth)});
  const auto normal = model.albedo({0.0, 0.0, 1.0});
  const double r = 0.04, a = std::exp(-depth), t2 = 0.96 * 0.96;
  CHECK(normal.reflectance[0] == Approx(r + r * t2 * a * a / (1.0 - r * r * a * a)).epsilon(1e-6));
  CHECK(normal.transmittance[0] == Approx(t2 * a / (1.0 - r * r * a * a)).epsilon(1e-6));

  const auto matched = bound_one<BoundClearSheet>(
      ClearSheet{Curve::constant(1.0), Curve::constant(depth)});  // no faces: Beer's law alone
  CHECK(matched.albedo(direction(0.5, 0.0)).transmittance[0] ==
        Approx(std::exp(-2.0 * depth)).epsilon(1e-6));

  // 60 degrees outside, cos = sqrt(1 - 0.75 / 2.25) inside; Fresnel's two amplitudes
  const double inside = std::sqrt(2.0 / 3.0), slanted_a = std::exp(-depth / inside);
  double expected = 0.0;
  for (const double amplitude :
       {(0.5 - 1.5 * inside) / (0.5 + 1.5 * inside), (0.75 - inside) / (0.75 + inside)}) {
    const double face = amplitude * amplitude, inner = face * slanted_a;
    expected += 0.5 * (1.0 - face) * (1.0 - face) * slanted_a / (1.0 - inner * inner);
  }
  CHECK(model.albedo(direction(0.5, 0.0)).transmittance[0] == Approx(expected).epsilon(1e-6));
}

TEST_CASE("a sheet mirrors or lets straight through by its shares", "[materials][clear_sheet]") {
  const auto model = bound_one<BoundClearSheet>(ClearSheet{}, 0.2, 0.6);
  const double mu = GENERATE(0.7, -0.7);
  const Vec3 wo = direction(mu, 0.3);
  const auto back = model.sample(wo, {0.249, {0.5, 0.5}});
  const auto on = model.sample(wo, {0.251, {0.5, 0.5}});
  REQUIRE(back.has_value());
  REQUIRE(on.has_value());
  CHECK((back->delta && on->delta));
  CHECK(back->wi == Vec3{-wo.x, -wo.y, wo.z});
  CHECK(on->wi == -wo);
  CHECK(back->weight[0] == Approx(0.8).epsilon(1e-6));  // float lanes
  CHECK(on->weight[0] == Approx(0.8).epsilon(1e-6));
}

TEST_CASE("a plate of one face only is what two faces are made of", "[materials][clear_sheet]") {
  // r from fresnel.hpp (a mean over polarisations) bounds the plate from below and 2 r from above
  const double mu = GENERATE(0.05, 0.3, 0.9);
  const auto model = bound_one<BoundClearSheet>(ClearSheet{Curve::constant(1.33), {}});
  const double r = fresnel_dielectric(mu, 1.33);
  CHECK(r == Approx(fresnel_reflectance(mu, 1.33, 0.0)).epsilon(1e-12));
  CHECK(model.albedo(direction(mu, 0.0)).reflectance[0] > r);
  CHECK(model.albedo(direction(mu, 0.0)).reflectance[0] < 2.0 * r);
}
