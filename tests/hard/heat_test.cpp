#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "support/catch.hpp"
#include "thermal/conduction_runs.hpp"
#include "thermal/heat_scene.hpp"
#include "thermal/solve/heat_solver.hpp"
#include "thermal/surface/surface_balance.hpp"

// The heat balance at the ends of what it takes: temperatures, layers, steps, loads.

namespace nadir::thermal::test {
namespace {

/// Absorbs a load and radiates as a black body into a sky of 3 K.
struct RadiatingFlux {
  double load_w_m2 = 0.0;
  SurfaceFlux operator()(double /*time_s*/, double t) const {
    return {load_w_m2 - si::stefan_boltzmann * (t * t * t * t - 81.0),
            -4.0 * si::stefan_boltzmann * t * t * t};
  }
};

void check_within_range(const Run& run) {
  for (const double k : run.temperature) {
    REQUIRE(k >= least_temperature.value);
    REQUIRE(k <= greatest_temperature.value);
  }
}

TEST_CASE("layers from 1e-6 m to 100 m, conductivity 1e-6 to 1e6, steps of 1 s and 1 h stay sane",
          "[hard][heat]") {
  const double thickness_m = GENERATE(1e-6, 1e-3, 100.0);
  const double conductivity = GENERATE(1e-6, 1.0, 1e6);
  const double step_s = GENERATE(1.0, 3600.0);
  CAPTURE(thickness_m, conductivity, step_s);
  const LayerStack stack{{{{conductivity, 1000.0, 1000.0}, thickness_m, 0.0}}, AdiabaticBack{}};
  Run run{stack, {}, step_s, 290.0};
  for (int i = 0; i < 200; ++i) {
    run.advance(RadiatingFlux{i < 100 ? 1000.0 : 0.0});
    check_within_range(run);
  }
  // 1000 W m^-2 keep a black body at 364 K and nothing here is warmer: no overshoot.
  for (const double k : run.temperature) CHECK(k <= 364.5);
}

TEST_CASE("a foil of 1e-6 m takes the temperature of radiative balance within one step of an hour",
          "[hard][heat]") {
  const LayerStack foil{{{{1.0, 1000.0, 1000.0}, 1e-6, 0.0}}, AdiabaticBack{}};
  for (const double load : {1e-3, 1.0, 1000.0, 5e5}) {
    Run run{foil, {}, 3600.0, 290.0};
    for (int i = 0; i < 60; ++i) run.advance(RadiatingFlux{load});
    const double balance = std::pow(load / si::stefan_boltzmann + 81.0, 0.25);
    CAPTURE(load);
    CHECK(run.surface_k() == Approx(balance).epsilon(1e-3));
    check_within_range(run);
  }
}

TEST_CASE("100 m of ground under a sun switched on warm by 2 q sqrt(alpha t / pi) / k",
          "[hard][heat]") {
  // Carslaw and Jaeger, Conduction of Heat in Solids, 2nd ed., section 2.9, equation (8).
  const Substance rock{2.0, 2500.0, 800.0};
  const double step_s = GENERATE(60.0, 3600.0);
  Run run{{{{rock, 100.0, 0.0}}, AdiabaticBack{}}, {}, step_s, 290.0};
  const auto constant = [](double, double) { return SurfaceFlux{500.0, 0.0}; };
  run.advance_to(24.0 * 3600.0, constant);
  const double law = 2.0 * 500.0 / rock.conductivity_w_m_k *
                     std::sqrt(rock.diffusivity_m2_s() * 86400.0 / std::numbers::pi);
  CAPTURE(step_s);
  // 1 % of 117 K: the default grid's error after a jump (docs/heat-conduction.md states 0.5 %).
  CHECK(run.surface_k() - 290.0 == Approx(law).epsilon(0.01));
  CHECK(run.heat_j_m2() - 290.0 * rock.heat_capacity_j_m3_k() * 100.0 ==
        Approx(500.0 * 86400.0).epsilon(1e-6));
}

TEST_CASE("from 2.7 K and from 2000 K a surface finds the same balance", "[hard][heat]") {
  const LayerStack plate{{{{45.0, 7800.0, 480.0}, 0.002, 0.0}}, AdiabaticBack{}};
  const double step_s = GENERATE(1.0, 600.0, 3600.0);
  double ends[2] = {};
  int which = 0;
  for (const double start : {least_temperature.value, greatest_temperature.value}) {
    Run run{plate, {}, step_s, start};
    while (run.time_s < 200.0 * 3600.0 * std::min(1.0, step_s / 60.0)) {
      run.advance(RadiatingFlux{800.0});
      check_within_range(run);
    }
    ends[which++] = run.surface_k();
  }
  const double balance = std::pow(800.0 / si::stefan_boltzmann, 0.25);
  const double digits = step_s < 60.0 ? 0.1 : 1e-6;  // 3 hours and 200 hours of a 20 minute memory
  CHECK(ends[0] == Approx(balance).epsilon(digits));
  CHECK(ends[1] == Approx(balance).epsilon(digits));
}

TEST_CASE("a column under 1e9 W m^-2 either way leaves 2.7 to 2000 K, stays finite, and says so",
          "[hard][heat]") {
  const double load = GENERATE(1e9, -1e9);
  for (const double thickness_m : {1e-6, 0.1}) {
    Run run{{{{{1.0, 1000.0, 1000.0}, thickness_m, 0.0}}, AdiabaticBack{}}, {}, 600.0, 290.0};
    bool told = false;
    for (int i = 0; i < 50; ++i) {
      const StepFlux done = run.advance([&](double, double) { return SurfaceFlux{load, 0.0}; });
      told = told || !done.within_range;
    }
    for (const double k : run.temperature) CHECK(std::isfinite(k));
    CAPTURE(load, thickness_m);
    CHECK(told);
  }
}

TEST_CASE("no wind and no difference of temperature is no film, and a balance all the same",
          "[hard][heat]") {
  for (const double cos_tilt : {1.0, 0.0, -1.0}) {
    const Film still = film(Tarp{}, {0.0, cos_tilt});
    CHECK(still.at(0.0) >= 0.0);
    CHECK(std::isfinite(still.at(0.0)));
    CHECK(std::isfinite(still.at(1700.0)));
    CHECK(still.at(10.0) > 0.0);
    SurfaceLoad load;
    load.film = still;
    load.air_k = 150.0;
    for (const double kelvin : {2.7, 150.0, 2000.0}) {
      for (const double wetness : {0.0, 1.0}) {
        SurfaceProperties surface;
        surface.wetness = wetness;
        const SurfaceFlux flux = BalanceAt{surface, load}(kelvin);
        CAPTURE(cos_tilt, kelvin, wetness);
        CHECK(std::isfinite(flux.w_m2));
        CHECK(std::isfinite(flux.per_k_w_m2_k));
        CHECK(flux.per_k_w_m2_k <= 0.0);
      }
    }
  }
}

TEST_CASE("a surface that takes and gives nothing keeps its temperature, one of 1 radiates",
          "[hard][heat]") {
  SurfaceProperties mirror;
  mirror.solar_absorptance = 0.0;
  mirror.emissivity = 0.0;
  mirror.convection = FixedFilm{0.0};
  SurfaceLoad load;
  load.direct_w_m2 = 1e3;
  load.film = film(mirror.convection, {0.0, 1.0});
  for (const double kelvin : {2.7, 300.0, 2000.0}) {
    CHECK(BalanceAt{mirror, load}(kelvin).w_m2 == 0.0);
    SurfaceProperties black = mirror;
    black.solar_absorptance = black.emissivity = 1.0;
    CHECK(BalanceAt{black, load}(kelvin).w_m2 ==
          Approx(1e3 - si::stefan_boltzmann * std::pow(kelvin, 4)).epsilon(1e-12));
  }
}

TEST_CASE(
    "layers without thickness, conductivity or capacity are refused, and so are infinite ones",
    "[hard][heat]") {
  const double infinite = std::numeric_limits<double>::infinity(), nothing = std::nan("");
  for (const double bad : {0.0, -1.0, infinite, nothing}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(check(LayerStack{{{{bad, 1000.0, 1000.0}, 0.1, 0.0}}, {}}), InputError);
    CHECK_THROWS_AS(check(LayerStack{{{{1.0, bad, 1000.0}, 0.1, 0.0}}, {}}), InputError);
    CHECK_THROWS_AS(check(LayerStack{{{{1.0, 1000.0, bad}, 0.1, 0.0}}, {}}), InputError);
    CHECK_THROWS_AS(check(LayerStack{{{{1.0, 1000.0, 1000.0}, bad, 0.0}}, {}}), InputError);
  }
  CHECK_THROWS_AS(check(LayerStack{}), InputError);
  CHECK_THROWS_AS(check(LayerStack{{{{}, 0.1, 0.0}}, FixedBack{Kelvin{2.0}}}), InputError);
}

TEST_CASE("a whole day without wind whose sun is switched on at noon has a temperature",
          "[hard][heat]") {
  const Day day{13.0};
  HeatModel model = model_of(day);
  model.settings.step_s = GENERATE(60.0, 3600.0);
  model.weather.wind_speed_m_s = {{0.0}, {0.0}};
  auto& direct = model.weather.direct_normal_w_m2;
  for (std::size_t i = 0; i < direct.value.size(); ++i) {
    direct.value[i] = direct.time_s[i] < -3600.0 ? 0.0 : 1500.0;
  }
  const geometry::Scene scene = scene_of({surface(ground(), of_soil)});
  const HeatSolver solver{scene, model};
  const double kelvin = solver.at(from_above(scene, 0.0, 0.0)).value;
  CHECK(kelvin > 290.0);  // warmer than the air: an hour of full sun
  CHECK(kelvin < 400.0);
  CHECK(solver.at(from_above(scene, 0.0, 0.0)).value == kelvin);
}

}  // namespace
}  // namespace nadir::thermal::test
