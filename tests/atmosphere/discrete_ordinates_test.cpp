#include "atmosphere/transfer/discrete_ordinates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "atmosphere/slab.hpp"
#include "atmosphere/transfer/column_optics.hpp"
#include "core/error.hpp"
#include "support/catch.hpp"

namespace nadir::atmosphere {
namespace {

using std::numbers::pi;
using test::column_of;
using test::plane_beam;

PhaseFunction phase_by_name(const std::string& name) {
  if (name == "rayleigh") return PhaseFunction::rayleigh(0.0279);
  return PhaseFunction::henyey_greenstein(name == "isotropic" ? 0.0 : 0.9);
}

/// All light that may shine on a column, over Planck radiances at its levels.
TransferProblem everything(const ScaledColumn& scaled, double mu0, double planck) {
  TransferProblem problem;
  problem.beams = {plane_beam(scaled.column, mu0)};
  problem.thermal = true;
  problem.planck.assign(static_cast<std::size_t>(scaled.column.layers()) + 1, planck);
  problem.sky = true;
  return problem;
}

// Nothing is absorbed: what comes in goes out. The sums themselves are good to 1e-10; the promise
// is 1e-6.
TEST_CASE("scattering without absorption conserves energy at every depth",
          "[atmosphere][transfer]") {
  const auto depth = GENERATE(1e-8, 1e-3, 0.3, 10.0, 1e3);
  const auto layers = GENERATE(1, 60);
  const std::string name = GENERATE("isotropic", "rayleigh", "henyey_greenstein");
  const int streams = layers == 60 ? 8 : 32;
  CAPTURE(depth, layers, name);
  const std::vector<double> depths(static_cast<std::size_t>(layers), depth / layers);
  const ScaledColumn scaled = delta_scaled(column_of(depths, 1.0, phase_by_name(name)), streams);
  for (const double mu0 : {1.0, 0.4, 0.02}) {
    const TransferProblem problem = everything(scaled, mu0, 0.0);
    const TransferSolution s = discrete_ordinates(scaled, problem, streams, {});
    const double direct = mu0 * problem.beams[0].transmittance.back();
    const FieldFluxes& beam = s.beams[0].fluxes;
    CHECK(beam.up_at_top + beam.down_at_ground + direct == Approx(mu0).epsilon(1e-10));
    for (const FieldFluxes& even : {s.sky.fluxes, s.ground.fluxes}) {
      CHECK(even.up_at_top + even.down_at_ground == Approx(pi).epsilon(1e-10));
    }
  }
}

TEST_CASE("the net flux without absorption is the same at every level", "[atmosphere][transfer]") {
  const auto depth = GENERATE(1e-8, 1.0, 1e3);
  const std::string name = GENERATE("isotropic", "rayleigh", "henyey_greenstein");
  CAPTURE(depth, name);
  const int streams = 16;
  const ScaledColumn scaled =
      delta_scaled(column_of(test::graded(depth, 20), 1.0, phase_by_name(name)), streams);
  const std::vector<LayerOptics> layers = layer_optics(scaled, streams);
  const double mu0 = 0.35;
  const BeamIn beam = plane_beam(scaled.column, mu0);
  const std::vector<SourceProfile> profiles = beam_profiles(beam, layers);
  ModeSource source;
  source.profile = &profiles;
  const LegendreTable legendre{0, streams, {-mu0}};
  for (int l = 0; l < streams; ++l) source.angular.push_back(*legendre.row(l) / (4.0 * pi));
  const ModeField field = solve_mode(double_gauss(streams), 0, layers, {source});
  const double net = mu0 - field.up[0];
  for (std::size_t level = 1; level < field.up.size(); ++level) {
    const double direct = mu0 * beam.transmittance[level];
    CHECK(field.down[level] + direct - field.up[level] == Approx(net).margin(1e-10));
  }
}

TEST_CASE("light in a closed enclosure of one temperature is Planck's everywhere",
          "[atmosphere][transfer]") {
  const auto streams = GENERATE(2, 4, 8, 16, 32);
  const auto omega = GENERATE(0.0, 0.5, 0.999999, 1.0);
  const std::string name = GENERATE("isotropic", "rayleigh", "henyey_greenstein");
  CAPTURE(streams, omega, name);
  const ScaledColumn scaled =
      delta_scaled(column_of({1e-8, 0.01, 0.7, 30.0}, omega, phase_by_name(name)), streams);
  const double planck = 7.5;
  const TransferProblem problem = everything(scaled, 0.5, planck);
  const std::vector<double> mu{-1.0, -0.4, -0.01, 0.03, 0.6, 1.0};
  const TransferSolution s = discrete_ordinates(scaled, problem, streams, mu);
  for (int place = 0; place < 8; ++place) {
    const double depth = scaled.column.depth(place / 2);
    const double scaled_omega = scaled.column.scattering(place / 2) / depth;
    for (int i = 0; i < 6; ++i) {
      const double j = s.thermal.at(place, 0, i) + planck * s.sky.at(place, 0, i) +
                       planck * s.ground.at(place, 0, i);
      // 1e-9: rounding, where the field of one source is near 0 and of another near 1
      CHECK(j == Approx(scaled_omega * planck).epsilon(1e-9).margin(1e-12));
    }
  }
  for (std::size_t i = 0; i < mu.size(); ++i) {
    double radiance = 0.0;
    for (const Light light : {Light::thermal, Light::sky, Light::ground}) {
      radiance += (light == Light::thermal ? 1.0 : planck) *
                  slab_radiance(scaled, problem, s, {light, 0, i, 0.0, 0});
    }
    CHECK(radiance == Approx(planck).epsilon(1e-9));
  }
}

TEST_CASE(
    "warm air over a black ground of its temperature looks like Planck where nothing "
    "scatters",
    "[atmosphere][transfer]") {
  const ScaledColumn scaled =
      delta_scaled(column_of({0.01, 0.5, 3.0}, 0.0, PhaseFunction::rayleigh(0.0)), 8);
  const TransferProblem problem = everything(scaled, 0.5, 9.2);
  const std::vector<double> mu{0.02, 0.5, 1.0};
  const TransferSolution s = discrete_ordinates(scaled, problem, 8, mu);
  for (std::size_t i = 0; i < mu.size(); ++i) {
    const double up = slab_radiance(scaled, problem, s, {Light::thermal, 0, i, 0.0, 0}) +
                      9.2 * slab_radiance(scaled, problem, s, {Light::ground, 0, i, 0.0, 0});
    CHECK(up == Approx(9.2).epsilon(1e-12));
  }
}

// B = a + b tau without scattering: up at the top a + b mu less what lies below the bottom,
// [a + b (t + mu)] exp(-t / mu).
TEST_CASE("air whose Planck radiance is linear in depth emits as the closed form says",
          "[atmosphere][transfer]") {
  const double a = 2.0, b = 3.0, t = 1.7;
  const ScaledColumn scaled =
      delta_scaled(column_of({0.3, 1e-7, 1.4 - 1e-7}, 0.0, PhaseFunction::rayleigh(0.0)), 16);
  TransferProblem problem;
  problem.thermal = true;
  double depth = 0.0;
  problem.planck = {a};
  for (int k = 0; k < 3; ++k) {
    depth += scaled.column.depth(k);
    problem.planck.push_back(a + b * depth);
  }
  const std::vector<double> mu{0.05, 0.5, 1.0};
  const TransferSolution s = discrete_ordinates(scaled, problem, 16, mu);
  for (std::size_t i = 0; i < mu.size(); ++i) {
    const double exact = a + b * mu[i] - (a + b * (t + mu[i])) * std::exp(-t / mu[i]);
    CHECK(slab_radiance(scaled, problem, s, {Light::thermal, 0, i, 0.0, 0}) ==
          Approx(exact).epsilon(1e-11));
  }
  // Irradiance: 2 pi int mu I dmu by the ordinates; 16 streams integrate it to 1e-6.
  double flux = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const double m = (i + 0.5) / 4000;
    flux += 2.0 * pi * m / 4000 * (a + b * m - (a + b * (t + m)) * std::exp(-t / m));
  }
  CHECK(s.thermal.fluxes.up_at_top == Approx(flux).epsilon(1e-5));
}

TEST_CASE("a column does not change when its layers are cut in two", "[atmosphere][transfer]") {
  const PhaseFunction phase = PhaseFunction::henyey_greenstein(0.8);
  const double omega = GENERATE(0.3, 0.95, 1.0);
  const std::vector<double> mu{-0.9, -0.2, 0.1, 0.7};
  const ScaledColumn whole = delta_scaled(column_of({0.4, 2.0}, omega, phase), 8);
  const ScaledColumn cut = delta_scaled(column_of({0.1, 0.3, 1.0, 1.0}, omega, phase), 8);
  const auto solve = [&](const ScaledColumn& column) {
    TransferProblem problem = everything(column, 0.35, 0.0);
    double depth = 0.0;
    for (std::size_t k = 0; k < problem.planck.size(); ++k) {
      problem.planck[k] = 1.0 + depth;
      if (k + 1 < problem.planck.size()) depth += column.column.depth(static_cast<int>(k));
    }
    return discrete_ordinates(column, problem, 8, mu);
  };
  const TransferSolution a = solve(whole), b = solve(cut);
  // places of `whole` among those of `cut`
  const int same[4][2] = {{0, 0}, {1, 3}, {2, 4}, {3, 7}};
  for (const auto& [here, there] : same) {
    for (int i = 0; i < 4; ++i) {
      for (int m = 0; m < std::min(a.beams[0].modes, b.beams[0].modes); ++m) {
        CHECK(a.beams[0].at(here, m, i) ==
              Approx(b.beams[0].at(there, m, i)).epsilon(1e-10).margin(1e-13));
      }
      CHECK(a.thermal.at(here, 0, i) == Approx(b.thermal.at(there, 0, i)).epsilon(1e-10));
      CHECK(a.sky.at(here, 0, i) == Approx(b.sky.at(there, 0, i)).epsilon(1e-10));
      CHECK(a.ground.at(here, 0, i) == Approx(b.ground.at(there, 0, i)).epsilon(1e-10));
    }
  }
}

// mu0 I(mu; mu0) = mu I(mu0; mu) for beams of equal irradiance across their way, here for light
// scattered back by a column that is not the same from top to bottom.
TEST_CASE("light that a column scatters back obeys reciprocity", "[atmosphere][transfer]") {
  OpticalColumn column = column_of(test::graded(2.0, 240), 0.9, PhaseFunction::rayleigh(0.0279));
  OpticalColumn::Kind haze{std::vector<double>(240, 0.0), nullptr};
  for (std::size_t k = 120; k < 240; ++k)
    haze.scattering[k] = 0.4 * column.depth(static_cast<int>(k));
  haze.phase = std::make_shared<const PhaseFunction>(PhaseFunction::henyey_greenstein(0.7));
  column.kinds.push_back(haze);
  const double azimuth = GENERATE(0.0, 1.0, 3.0);
  const double one = 0.3, other = 0.8;
  const test::Slab from_one{column, 16, one, {other}}, from_other{column, 16, other, {one}};
  // Exact for the discrete directions; J between them and linear within layers costs 1e-5.
  CHECK(other * from_one.radiance(0, azimuth) ==
        Approx(one * from_other.radiance(0, azimuth)).epsilon(3e-5));
}

TEST_CASE("a beam whose fading equals an eigenvalue is nothing special", "[atmosphere][transfer]") {
  // omega = 0: k = 1 / mu of the ordinates exactly; omega = 0.8: somewhere in between, so that a
  // scan over mu0 passes it. The flux as a function of mu0 must have no spike.
  const double omega = GENERATE(1e-6, 0.8);
  const ScaledColumn scaled =
      delta_scaled(column_of({1.5}, omega, PhaseFunction::henyey_greenstein(0.0)), 4);
  const auto up = [&](double mu0) {
    return discrete_ordinates(scaled, everything(scaled, mu0, 0.0), 4, {})
        .beams[0]
        .fluxes.up_at_top;
  };
  const double node = 0.5 + 0.5 / std::sqrt(3.0);  // an ordinate of 4 streams
  for (const double offset : {0.0, 1e-15, 1e-12, 1e-9, 1e-6}) {
    CHECK(up(node + offset) == Approx(up(node + 1e-5)).epsilon(3e-5));
  }
  double largest = 0.0;
  for (double mu0 = 0.1; mu0 < 0.99; mu0 += 0.001) {
    largest = std::max(largest, std::abs(up(mu0 + 1e-3) - 2.0 * up(mu0 + 5e-4) + up(mu0)));
  }
  CHECK(largest < 1e-6);  // the curvature of a smooth function over 5e-4
}

TEST_CASE("light of a body below the horizon comes from below", "[atmosphere][transfer]") {
  const ScaledColumn scaled =
      delta_scaled(column_of({0.2, 0.2, 0.2}, 1.0, PhaseFunction::henyey_greenstein(0.6)), 8);
  TransferProblem problem;
  problem.beams = {{-0.05, {0.8, 0.3, 0.0, 0.0}}, {0.05, {0.8, 0.3, 0.0, 0.0}}};
  const TransferSolution s = discrete_ordinates(scaled, problem, 8, {-1.0, 1.0});
  for (const ScatteredSource& beam : s.beams) {
    for (const double value : beam.value) CHECK(std::isfinite(value));
    // What the layers scatter: the mean of the beam, exponential in the lit layer and linear in the
    // one on the shadow's edge.
    const double depth = scaled.column.depth(0);
    const double lit = depth * (0.8 - 0.3) / std::log(0.8 / 0.3);
    if (&beam == &s.beams[0]) {
      CHECK(beam.fluxes.up_at_top + beam.fluxes.down_at_ground ==
            Approx(lit + depth * 0.5 * 0.3).epsilon(1e-10));
    }
  }
  // Scattering is mostly forwards: up from below, down from above.
  CHECK(s.beams[0].fluxes.up_at_top > s.beams[1].fluxes.up_at_top);
}

TEST_CASE("azimuth modes sum to a field that is even and free of the horizon's plane",
          "[atmosphere][transfer]") {
  const OpticalColumn column = column_of({0.5}, 0.9, PhaseFunction::henyey_greenstein(0.7));
  const ScaledColumn scaled = delta_scaled(column, 16);
  TransferProblem problem;
  problem.beams = {plane_beam(scaled.column, 1.0), plane_beam(scaled.column, 0.5)};
  const TransferSolution s = discrete_ordinates(scaled, problem, 16, {-1.0, -0.5, 0.5, 1.0});
  CHECK(s.beams[0].modes == 1);  // the sun in the zenith
  CHECK(s.beams[1].modes > 3);
  for (int m = 1; m < s.beams[1].modes; ++m) {
    for (int place = 0; place < 2; ++place) {
      // straight up and down there is no azimuth
      CHECK(std::abs(s.beams[1].at(place, m, 0)) < 1e-15);
      CHECK(std::abs(s.beams[1].at(place, m, 3)) < 1e-15);
    }
  }
}

TEST_CASE("columns and problems that do not fit are refused", "[atmosphere][transfer]") {
  const ScaledColumn scaled = delta_scaled(column_of({0.5}, 0.9, PhaseFunction::rayleigh(0.0)), 8);
  const TransferProblem good = everything(scaled, 0.5, 1.0);
  CHECK_THROWS_AS(discrete_ordinates(scaled, good, 7, {1.0}), InputError);
  CHECK_THROWS_AS(discrete_ordinates(scaled, good, 130, {1.0}), InputError);
  CHECK_THROWS_AS(discrete_ordinates(scaled, good, 8, {1.5}), InputError);
  CHECK_THROWS_AS(delta_scaled(scaled.column, 0), InputError);
  TransferProblem bad = good;
  bad.planck.pop_back();
  CHECK_THROWS_AS(discrete_ordinates(scaled, bad, 8, {1.0}), InputError);
  bad = good;
  bad.beams[0].transmittance.push_back(0.0);
  CHECK_THROWS_AS(discrete_ordinates(scaled, bad, 8, {1.0}), InputError);
  bad = good;
  bad.beams[0].mu0 = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(discrete_ordinates(scaled, bad, 8, {1.0}), InputError);
  ScaledColumn negative = scaled;
  negative.column.absorption[0] = -1.0;
  CHECK_THROWS_AS(discrete_ordinates(negative, good, 8, {1.0}), InputError);
}

}  // namespace
}  // namespace nadir::atmosphere
