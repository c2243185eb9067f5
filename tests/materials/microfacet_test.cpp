#include "materials/scattering/microfacet.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "core/sampler.hpp"
#include "materials/scattering/fresnel.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"
#include "support/statistics.hpp"

using namespace nadir;
using namespace nadir::materials;
using spectral::Curve;
using spectral::Outside;
using spectral::Spectrum;

namespace {

constexpr double pi = std::numbers::pi;

// Four lanes, in which a tabulated index disperses.
const spectral::Lanes lanes{{0.4_um, 0.5_um, 0.6_um, 0.7_um}};
BoundMicrofacet bound(const Microfacet& model) {
  const Spectrum none{lanes.count()};
  return {model, {lanes, none, none}};
}

Microfacet facets(double n, double k, double alpha) {
  Microfacet model;
  model.n = Curve::constant(n);
  model.k = Curve::constant(k);
  model.alpha_x = model.alpha_y = alpha;
  return model;
}

/// Flint-like dispersion, mean 1.65 over the lanes.
Microfacet glass(double alpha) {
  Microfacet model = facets(1.65, 0.0, alpha);
  model.n = Curve{{0.4, 0.7}, {1.68, 1.62}, Outside::hold};
  model.transmits = true;
  return model;
}
constexpr double glass_mean = 1.65;

/// Mean weight of lane 0.
double sampled_albedo(const BoundMicrofacet& model, Vec3 wo, std::uint32_t draws) {
  double sum = 0.0;
  for (std::uint32_t i = 0; i < draws; ++i) {
    const Sampler numbers{11, i};
    if (const auto s = model.sample(wo, {numbers.number(0), numbers.point(1)})) {
      sum += static_cast<double>(s->weight[0]);
    }
  }
  return sum / draws;
}

}  // namespace

// Closed forms for roughness 1 seen from above: GGX normals are cosine-distributed and
// G1(i) = 2 i.z / (1 + i.z), so that with x = (h.z)^2 uniform the albedo is
// integral of (2 - 1/x) over (1/2, 1) = 1 - ln 2: the light that the first facet sends to a second.
TEST_CASE("the rougher half of white GGX facets loses ln 2 of the light",
          "[materials][microfacet]") {
  const BoundMicrofacet model = bound(facets(1.0, 1e5, 1.0));
  // 4096 scrambled points
  CHECK(sampled_albedo(model, {0.0, 0.0, 1.0}, 4096) ==
        Approx(1.0 - std::numbers::ln2).epsilon(1e-3));
  const double integrated = support::integrate_hemisphere([&](Vec3 wi) {
    return static_cast<double>(model.eval(wi, {0.0, 0.0, 1.0})[0]) * wi.z;
  });
  CHECK(integrated == Approx(1.0 - std::numbers::ln2).epsilon(1e-4));  // the midpoint rule
}

TEST_CASE("looking straight down a rough metal has F0 / (4 pi alpha^2)",
          "[materials][microfacet]") {
  const SlopeDistribution slopes = GENERATE(SlopeDistribution::ggx, SlopeDistribution::beckmann);
  Microfacet description = facets(0.2, 3.0, 0.4);
  description.slopes = slopes;
  const Vec3 up{0.0, 0.0, 1.0};
  const double expected = fresnel_reflectance(1.0, 0.2, 3.0) / (4.0 * pi * 0.16);
  CHECK(static_cast<double>(bound(description).eval(up, up)[2]) ==
        Approx(expected).epsilon(1e-6));  // float
}

TEST_CASE("facets of roughness 1e-4 are a mirror with Fresnel's reflectance",
          "[materials][microfacet]") {
  const double mu = GENERATE(1e-6, 0.05, 0.5, 1.0);
  const bool ggx = GENERATE(true, false);
  CAPTURE(mu, ggx);
  Microfacet description = facets(1.3, 7.0, 1e-4);
  description.slopes = ggx ? SlopeDistribution::ggx : SlopeDistribution::beckmann;
  const BoundMicrofacet model = bound(description);
  const Vec3 wo = support::direction(mu, 0.7);
  Rng rng{3};
  for (int i = 0; i < 200; ++i) {
    const double u = rng.next(), v = rng.next();
    const auto s = model.sample(wo, {0.5, {u, v}});
    if (!s) continue;  // grazing: below the horizon
    // the weight is F times masking of the way out; a slope of 1e-4 is steep for a cosine of 1e-6
    if (mu > 0.01) {
      // GGX tails reach 100 times the roughness in one draw of 10,000
      CHECK(static_cast<double>(s->weight[0]) ==
            Approx(fresnel_reflectance(mu, 1.3, 7.0)).epsilon(0.02));
      CHECK(s->wi.z == Approx(mu).margin(0.02));
    }
    CHECK(s->weight[0] <= 1.0F);
    const double f_cos = static_cast<double>(model.eval(s->wi, wo)[0]) * s->wi.z;
    CHECK(static_cast<double>(s->weight[0]) * s->pdf == Approx(f_cos).epsilon(1e-5));  // float
  }
}

TEST_CASE("anisotropic facets stretch the highlight along their rough axis",
          "[materials][microfacet]") {
  Microfacet description = facets(0.2, 3.0, 0.1);
  description.alpha_y = 0.4;
  description.azimuth_rad = 0.3;
  const BoundMicrofacet model = bound(description);
  const Vec3 up{0.0, 0.0, 1.0};
  const auto f = [&](double azimuth) {
    return model.eval(support::direction(0.9, azimuth), up)[0];
  };
  CHECK(f(0.3 + 0.5 * pi) > 5.0F * f(0.3));
  CHECK(f(0.3) == Approx(static_cast<double>(f(0.3 + pi))).epsilon(1e-6));  // float
  CHECK(model.traits().anisotropic);
  CHECK_FALSE(bound(facets(0.2, 3.0, 0.1)).traits().anisotropic);
}

TEST_CASE("an opaque rough surface looks the same from both sides and lets nothing through",
          "[materials][microfacet]") {
  const BoundMicrofacet model = bound(facets(0.2, 3.0, 0.4));
  const Vec3 wi = support::direction(0.6, 1.0), wo = support::direction(0.4, 2.0);
  const Vec3 under_i{wi.x, wi.y, -wi.z}, under_o{wo.x, wo.y, -wo.z};
  CHECK(model.eval(under_i, under_o)[1] == model.eval(wi, wo)[1]);
  CHECK(model.pdf(under_i, under_o) == model.pdf(wi, wo));
  CHECK(model.eval(under_i, wo)[1] == 0.0F);
  CHECK(model.pdf(under_i, wo) == 0.0);
  CHECK(model.sample(under_o, {0.1, {0.3, 0.4}})->wi.z < 0.0);
  CHECK(model.albedo(wo).transmittance[0] == 0.0F);
}

TEST_CASE("smooth glass turns light by Snell's law, both ways", "[materials][microfacet]") {
  const bool inside = GENERATE(true, false);
  const BoundMicrofacet model = bound(glass(1e-4));
  const double sine = 0.4;
  const double z = std::sqrt(1.0 - sine * sine);
  const Vec3 wo{sine, 0.0, inside ? -z : z};
  const double eta = inside ? glass_mean : 1.0 / glass_mean;
  // the middle of the distribution of normals seen: not a fringe of its tail
  const auto s = model.sample(wo, {0.9999, {0.25, 0.5}});
  REQUIRE(s.has_value());
  CHECK(s->wi.z * wo.z < 0.0);
  CHECK(s->wi.x == Approx(-sine * eta).margin(1e-3));  // facets tilt by 1e-4
}

TEST_CASE("light inside glass is held back beyond the critical angle", "[materials][microfacet]") {
  const BoundMicrofacet model = bound(glass(1e-4));
  const Vec3 wo = support::direction(-0.5, 0.0);  // 60 degrees; critical is 37
  for (const double choice : {0.0, 0.5, 0.9999}) {
    const auto s = model.sample(wo, {choice, {0.3, 0.4}});
    REQUIRE(s.has_value());
    CHECK(s->wi.z < 0.0);
    CHECK(s->weight[0] == Approx(1.0).epsilon(1e-3));  // total, less some masking
  }
  CHECK(model.albedo(wo).transmittance[3] == 0.0F);
}

// In a furnace where the radiance is n^2 (of the mean n, which rules the geometry) on either side
// of the glass, every view gets n^2 again: reflection and refraction add up in every lane.
TEST_CASE("radiance over n^2 is conserved by smooth glass in every lane",
          "[materials][microfacet]") {
  const double mu = GENERATE(-0.95, -0.85, 0.2, 0.9);
  CAPTURE(mu);
  const BoundMicrofacet model = bound(glass(1e-4));
  const Vec3 wo = support::direction(mu, 0.0);
  constexpr std::uint32_t draws = 2048;
  std::vector<double> sum(4, 0.0);
  for (std::uint32_t i = 0; i < draws; ++i) {
    const Sampler numbers{5, i};
    const auto s = model.sample(wo, {numbers.number(0), numbers.point(1)});
    if (!s) continue;
    const auto index = [&](double z) { return z < 0.0 ? glass_mean : 1.0; };
    const double furnace = std::pow(index(s->wi.z) / index(wo.z), 2);
    for (int lane = 0; lane < 4; ++lane) {
      sum[static_cast<std::size_t>(lane)] += static_cast<double>(s->weight[lane]) * furnace;
    }
  }
  for (const double lane : sum) CHECK(lane / draws == Approx(1.0).epsilon(2e-3));  // the points
}

TEST_CASE("refraction is reciprocal but for n^2, in every lane", "[materials][microfacet]") {
  const BoundMicrofacet model = bound(glass(0.5));
  Rng rng{17};
  int compared = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 above = support::random_direction(rng), other = support::random_direction(rng);
    const Vec3 below{other.x, other.y, -other.z};
    const Spectrum in = model.eval(above, below), out = model.eval(below, above);
    for (int lane = 0; lane < lanes.count(); ++lane) {
      if (out[lane] > 0.0F) ++compared;
      // float, and 1 - F of a facet near grazing
      CHECK(static_cast<double>(in[lane]) / (glass_mean * glass_mean) ==
            Approx(static_cast<double>(out[lane])).epsilon(2e-5).margin(1e-9));
    }
  }
  CHECK(compared > 100);
}

TEST_CASE("the albedo of glass is what its function integrates to, without the radiance factor",
          "[materials][microfacet]") {
  const double mu = GENERATE(0.7, -0.9);
  const BoundMicrofacet model = bound(glass(0.6));
  const Vec3 wo = support::direction(mu, 0.3);
  const double n = glass_mean;
  double reflected = 0.0, transmitted = 0.0;
  for (const double side : {1.0, -1.0}) {
    double& part = side * mu > 0.0 ? reflected : transmitted;
    part = support::integrate_hemisphere([&](Vec3 w) {
      return static_cast<double>(model.eval({w.x, w.y, side * w.z}, wo)[0]) * w.z;
    });
  }
  transmitted *= mu > 0.0 ? n * n : 1.0 / (n * n);
  const Albedo albedo = model.albedo(wo);
  CHECK(static_cast<double>(albedo.reflectance[0]) == Approx(reflected).margin(5e-3));  // its table
  CHECK(static_cast<double>(albedo.transmittance[0]) == Approx(transmitted).margin(5e-3));
  CHECK(reflected + transmitted <= 1.0);
}

TEST_CASE("directions on the horizon are dark, and none is not a number",
          "[materials][microfacet]") {
  const double alpha = GENERATE(1e-4, 1.0);
  const bool transmits = GENERATE(true, false);
  Microfacet description = transmits ? glass(alpha) : facets(0.2, 3.0, alpha);
  const BoundMicrofacet model = bound(description);
  for (const double mu : {0.0, 1e-300, 1e-13}) {
    const Vec3 flat = support::direction(mu, 0.0), wi = support::direction(0.5, 1.0);
    CHECK(model.eval(wi, flat)[0] == 0.0F);
    CHECK(model.eval(flat, wi)[0] == 0.0F);
    CHECK(model.pdf(flat, wi) == 0.0);
    CHECK_FALSE(model.sample(flat, {0.5, {0.5, 0.5}}).has_value());
  }
  for (const double mu : {2e-12, 1e-6, 1.0}) {
    const Vec3 wo = support::direction(mu, 0.0), opposite = support::direction(mu, pi);
    CHECK(std::isfinite(model.eval(opposite, wo)[0]));
    CHECK(std::isfinite(model.pdf(opposite, wo)));
    CHECK(std::isfinite(model.albedo(wo).reflectance[0]));
    for (const double u : {0.0, 1.0 - 0x1.0p-53}) {
      const auto s = model.sample(wo, {u, {u, u}});
      if (!s) continue;
      CHECK(std::isfinite(s->weight[0]));
      CHECK(std::isfinite(s->pdf));
    }
  }
}

TEST_CASE("rough glass of the index of air is refused", "[materials][microfacet]") {
  Microfacet description = facets(1.0, 0.0, 0.1);
  description.transmits = true;
  CHECK_THROWS_WITH(bound(description),
                    "error: microfacet: the mean of n is 1; a rough interface that transmits needs "
                    "one that differs from 1 by 0.001\n");
}

// The loop in float against the scalar in double, for every kind of matter: dielectrics, metals,
// reststrahlen bands, an index of air.
TEST_CASE("the reflectance of all lanes agrees with Fresnel's equations in double",
          "[materials][fresnel]") {
  for (const double n : {0.02, 0.2, 0.999, 1.0, 1.0001, 1.34, 4.0, 60.0}) {
    for (const double k : {0.0, 1e-9, 1e-3, 0.5, 3.0, 60.0}) {
      const OpticalConstants constants{Curve::constant(n), Curve::constant(k), lanes};
      for (const double c : {0.0, 1e-9, 1e-4, 0.02, 0.3, 0.7, 0.999, 1.0}) {
        CAPTURE(n, k, c);
        const double exact = fresnel_reflectance(c, n, k);
        const float found = constants.reflectance(c)[3];
        CHECK(found <= 1.0F);
        if (n == 1.0 && c == 0.0) continue;  // no face along itself: any value will do
        // 3e-7: a few roundings; near-equal media seen along themselves multiply them
        CHECK(static_cast<double>(found) == Approx(exact).epsilon(1e-5).margin(3e-7));
      }
    }
  }
}
