#include "materials/scattering/ross_li.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/random.hpp"
#include "materials/scattering/bound_scattering.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace nadir;
using namespace nadir::materials;
using spectral::Curve;
using spectral::Spectrum;
using support::direction;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

BoundRossLi bound(double iso, double vol, double geo) {
  const spectral::Lanes lanes{{Micrometres{0.645}, Micrometres{0.858}}};
  const Spectrum none{lanes.count()};
  const RossLi model{Curve::constant(iso), Curve::constant(vol), Curve::constant(geo)};
  return std::get<BoundRossLi>(materials::bind(Scattering{model}, BindContext{lanes, none, none}));
}

Vec3 at_zenith(double zenith_deg, double azimuth_deg = 0.0) {
  return direction(std::cos(zenith_deg * degree), azimuth_deg * degree);
}

using Kernel = double (*)(const HeldAngles&) noexcept;

/// Directional integral of a kernel, (1/pi) int K mu d(omega), with 128 x 128 points.
double black_sky(Kernel kernel, double sun_zenith_deg, double least_cosine = held_zenith_cosine) {
  constexpr int steps = 128;
  const Vec3 sun = at_zenith(sun_zenith_deg);
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double mu = (i + 0.5) / steps;
    for (int j = 0; j < steps; ++j) {
      const double azimuth = std::numbers::pi * (j + 0.5) / steps;
      sum += kernel(HeldAngles{sun, direction(mu, azimuth), least_cosine}) * mu;
    }
  }
  return 2.0 * sum / (steps * static_cast<double>(steps));
}

}  // namespace

TEST_CASE("both kernels vanish where light and view are vertical", "[materials][ross_li]") {
  const Vec3 up{0.0, 0.0, 1.0};
  CHECK(ross_thick({up, up}) == Approx(0.0).margin(1e-15));
  CHECK(li_sparse_reciprocal({up, up}) == Approx(0.0).margin(1e-15));
}

// At the hot spot xi = 0 and the crowns' shadows overlap fully, so that O = sec(theta):
// K_vol = pi / (4 mu) - pi / 4, K_geo = sec(theta) (sec(theta) - 1).
TEST_CASE("the kernels have their closed forms at the hot spot", "[materials][ross_li]") {
  const double zenith = GENERATE(10.0, 30.0, 45.0, 60.0, 75.0);
  const Vec3 w = at_zenith(zenith, 40.0);
  const double sec = 1.0 / std::cos(zenith * degree);
  // 1e-7: near phase angle 0 the cosine leaves half of the digits
  CHECK(ross_thick({w, w}) == Approx(0.25 * std::numbers::pi * (sec - 1.0)).margin(1e-7));
  CHECK(li_sparse_reciprocal({w, w}) == Approx(sec * (sec - 1.0)).margin(1e-7));
}

// Nadir view: xi = theta_s, D = tan(theta_s), cos(t) = 2 tan / (1 + sec) < 1 up to 53.13 degrees,
// above which the shadows are apart: K_geo = -1 - sec + (1 + cos) sec / 2 = -(1 + sec) / 2.
TEST_CASE("the kernels have their closed forms for a nadir view", "[materials][ross_li]") {
  const double zenith = GENERATE(55.0, 60.0, 70.0, 79.0);
  const double theta = zenith * degree, sec = 1.0 / std::cos(theta);
  const HeldAngles angles{at_zenith(zenith, 10.0), Vec3{0.0, 0.0, 1.0}};
  const double half_pi = 0.5 * std::numbers::pi;
  CHECK(li_sparse_reciprocal(angles) == Approx(-0.5 * (1.0 + sec)).epsilon(1e-12));
  CHECK(ross_thick(angles) ==
        Approx(((half_pi - theta) * std::cos(theta) + std::sin(theta)) / (1.0 + std::cos(theta)) -
               0.5 * half_pi)
            .epsilon(1e-12));
}

// Black-sky integrals as published with the MODIS albedo algorithm (Lucht, Schaaf & Strahler 2000,
// Table I): g0 + g1 theta^2 + g2 theta^3, fitted up to 80 degrees. 0.02: the fit's own error (0.025
// at 75 degrees).
TEST_CASE("kernel integrals agree with the MODIS black-sky polynomials", "[materials][ross_li]") {
  const double zenith = GENERATE(0.0, 20.0, 40.0, 60.0);
  const double theta = zenith * degree, square = theta * theta;
  CHECK(black_sky(ross_thick, zenith, 1e-9) ==
        Approx(-0.007574 - 0.070987 * square + 0.307588 * square * theta).margin(0.02));
  CHECK(black_sky(li_sparse_reciprocal, zenith, 1e-9) ==
        Approx(-1.284909 - 0.166314 * square + 0.041840 * square * theta).margin(0.02));
}

// White-sky integrals, same table: 0.189184 and -1.377622. 0.002: ours by 24 steps in the sun's
// cosine, and the kernels' steep rise where both directions graze.
TEST_CASE("kernel integrals agree with the MODIS white-sky values", "[materials][ross_li]") {
  double volumetric = 0.0, geometric = 0.0;
  constexpr int steps = 24;
  for (int i = 0; i < steps; ++i) {
    const double mu = (i + 0.5) / steps, zenith = std::acos(mu) / degree;
    volumetric += 2.0 * mu * black_sky(ross_thick, zenith, 1e-9) / steps;
    geometric += 2.0 * mu * black_sky(li_sparse_reciprocal, zenith, 1e-9) / steps;
  }
  CHECK(volumetric == Approx(0.189184).margin(0.002));
  CHECK(geometric == Approx(-1.377622).margin(0.002));
}

TEST_CASE("f is the weighted sum of the kernels over pi", "[materials][ross_li]") {
  const BoundRossLi model = bound(0.3, 0.1, 0.05);
  const Vec3 wi = at_zenith(35.0), wo = at_zenith(50.0, 120.0);
  const HeldAngles angles{wi, wo};
  const double expected =
      (0.3 + 0.1 * ross_thick(angles) + 0.05 * li_sparse_reciprocal(angles)) * std::numbers::inv_pi;
  CHECK(static_cast<double>(model.eval(wi, wo)[1]) == Approx(expected).epsilon(1e-6));  // float
}

TEST_CASE("beyond 80 degrees the reflectance is held", "[materials][ross_li]") {
  const BoundRossLi model = bound(0.3, 0.1, 0.05);
  const Vec3 wo = at_zenith(30.0);
  const float held = model.eval(at_zenith(80.0, 70.0), wo)[0];
  for (const double zenith : {81.0, 85.0, 89.0, 89.9999}) {
    CHECK(model.eval(at_zenith(zenith, 70.0), wo)[0] == Approx(held).epsilon(1e-6));
    CHECK(model.eval(wo, at_zenith(zenith, 70.0))[0] == Approx(held).epsilon(1e-6));
  }
}

TEST_CASE("a Ross-Li surface looks the same from below and is dark across", "[materials]") {
  const BoundRossLi model = bound(0.3, 0.1, 0.05);
  const Vec3 wi = at_zenith(20.0), wo = at_zenith(60.0, 100.0);
  const Vec3 wi_down{wi.x, wi.y, -wi.z}, wo_down{wo.x, wo.y, -wo.z};
  CHECK(model.eval(wi_down, wo_down)[0] == model.eval(wi, wo)[0]);
  CHECK(model.pdf(wi_down, wo_down) == model.pdf(wi, wo));
  CHECK(model.eval(wi_down, wo).max() == 0.0F);
  CHECK(model.pdf(wi, wo_down) == 0.0);
}

// Typical weights of MCD43 (Lucht et al. 2000, Table II, forest and grass in red and near infrared;
// here rounded): the clamp at 0 is not reached anywhere.
TEST_CASE("typical MODIS weights never reach the clamp at zero", "[materials][ross_li]") {
  struct Weights {
    double iso, vol, geo;
  };
  for (const Weights w : {Weights{0.04, 0.02, 0.006}, Weights{0.25, 0.17, 0.03},
                          Weights{0.15, 0.05, 0.03}, Weights{0.35, 0.15, 0.05}}) {
    const BoundRossLi model = bound(w.iso, w.vol, w.geo);
    Rng rng{7};
    for (int i = 0; i < 2000; ++i) {
      const Vec3 wi = support::random_direction(rng), wo = support::random_direction(rng);
      CHECK(model.eval(wi, wo)[0] > 0.0F);
    }
  }
}

TEST_CASE("the albedo is that of the weights and the kernel integrals", "[materials][ross_li]") {
  const BoundRossLi model = bound(0.3, 0.1, 0.05);
  const double zenith = GENERATE(0.0, 25.0, 50.0, 78.0);
  const double expected =
      0.3 + 0.1 * black_sky(ross_thick, zenith) + 0.05 * black_sky(li_sparse_reciprocal, zenith);
  // 1e-3: the rule of 24 x 24 points and the table's interpolation
  CHECK(model.albedo(at_zenith(zenith)).reflectance[0] == Approx(expected).epsilon(1e-3));
  CHECK(model.albedo(at_zenith(zenith)).transmittance[0] == 0.0F);
}

TEST_CASE("weights that are negative or gain energy are refused", "[materials][ross_li]") {
  CHECK_THROWS_AS(bound(-0.01, 0.0, 0.0), InputError);
  CHECK_THROWS_AS(bound(0.5, 0.1, -0.01), InputError);
  CHECK_THROWS_AS(bound(1.01, 0.0, 0.0), InputError);
  CHECK_THROWS_WITH(bound(0.9, 0.8, 0.0), Catch::Matchers::Contains("ross_li: it reflects 1.") &&
                                              Catch::Matchers::Contains("more than it receives"));
  CHECK_NOTHROW(bound(1.0, 0.0, 0.0));  // white Lambertian
}
