#include "materials/scattering/hapke.hpp"

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

BoundHapke bound(const Hapke& model) {
  const spectral::Lanes lanes{{Micrometres{0.5}, Micrometres{1.5}}};
  const Spectrum none{lanes.count()};
  return std::get<BoundHapke>(materials::bind(Scattering{model}, BindContext{lanes, none, none}));
}

Hapke smooth(double w, double b = 0.0, double c = 0.0) {
  Hapke model;
  model.single_scattering_albedo = Curve::constant(w);
  model.asymmetry_b = b;
  model.asymmetry_c = c;
  return model;
}

Vec3 at_zenith(double zenith_deg, double azimuth_deg = 0.0) {
  return direction(std::cos(zenith_deg * degree), azimuth_deg * degree);
}

double value(const BoundHapke& model, Vec3 wi, Vec3 wo) {
  return static_cast<double>(model.eval(wi, wo)[0]);
}

// The same equations once more, term by term as the paper prints them, for both orders of the
// angles: r (w = 1, P and H left out) = mu_0e / (mu_0e + mu_e) S(i, e, psi).
double paper_roughness(double i, double e, double psi, double theta_bar) {
  const double pi = std::numbers::pi, cot_bar = 1.0 / std::tan(theta_bar);
  const auto cot = [](double x) { return 1.0 / std::tan(x); };
  const auto e1 = [&](double x) { return std::exp(-2.0 / pi * cot_bar * cot(x)); };
  const auto e2 = [&](double x) {
    return std::exp(-std::pow(cot_bar, 2) * std::pow(cot(x), 2) / pi);
  };
  const double chi = 1.0 / std::sqrt(1.0 + pi * std::pow(std::tan(theta_bar), 2));
  const auto eta = [&](double x) {
    return chi * (std::cos(x) + std::sin(x) * std::tan(theta_bar) * e2(x) / (2.0 - e1(x)));
  };
  const double f = std::exp(-2.0 * std::tan(0.5 * psi)), s2 = std::pow(std::sin(0.5 * psi), 2);
  const bool above = i <= e;
  const double far = above ? e : i, near = above ? i : e;
  const double below = 2.0 - e1(far) - psi / pi * e1(near);
  const double plus = (std::cos(psi) * e2(far) + s2 * e2(near)) / below;
  const double minus = (e2(far) - s2 * e2(near)) / below;
  const double tan_bar = std::tan(theta_bar);
  const double mu_0e = chi * (std::cos(i) + std::sin(i) * tan_bar * (above ? plus : minus));
  const double mu_e = chi * (std::cos(e) + std::sin(e) * tan_bar * (above ? minus : plus));
  const double inner = above ? std::cos(i) / eta(i) : std::cos(e) / eta(e);
  const double shadowing = mu_e / eta(e) * std::cos(i) / eta(i) * chi / (1.0 - f + f * chi * inner);
  return mu_0e / (mu_0e + mu_e) * shadowing;
}

}  // namespace

// Exact H of isotropic scatterers: Chandrasekhar, Radiative Transfer (1960), Table XI, recomputed
// to six digits. Hapke (2002) states his formula's error as below 1 %.
TEST_CASE("H agrees with Chandrasekhar's", "[materials][hapke]") {
  struct Row {
    double mu;
    std::array<double, 4> h;  // at w = 0.2, 0.5, 0.9, 1
  };
  constexpr std::array<double, 4> w{0.2, 0.5, 0.9, 1.0};
  constexpr std::array<Row, 6> exact{{
      {0.0, {1.000000, 1.000000, 1.000000, 1.000000}},
      {0.05, {1.016053, 1.044265, 1.099678, 1.136575}},
      {0.2, {1.038917, 1.113461, 1.291434, 1.450351}},
      {0.5, {1.061177, 1.187735, 1.556034, 2.012779}},
      {0.8, {1.073187, 1.230885, 1.747402, 2.552704}},
      {1.0, {1.078645, 1.251260, 1.850099, 2.907811}},
  }};
  for (const Row& row : exact) {
    for (std::size_t i = 0; i < w.size(); ++i) {
      CAPTURE(row.mu, w[i]);
      CHECK(hapke_h(w[i], row.mu) == Approx(row.h[i]).epsilon(0.01));
    }
  }
}

TEST_CASE("a black Hapke surface reflects nothing, a dim one scatters once", "[materials]") {
  CHECK(bound(smooth(0.0)).eval(at_zenith(10.0), at_zenith(40.0)).max() == 0.0F);
  // Lommel-Seeliger: f = w / (4 pi (mu_i + mu_o)); multiple scattering is of second order in w
  const Vec3 wi = at_zenith(20.0), wo = at_zenith(60.0, 50.0);
  const double once = 1e-4 / (4.0 * std::numbers::pi * (wi.z + wo.z));
  CHECK(value(bound(smooth(1e-4)), wi, wo) == Approx(once).epsilon(1e-3));
}

// For isotropic scatterers f = w / (4 pi) H H / (mu + mu'), and the albedo is exactly
// 1 - sqrt(1 - w) H(mu) with the exact H (Chandrasekhar 1960, section 40). 0.01: H's error.
TEST_CASE("the albedo of isotropic scatterers is Chandrasekhar's", "[materials][hapke]") {
  const double w = GENERATE(0.2, 0.5, 0.9);
  const BoundHapke model = bound(smooth(w));
  struct Exact {
    double mu, at_02, at_05, at_09;
  };
  for (const Exact& e :
       {Exact{0.2, 1.038917, 1.113461, 1.291434}, Exact{0.5, 1.061177, 1.187735, 1.556034},
        Exact{1.0, 1.078645, 1.251260, 1.850099}}) {
    const double h = w < 0.3 ? e.at_02 : w < 0.7 ? e.at_05 : e.at_09;
    const Spectrum rho = model.albedo(direction(e.mu, 0.0)).reflectance;
    CHECK(static_cast<double>(rho[0]) == Approx(1.0 - std::sqrt(1.0 - w) * h).margin(0.01));
  }
}

TEST_CASE("c moves the phase function's lobe from forward to backward", "[materials][hapke]") {
  const Vec3 wi = at_zenith(50.0), back = at_zenith(50.0), forward = at_zenith(50.0, 180.0);
  const BoundHapke backward_model = bound(smooth(0.3, 0.4, 1.0));
  const BoundHapke forward_model = bound(smooth(0.3, 0.4, -1.0));
  CHECK(value(backward_model, wi, back) > 1.5 * value(backward_model, wi, forward));
  CHECK(value(forward_model, wi, forward) > 1.5 * value(forward_model, wi, back));
  // closed form at the hot spot: p(0) = (1 + b) / (1 - b)^2 for c = 1
  const double h = hapke_h(0.3, wi.z), p = 1.4 / 0.36;
  const double expected = 0.3 / (8.0 * std::numbers::pi * wi.z) * (p + h * h - 1.0);
  CHECK(value(backward_model, wi, back) == Approx(expected).epsilon(1e-5));  // float
}

TEST_CASE("the opposition effect doubles single scattering at phase 0", "[materials][hapke]") {
  Hapke model = smooth(0.1, 0.2, 0.5);
  const Vec3 w = at_zenith(30.0);
  const double without = value(bound(model), w, w);
  model.opposition_b0 = 1.0;
  model.opposition_h = 0.05;
  const BoundHapke with = bound(model);
  const double h = hapke_h(0.1, w.z);
  const double multiple = 0.1 / (8.0 * std::numbers::pi * w.z) * (h * h - 1.0);
  CHECK(value(with, w, w) - multiple == Approx(2.0 * (without - multiple)).epsilon(1e-5));
  // half its height where tan(g / 2) = h
  const Vec3 wo = at_zenith(30.0 + 2.0 * std::atan(0.05) / degree);
  model.opposition_b0 = 0.0;
  const BoundHapke bare = bound(model);
  const double single = value(bare, w, wo) - 0.1 / (4.0 * std::numbers::pi * (w.z + wo.z)) *
                                                 (h * hapke_h(0.1, wo.z) - 1.0);
  CHECK(value(with, w, wo) - value(bare, w, wo) == Approx(0.5 * single).epsilon(1e-4));
}

// USGS ISIS 3 (public domain, CC0), class HapkeHen, the truth of its unit test. It gives the
// radiance factor r = f mu_i (without pi: w / 4 where ours has w / (4 pi)), and has the older H =
// (1 + 2x) / (1 + 2xg), which at w = 0.5 is 0.7 % below the exact one: up to 1.5 % of r.
TEST_CASE("Hapke reflectances agree with the USGS implementation", "[materials][hapke]") {
  const Vec3 up{0.0, 0.0, 1.0};
  const BoundHapke plain = bound(smooth(0.5));  // its defaults: w = 0.5, isotropic, smooth
  CHECK(std::numbers::pi * value(plain, up, up) == Approx(0.0965097).epsilon(0.017));
  // phase 60, incidence 45, emission 30 degrees
  const double cos_i = std::cos(45.0 * degree), cos_e = std::cos(30.0 * degree);
  const double cos_azimuth = (std::cos(60.0 * degree) - cos_i * cos_e) /
                             (std::sin(45.0 * degree) * std::sin(30.0 * degree));
  const Vec3 wi = at_zenith(45.0), wo = direction(cos_e, std::acos(cos_azimuth));
  CHECK(std::numbers::pi * cos_i * value(plain, wi, wo) == Approx(0.0832883).epsilon(0.017));
  // w = 0.52, b = 0.213 all backward, B0 = 1, h = 1, slopes of 30 degrees
  Hapke model = smooth(0.52, 0.213, 1.0);
  model.mean_slope_rad = 30.0 * degree;
  model.opposition_b0 = 1.0;
  model.opposition_h = 1.0;
  CHECK(std::numbers::pi * value(bound(model), up, up) == Approx(0.286048).epsilon(0.017));
}

TEST_CASE("slopes act as the equations of Hapke (1984) say", "[materials][hapke]") {
  const double w = 1e-4;  // multiple scattering is below 1e-3 of the single
  Hapke model = smooth(w);
  model.mean_slope_rad = 25.0 * degree;
  const BoundHapke rough = bound(model);
  Rng rng{5};
  for (int n = 0; n < 100; ++n) {
    const double i = 1.5 * rng.next(), e = 1.5 * rng.next(), psi = 3.1 * rng.next();
    const Vec3 wi = direction(std::cos(i), 0.4), wo = direction(std::cos(e), 0.4 + psi);
    const double expected = w / (4.0 * std::numbers::pi) *
                            paper_roughness(i, e, psi, model.mean_slope_rad) / std::cos(i);
    CHECK(value(rough, wi, wo) == Approx(expected).epsilon(1e-3));
  }
}

TEST_CASE("no slopes and vanishing slopes are the same", "[materials][hapke]") {
  Hapke model = smooth(0.6, 0.3, 0.2);
  const BoundHapke flat = bound(model);
  model.mean_slope_rad = 1e-4;
  const BoundHapke nearly = bound(model);
  Rng rng{3};
  for (int i = 0; i < 200; ++i) {
    const Vec3 wi = at_zenith(85.0 * rng.next(), 360.0 * rng.next()), wo = at_zenith(60.0);
    CHECK(value(nearly, wi, wo) == Approx(value(flat, wi, wo)).epsilon(1e-4));  // second order
  }
}

TEST_CASE("a rough Hapke surface is reciprocal and darker at large phase angles", "[materials]") {
  Hapke model = smooth(0.7, 0.3, -0.4);
  model.opposition_b0 = 0.6;
  const BoundHapke flat = bound(model);
  model.mean_slope_rad = GENERATE(5.0, 20.0, 60.0) * degree;
  const BoundHapke rough = bound(model);
  Rng rng{11};
  for (int i = 0; i < 500; ++i) {
    const Vec3 wi = support::random_direction(rng), wo = support::random_direction(rng);
    const double f = value(rough, wi, wo);
    CHECK(std::isfinite(f));
    CHECK(f >= 0.0);
    CHECK(f == Approx(value(rough, wo, wi)).epsilon(1e-5).margin(1e-12));  // float
  }
  CHECK(value(rough, at_zenith(70.0), at_zenith(70.0, 180.0)) <
        value(flat, at_zenith(70.0), at_zenith(70.0, 180.0)));
}

TEST_CASE("a rough surface stays finite in the horizon", "[materials][hapke]") {
  Hapke model = smooth(0.9, 0.3, -0.4);
  model.mean_slope_rad = 60.0 * degree;
  const BoundHapke rough = bound(model);
  for (const double mu : {1e-300, 1e-17, 1e-9, 1e-3}) {
    for (const double azimuth : {0.0, 1.0, std::numbers::pi}) {
      const double f = value(rough, direction(mu, 0.0), direction(mu, azimuth));
      CHECK(std::isfinite(f));
      CHECK(f >= 0.0);
      CHECK(std::isfinite(value(rough, direction(mu, 0.0), direction(0.5, azimuth))));
    }
  }
}

TEST_CASE("Hapke parameters out of their domain are refused", "[materials][hapke]") {
  const auto with = [](auto change) {
    Hapke model = smooth(0.5);
    change(model);
    return model;
  };
  using M = Hapke&;
  CHECK_THROWS_AS(bound(smooth(1.1)), InputError);
  CHECK_THROWS_AS(bound(smooth(-0.1)), InputError);
  CHECK_THROWS_AS(bound(smooth(0.5, 1.0)), InputError);
  CHECK_THROWS_AS(bound(smooth(0.5, 0.3, 1.2)), InputError);
  CHECK_THROWS_AS(bound(with([](M m) { m.opposition_b0 = -0.1; })), InputError);
  CHECK_THROWS_AS(bound(with([](M m) { m.opposition_h = 0.0; })), InputError);
  CHECK_THROWS_AS(bound(with([](M m) { m.mean_slope_rad = 1.2; })), InputError);
  CHECK_THROWS_WITH(bound(with([](M m) {
                      m.single_scattering_albedo = Curve::constant(1.0);
                      m.opposition_b0 = 1.0;
                      m.opposition_h = 0.5;
                    })),
                    Catch::Matchers::Contains("hapke: it reflects 1."));
}
