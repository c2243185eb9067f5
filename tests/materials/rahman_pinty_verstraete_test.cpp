#include "materials/scattering/rahman_pinty_verstraete.hpp"

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

struct Rpv {
  double rho0, k, theta;
  std::optional<double> rho_c = std::nullopt;
};

BoundRahmanPintyVerstraete bound(const RahmanPintyVerstraete& model) {
  const spectral::Lanes lanes{{Micrometres{0.5}, Micrometres{1.5}}};
  const Spectrum none{lanes.count()};
  return std::get<BoundRahmanPintyVerstraete>(
      materials::bind(Scattering{model}, BindContext{lanes, none, none}));
}

BoundRahmanPintyVerstraete bound(const Rpv& p) {
  RahmanPintyVerstraete model;
  model.rho0 = Curve::constant(p.rho0);
  model.k = Curve::constant(p.k);
  model.asymmetry = Curve::constant(p.theta);
  if (p.rho_c) model.rho_c = Curve::constant(*p.rho_c);
  return bound(model);
}

Vec3 at_zenith(double zenith_deg, double azimuth_deg = 0.0) {
  return direction(std::cos(zenith_deg * degree), azimuth_deg * degree);
}

double value(const BoundRahmanPintyVerstraete& model, Vec3 wi, Vec3 wo) {
  return static_cast<double>(model.eval(wi, wo)[0]);
}

// Parameters of surfaces in red and near infrared, rho_c = rho0, from the fits of Rahman et al.
// (1993) as the SHARM manual lists them (Lyapustin, Appl. Opt. 44, 7764, 2005).
constexpr std::array<Rpv, 11> published{{
    {0.008, 0.554, -0.308},
    {0.050, 0.581, -0.201},
    {0.278, 0.725, -0.006},
    {0.303, 0.729, -0.034},
    {0.072, 0.668, -0.257},
    {0.242, 0.637, -0.032},
    {0.204, 0.658, -0.089},
    {0.018, 0.364, -0.282},
    {0.285, 0.745, -0.060},
    {0.147, 0.839, -0.096},
    {0.306, 0.606, -0.008},
}};

}  // namespace

TEST_CASE("k = 1, Theta = 0, rho_c = 1 is Lambertian", "[materials][rpv]") {
  const auto model = bound(Rpv{0.4, 1.0, 0.0, 1.0});
  Rng rng{2};
  for (int i = 0; i < 100; ++i) {
    const Vec3 wi = support::random_direction(rng), wo = support::random_direction(rng);
    CHECK(value(model, wi, wo) == Approx(0.4 * std::numbers::inv_pi).epsilon(1e-6));  // float
  }
  CHECK(model.albedo(at_zenith(30.0)).reflectance[0] == Approx(0.4).epsilon(1e-5));
}

// At the hot spot G = 0 and g = 0: f = rho0 / pi (2 mu^3)^(k - 1) (2 - rho_c) (1 + Theta) (1 -
// Theta) / (1 + Theta)^3.
TEST_CASE("the hot spot has its closed form", "[materials][rpv]") {
  const double zenith = GENERATE(0.0, 30.0, 65.0);
  const auto model = bound(Rpv{0.1, 0.7, -0.2, 0.15});
  const double mu = std::cos(zenith * degree);
  const double expected =
      0.1 * std::numbers::inv_pi * std::pow(2.0 * mu * mu * mu, -0.3) * 1.85 * 1.2 / (0.8 * 0.8);
  const Vec3 w = at_zenith(zenith, 25.0);
  CHECK(value(model, w, w) == Approx(expected).epsilon(1e-5));  // float
}

// Light and view at 45 degrees, opposite: cos(g) = 0, G = 2, (mu mu 2 mu) = 1 / sqrt(2). And at
// right angles: cos(g) = 1/2, G = sqrt(2).
TEST_CASE("forward and sideways directions have their closed forms", "[materials][rpv]") {
  const auto model = bound(Rpv{0.1, 0.5, -0.3, 0.4});
  const double level = 0.1 * std::numbers::inv_pi * std::pow(2.0, 0.25) * 0.91;
  const double forward = level / std::pow(1.09, 1.5) * (1.0 + 0.6 / 3.0);
  const double sideways = level / std::pow(0.79, 1.5) * (1.0 + 0.6 / (1.0 + std::sqrt(2.0)));
  CHECK(value(model, at_zenith(45.0), at_zenith(45.0, 180.0)) == Approx(forward).epsilon(1e-5));
  CHECK(value(model, at_zenith(45.0), at_zenith(45.0, 90.0)) == Approx(sideways).epsilon(1e-5));
}

TEST_CASE("negative Theta is brighter in back scatter, positive Theta forward", "[materials]") {
  const Vec3 wi = at_zenith(50.0), back = at_zenith(40.0), forward = at_zenith(40.0, 180.0);
  const auto backward_model = bound(Rpv{0.1, 0.8, -0.3, 1.0});
  const auto forward_model = bound(Rpv{0.1, 0.8, 0.3, 1.0});
  CHECK(value(backward_model, wi, back) > 1.5 * value(backward_model, wi, forward));
  CHECK(value(forward_model, wi, forward) > 1.5 * value(forward_model, wi, back));
}

TEST_CASE("rho_c is rho0 unless it is given", "[materials][rpv]") {
  const Vec3 wi = at_zenith(30.0), wo = at_zenith(35.0, 20.0);
  CHECK(value(bound(Rpv{0.1, 0.7, -0.2}), wi, wo) ==
        value(bound(Rpv{0.1, 0.7, -0.2, 0.1}), wi, wo));
}

TEST_CASE("parameters of real surfaces are accepted, reciprocal and finite", "[materials][rpv]") {
  for (const Rpv& p : published) {
    CAPTURE(p.rho0, p.k, p.theta);
    const auto model = bound(p);
    Rng rng{9};
    for (int i = 0; i < 100; ++i) {
      const Vec3 wi = support::random_direction(rng), wo = support::random_direction(rng);
      CHECK(value(model, wi, wo) == Approx(value(model, wo, wi)).epsilon(1e-5));  // float
    }
    CHECK(std::isfinite(value(model, direction(1e-9, 0.0), direction(1e-12, 1.0))));
  }
}

TEST_CASE("lanes with parameters of their own agree with lanes that share them", "[materials]") {
  RahmanPintyVerstraete model;
  model.rho0 = Curve{{0.4, 2.0}, {0.05, 0.2}, spectral::Outside::reject};
  model.k = Curve{{0.5, 1.5}, {0.6, 0.9}, spectral::Outside::reject};
  model.asymmetry = Curve{{0.5, 1.5}, {-0.2, 0.1}, spectral::Outside::reject};
  model.rho_c = Curve{{0.5, 1.5}, {0.3, 0.5}, spectral::Outside::reject};
  const auto both = bound(model);
  const auto first = bound(Rpv{model.rho0.at(Micrometres{0.5}), 0.6, -0.2, 0.3});
  const auto second = bound(Rpv{model.rho0.at(Micrometres{1.5}), 0.9, 0.1, 0.5});
  const Vec3 wi = at_zenith(20.0), wo = at_zenith(55.0, 130.0);
  CHECK(both.eval(wi, wo)[0] == Approx(first.eval(wi, wo)[0]).epsilon(1e-6));
  CHECK(both.eval(wi, wo)[1] == Approx(second.eval(wi, wo)[1]).epsilon(1e-6));
}

TEST_CASE("the albedo agrees with a finer rule", "[materials][rpv]") {
  const auto model = bound(Rpv{0.2, 0.6, -0.2});
  const double mu = GENERATE(0.05, 0.3, 0.77, 1.0);
  const Vec3 wo = direction(mu, 0.3);
  const double fine =
      support::integrate_hemisphere([&](Vec3 wi) { return value(model, wi, wo) * wi.z; });
  CHECK(model.albedo(wo).reflectance[0] == Approx(fine).epsilon(1e-3));
}

TEST_CASE("RPV parameters out of their domain, or that gain energy, are refused", "[materials]") {
  CHECK_THROWS_AS(bound(Rpv{-0.1, 1.0, 0.0}), InputError);
  CHECK_THROWS_AS(bound(Rpv{0.1, -0.1, 0.0}), InputError);
  CHECK_THROWS_AS(bound(Rpv{0.1, 2.1, 0.0}), InputError);
  CHECK_THROWS_AS(bound(Rpv{0.1, 1.0, 1.0}), InputError);
  CHECK_THROWS_AS(bound(Rpv{0.1, 1.0, 0.0, 1.5}), InputError);
  CHECK_THROWS_WITH(bound(Rpv{0.6, 0.5, 0.0}),
                    Catch::Matchers::Contains("rahman_pinty_verstraete: it reflects 2.363"));
}
