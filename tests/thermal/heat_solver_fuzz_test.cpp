// Whatever the weather: temperatures stay between those of space and of molten rock.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/random.hpp"
#include "support/catch.hpp"
#include "thermal/heat_scene.hpp"
#include "thermal/solve/heat_solver.hpp"

namespace nadir::thermal {
namespace {

using namespace test;

/// Random figures between what check() lets pass.
struct Fuzz {
  Rng rng;

  double between(double least, double most) { return least + rng.next() * (most - least); }
  double over_decades(double least, double most) {
    return least * std::pow(most / least, rng.next());
  }
  bool once_in(int n) { return rng.next() * n < 1.0; }

  /// Hour by hour, anything: neighbours know nothing of each other.
  TimeSeries series(double least, double most) {
    TimeSeries result;
    for (int hour = -24; hour <= 0; ++hour) {
      result.time_s.push_back(3600.0 * hour);
      result.value.push_back(once_in(5) ? (once_in(2) ? least : most) : between(least, most));
    }
    return result;
  }
  Weather weather() {
    Weather weather;
    weather.air_temperature_k = series(150.0, 350.0);
    weather.vapour_pressure_hpa = series(0.0, 400.0);
    weather.pressure_hpa = series(200.0, 1200.0);
    weather.wind_speed_m_s = series(0.0, 120.0);
    weather.direct_normal_w_m2 = series(0.0, 1500.0);
    weather.diffuse_horizontal_w_m2 = series(0.0, 1000.0);
    weather.sky_long_wave_w_m2 = series(1.0, 800.0);
    return weather;
  }
  LayerStack layers() {
    LayerStack stack;
    const int count = 1 + static_cast<int>(between(0.0, 3.0));
    for (int i = 0; i < count; ++i) {
      stack.layers.push_back(
          {{over_decades(0.02, 400.0), over_decades(20.0, 10000.0), over_decades(300.0, 4200.0)},
           over_decades(1e-4, 0.5),
           once_in(4) ? between(0.0, 300.0) : 0.0});
    }
    const double kind = rng.next();
    if (kind < 0.2) stack.back = FixedBack{Kelvin{between(150.0, 400.0)}};
    if (kind > 0.8) stack.back = RoomBack{{}, between(-20.0, 20.0), over_decades(0.5, 30.0)};
    if (kind > 0.4 && kind < 0.6) {  // a bare sheet of metal, from 0.1 mm
      stack = {{{{50.0, 2700.0, 900.0}, over_decades(1e-4, 5e-3), 0.0}}, OpenBack{}};
    }
    return stack;
  }
  SurfaceProperties surface() {
    SurfaceProperties surface;
    surface.solar_absorptance = once_in(4) ? 1.0 : rng.next();
    surface.emissivity = once_in(6) ? 0.0 : rng.next();
    const double law = rng.next();
    if (law < 0.5) surface.convection = McAdams{};
    if (law < 0.3) surface.convection = SimpleByRoughness{Roughness::very_smooth};
    if (law < 0.2) surface.convection = FixedFilm{between(0.0, 200.0)};
    if (law < 0.1 && surface.emissivity > 0.0) surface.convection = FixedFilm{0.0};
    surface.wind_factor = once_in(4) ? 0.0 : between(0.0, 2.0);
    surface.wetness = once_in(2) ? 0.0 : rng.next();
    return surface;
  }
  HeatModel model() {
    const Day day{between(0.0, 24.0), between(-23.0, 23.0), between(-80.0, 80.0)};
    HeatModel model = model_of(day);
    model.weather = weather();
    // An hour for a sheet of 0.1 mm, now and then a minute
    model.settings.step_s = once_in(20) ? over_decades(60.0, 600.0) : over_decades(600.0, 3600.0);
    model.settings.spin_up_days = 5;
    model.settings.exposure.sky_rays = 8;
    model.settings.exposure.surroundings = 1;
    model.materials = {HeatMaterial{layers(), surface()}, std::nullopt, std::nullopt};
    model.surroundings[of_soil] = {rng.next(), rng.next(), OfItsHeatBalance{}};
    model.surroundings[of_sheet].temperature = FollowsAir{};
    model.surroundings[of_wall] = {rng.next(), rng.next(), Kelvin{between(0.0, 500.0)}};
    return model;
  }
};

struct Extremes {
  double coldest = std::numeric_limits<double>::infinity(), hottest = 0.0;
  bool finite = true;
};

void run_fuzz(int runs, std::uint64_t seed, Extremes& seen) {
  const auto scene = scene_of(
      {surface(ground(10.0), of_soil), surface({{0, -5, 0}, {0, 10, 0}, {0, 0, 3}}, of_wall)});
  const auto hit = from_above(scene, 1.1, 0.3);
  for (int i = 0; i < runs; ++i) {
    Fuzz fuzz{Rng{seed, static_cast<std::uint64_t>(i)}};
    const HeatSolver solver{scene, fuzz.model()};
    const HeatRecord record = solver.record(hit);
    for (const auto& row : record.rows) {
      seen.finite = seen.finite && std::isfinite(row.surface_k) && std::isfinite(row.back_k) &&
                    std::isfinite(row.terms.sum());
      seen.coldest = std::min({seen.coldest, row.surface_k, row.back_k});
      seen.hottest = std::max({seen.hottest, row.surface_k, row.back_k});
    }
  }
}

void check_range(const Extremes& seen) {
  CAPTURE(seen.coldest, seen.hottest);
  CHECK(seen.finite);
  CHECK(seen.coldest >= 2.7);
  CHECK(seen.hottest <= 2000.0);
  CHECK(seen.hottest > seen.coldest + 100.0);  // the fuzz is a rough one
}

TEST_CASE("no weather takes temperatures out of 2.7 to 2000 K", "[thermal][heat_solver]") {
  Extremes seen;
  run_fuzz(100, 1, seen);
  check_range(seen);
}

TEST_CASE("ten thousand weathers do not either", "[.long][thermal][heat_solver]") {
  Extremes seen;
  run_fuzz(10'000, 2, seen);
  WARN("from " << seen.coldest << " to " << seen.hottest << " K");
  check_range(seen);
}

}  // namespace
}  // namespace nadir::thermal
