// Irradiances of a column, and what broadband light is summed from.
#include <cmath>
#include <numbers>
#include <numeric>

#include "atmosphere/broadband/broadband_fluxes.hpp"
#include "atmosphere/broadband/column_fluxes.hpp"
#include "atmosphere/hand_made_air.hpp"
#include "atmosphere/paths/spherical_path.hpp"
#include "atmosphere/transfer/discrete_ordinates.hpp"
#include "core/error.hpp"
#include "support/catch.hpp"

namespace nadir::atmosphere::test {
namespace {

using std::numbers::pi;

double whole_depth(const OpticalColumn& column) {
  double depth = 0.0;
  for (int k = 0; k < column.layers(); ++k) depth += column.depth(k);
  return depth;
}

/// Settings are looked at before the air is.
Layered no_air() {
  const auto dark = spectral::Curve::constant(0.0);
  return {{}, {}, {}, 0.0, {}, {}, {dark, dark, dark}};
}

/// Third exponential integral, int_0^1 mu exp(-t / mu) dmu, by the midpoint rule.
double exponential_integral_3(double t) {
  constexpr int count = 20000;
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double mu = (i + 0.5) / count;
    sum += mu * std::exp(-t / mu) / count;
  }
  return sum;
}

}  // namespace

TEST_CASE("air that only absorbs passes sunlight by Beer's law and scatters none",
          "[atmosphere][broadband]") {
  const HandMadeAir air{.rayleigh = 0.0, .absorption = 0.4};
  const OpticalColumn column = air.column();
  const auto fluxes = column_fluxes(column, {0.5, 1.0}, {}, 8);
  // Straight up it is the depth itself; at 60 degrees the shells' curvature takes 0.3 % of the
  // slant depth off.
  CHECK(fluxes.direct[1] == Approx(std::exp(-whole_depth(column))).epsilon(1e-12));
  CHECK(fluxes.direct[0] == Approx(std::exp(-0.8)).epsilon(4e-3));
  CHECK(fluxes.direct[0] > std::exp(-0.8));
  CHECK(fluxes.diffuse[0] == Approx(0.0).margin(1e-14));
  CHECK(fluxes.spherical_albedo == Approx(0.0).margin(1e-14));
  CHECK(fluxes.emitted == 0.0);
}

TEST_CASE("warm air of one temperature emits pi B (1 - 2 E3(t))", "[atmosphere][broadband]") {
  const double depth = GENERATE(0.05, 0.5, 3.0, 60.0);
  CAPTURE(depth);
  const HandMadeAir air{.rayleigh = 0.0, .absorption = depth};
  const OpticalColumn column = air.column();
  const std::vector<double> planck(column.level_height_m.size(), 7.0);
  const auto fluxes = column_fluxes(column, {}, planck, 8);
  const double exact = 7.0 * pi * (1.0 - 2.0 * exponential_integral_3(depth));
  // Four ordinates a hemisphere: 0.94 % in the thinnest air, whose horizon is unlike its zenith,
  // 0.2 % and less in the others.
  CHECK(fluxes.emitted == Approx(exact).epsilon(0.01));
}

TEST_CASE("the mean over azimuth alone gives the irradiance of the full solution",
          "[atmosphere][broadband]") {
  const HandMadeAir air{.rayleigh = 0.2, .haze = 0.4, .haze_albedo = 0.9, .absorption = 0.1};
  const OpticalColumn column = air.column();
  const double mu0 = 0.4;
  constexpr int streams = 8;
  const ScaledColumn scaled = delta_scaled(column, streams);
  std::vector<double> depth;
  for (int k = 0; k < column.layers(); ++k) depth.push_back(scaled.column.depth(k));
  TransferProblem problem;
  problem.beams.push_back({mu0, slant_depths(column.level_height_m, depth, mu0)});
  for (double& value : problem.beams[0].transmittance) value = std::exp(-value);
  const auto solved = discrete_ordinates(scaled, problem, streams, {-0.5, 0.5});

  const auto fluxes = column_fluxes(column, {mu0}, {}, streams);
  const double all = mu0 * fluxes.direct[0] + fluxes.diffuse[0];
  // The same equations in the same order: rounding only.
  CHECK(all ==
        Approx(solved.beams[0].fluxes.down_at_ground + mu0 * problem.beams[0].transmittance.back())
            .epsilon(1e-12));
  CHECK(fluxes.spherical_albedo == Approx(solved.ground.fluxes.down_at_ground / pi).epsilon(1e-12));
  // The direct part is that of the true column: less than the scaled one's.
  CHECK(fluxes.direct[0] < problem.beams[0].transmittance.back());
  CHECK(fluxes.direct[0] == Approx(std::exp(-whole_depth(column) / mu0)).epsilon(0.01));
}

TEST_CASE("light is neither made nor lost on its way to the ground", "[atmosphere][broadband]") {
  const std::vector<double> mu{0.0, 0.05, 0.2, 0.5, 1.0};
  const HandMadeAir clear{.rayleigh = 0.3, .haze = 0.5};
  const HandMadeAir dirty{.rayleigh = 0.3, .haze = 0.5, .haze_albedo = 0.8, .absorption = 0.2};
  const auto bright = column_fluxes(clear.column(), mu, {}, 8);
  const auto dim = column_fluxes(dirty.column(), mu, {}, 8);
  for (std::size_t i = 0; i < mu.size(); ++i) {
    CAPTURE(mu[i]);
    CHECK(bright.diffuse[i] >= 0.0);
    // Near the horizon the earth's curvature lets light into the air that level layers do not
    // count: from 3 degrees on it is gone.
    if (mu[i] >= 0.05) CHECK(mu[i] * bright.direct[i] + bright.diffuse[i] < 1.02 * mu[i]);
    CHECK(dim.diffuse[i] < bright.diffuse[i]);
    CHECK(dim.direct[i] < bright.direct[i]);
    if (i > 0) CHECK(bright.direct[i] > bright.direct[i - 1]);
    if (i > 0) CHECK(bright.diffuse[i] > bright.diffuse[i - 1]);
  }
  CHECK(bright.spherical_albedo > dim.spherical_albedo);
  CHECK(bright.spherical_albedo < 1.0);
}

TEST_CASE("few streams give the irradiance of many", "[atmosphere][broadband]") {
  const HandMadeAir air{
      .rayleigh = 0.1, .haze = 0.4, .haze_g = 0.7, .haze_albedo = 0.95, .absorption = 0.05};
  const std::vector<double> mu{0.1, 0.3, 0.6, 1.0};
  const auto few = column_fluxes(air.column(), mu, {}, 8);
  const auto many = column_fluxes(air.column(), mu, {}, 48);
  for (std::size_t i = 0; i < mu.size(); ++i) {
    CAPTURE(mu[i]);
    CHECK(few.direct[i] == many.direct[i]);
    // Measured 0.5 % at worst.
    CHECK(few.diffuse[i] == Approx(many.diffuse[i]).epsilon(0.01));
  }
}

TEST_CASE("settings that make no sense are refused", "[atmosphere][broadband]") {
  const auto sun = spectral::Curve::constant(1000.0);
  BroadbandSettings settings;
  SECTION("edges that do not ascend") { settings.solar_edges_um = {0.4, 0.4}; }
  SECTION("one edge") { settings.long_wave_edges_um = {8.0}; }
  SECTION("outside the tables") { settings.long_wave_edges_um = {8.0, 300.0}; }
  SECTION("a sun below the horizon") { settings.cos_zenith = {-0.1, 0.5}; }
  SECTION("more light than came") { settings.ground_reflectance = 1.5; }
  CHECK_THROWS_AS(broadband_fluxes(no_air(), settings, sun), InputError);
}

TEST_CASE("a sun that is not known at all of its light is refused", "[atmosphere][broadband]") {
  const spectral::Curve visible{{0.4, 0.7}, {1800.0, 1500.0}, spectral::Outside::zero};
  CHECK_THROWS_AS(broadband_fluxes(no_air(), BroadbandSettings{}, visible), InputError);
}

}  // namespace nadir::atmosphere::test
