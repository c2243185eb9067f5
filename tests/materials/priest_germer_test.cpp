#include "materials/scattering/priest_germer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "core/sampler.hpp"
#include "materials/scattering/fresnel.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace nadir;
using namespace nadir::materials;
using spectral::Curve;
using spectral::Spectrum;

namespace {

constexpr double pi = std::numbers::pi;
const spectral::Lanes lanes{{0.5_um, 10.0_um}};

BoundPriestGermer bound(const PriestGermer& model, float reflectance) {
  const Spectrum rho{lanes.count(), reflectance}, none{lanes.count()};
  return {model, {lanes, rho, none}};
}

PriestGermer facets(double n, double k, double sigma) {
  PriestGermer model;
  model.n = Curve::constant(n);
  model.k = Curve::constant(k);
  model.slope_sigma = sigma;
  return model;
}

/// The published formula, by angles, without masking.
double published(const PriestGermer& model, Vec3 wi, Vec3 wo) {
  const double tilt = std::acos(normalised(wi + wo).z), beta = 0.5 * std::acos(dot(wi, wo));
  const double sigma_sq = model.slope_sigma * model.slope_sigma;
  const double f = fresnel_reflectance(std::cos(beta), model.n.at(0.5_um), model.k.at(0.5_um));
  return f * std::exp(-std::pow(std::tan(tilt), 2) / (2.0 * sigma_sq)) /
         (8.0 * pi * sigma_sq * std::pow(std::cos(tilt), 4) * wi.z * wo.z);
}

double reflected(const BoundPriestGermer& model, Vec3 wo) {
  return support::integrate_hemisphere(
      [&](Vec3 wi) { return static_cast<double>(model.eval(wi, wo)[0]) * wi.z; });
}

}  // namespace

TEST_CASE("facets over a black base give the published element m00", "[materials][priest_germer]") {
  const PriestGermer paint = facets(1.4, 0.3, 0.2);
  const BoundPriestGermer model = bound(paint, 0.0F);
  const Vec3 wi = support::direction(0.85, 0.2);
  for (const double azimuth : {0.0, 1.0, pi, pi + 0.2}) {
    const Vec3 wo = support::direction(0.9, azimuth);
    // acos of the test loses digits near the mirror direction; lanes are float
    CHECK(static_cast<double>(model.eval(wi, wo)[0]) ==
          Approx(published(paint, wi, wo)).epsilon(1e-6));
  }
}

// G = 2 h.z o.z / cos beta where a groove's other wall stands in the way.
TEST_CASE("toward grazing the grooves hide what the published formula gains",
          "[materials][priest_germer]") {
  const PriestGermer white = facets(1.0, 1e5, 0.3);
  const BoundPriestGermer model = bound(white, 0.0F);
  const Vec3 wo = support::direction(0.05, 0.0);
  const Vec3 wi = support::direction(0.3, pi);
  const Vec3 h = normalised(wi + wo);
  const double g = 2.0 * h.z * wo.z / dot(wo, h);
  REQUIRE(g < 0.6);
  CHECK(static_cast<double>(model.eval(wi, wo)[0]) ==
        Approx(g * published(white, wi, wo)).epsilon(1e-6));  // float
  const double unmasked =
      support::integrate_hemisphere([&](Vec3 w) { return published(white, w, wo) * w.z; });
  CHECK(unmasked > 1.5);
  CHECK(reflected(model, wo) < 1.0);
}

TEST_CASE("white facets over a white base give back what they got", "[materials][priest_germer]") {
  const double mu = GENERATE(1e-6, 0.01, 0.1, 0.3, 1.0);
  const double sigma = GENERATE(0.1, 0.3, 1.0);
  CAPTURE(mu, sigma);
  const BoundPriestGermer model = bound(facets(1.0, 1e5, sigma), 1.0F);
  const Vec3 wo = support::direction(mu, 0.4);
  double sum = 0.0;
  constexpr std::uint32_t draws = 16384;
  for (std::uint32_t i = 0; i < draws; ++i) {
    const Sampler numbers{1, i};
    const auto s = model.sample(wo, {numbers.number(0), numbers.point(1)});
    if (s) sum += static_cast<double>(s->weight[0]);
  }
  // White facets over a white base: the table of facet albedos errs by 5e-3 of what the base gets.
  CHECK(sum / draws == Approx(1.0).epsilon(6e-3));
}

TEST_CASE("the diffuse base gets what the facets leave", "[materials][priest_germer]") {
  const double mu = GENERATE(0.1, 0.5, 1.0);
  const Vec3 wo = support::direction(mu, 0.4);
  const PriestGermer paint = facets(1.5, 0.0, 0.3);
  const double facets_alone = reflected(bound(paint, 0.0F), wo);
  const BoundPriestGermer model = bound(paint, 0.6F);
  const double expected = facets_alone + 0.6 * (1.0 - facets_alone);
  CHECK(reflected(model, wo) == Approx(expected).epsilon(5e-3));  // the table of facet albedos
  CHECK(static_cast<double>(model.albedo(wo).reflectance[0]) == Approx(expected).epsilon(5e-3));
  // a white base under a coat that absorbs nothing reflects all of it
  CHECK(bound(paint, 1.0F).albedo(wo).reflectance[0] == Approx(1.0).epsilon(1e-6));  // float
}

TEST_CASE("without a base only facets are drawn, and their weight is Fresnel's at most",
          "[materials][priest_germer]") {
  const BoundPriestGermer model = bound(facets(0.2, 3.4, 0.25), 0.0F);
  const Vec3 wo = support::direction(0.3, 1.0);
  for (std::uint32_t i = 0; i < 200; ++i) {
    const Sampler numbers{1, i};
    const auto s = model.sample(wo, {numbers.number(0), numbers.point(1)});
    if (!s) continue;
    const Vec3 h = normalised(s->wi + wo);
    const double f = fresnel_reflectance(dot(wo, h), 0.2, 3.4);
    CHECK(static_cast<double>(s->weight[0]) <= f * (1.0 + 1e-5));  // float
  }
}

TEST_CASE("slopes of 1e-4 are a mirror and stay finite at the horizon",
          "[materials][priest_germer]") {
  const double mu = GENERATE(2e-12, 1e-6, 0.5, 1.0);
  const BoundPriestGermer model = bound(facets(1.3, 7.0, 1e-4), 0.3F);
  const Vec3 wo = support::direction(mu, 0.0);
  for (const double choice : {0.0, 0.3, 1.0 - 0x1.0p-53}) {
    for (const double u : {0.0, 0.5, 1.0 - 0x1.0p-53}) {
      const auto s = model.sample(wo, {choice, {u, u}});
      if (!s) continue;
      CHECK(std::isfinite(s->weight[0]));
      CHECK(std::isfinite(s->pdf));
      CHECK(s->weight[0] >= 0.0F);
    }
  }
  CHECK(std::isfinite(model.eval(support::direction(mu, pi), wo)[0]));
  CHECK(model.eval(support::direction(0.5, 1.0), support::direction(0.0, 0.0))[0] == 0.0F);
}
