#include "sim/run/pilot.hpp"

#include <cmath>
#include <string>

#include "sim/prepared_run.hpp"
#include "sim/run/prediction.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

using radiometry::Effect;
using support::SmallRun;
using support::SmallScenario;

/// Pixels of a metre, 0.3 m of each a strip of white, the rest black: the radiance of a path is 0
/// or L by where in the pixel it goes. The strip lies in one half of the pixel, so that one path in
/// each half (as scrambled points have it) does not see it once every time.
SmallScenario stripes() {
  SmallScenario scenario;
  scenario.materials =
      R"(<material name="black" reflectance="0"/><material name="white" reflectance="0.8"/>)";
  scenario.geometry = R"(<plane material="black" size_x_m="200" size_y_m="200"/>)";
  for (int i = -6; i < 6; ++i) {
    scenario.geometry +=
        "<plane material=\"white\" size_x_m=\"0.3\" size_y_m=\"200\" up_m=\"0.001\"" +
        std::string{" east_m=\""} + std::to_string(i + 0.25) + "\"/>";
  }
  return scenario;
}

Pilot pilot_of(SmallRun& small, int most_pixels = 64) {
  RenderOptions render = render_options(small.run, 1);
  render.threads = 1;
  return run_pilot(small.run.world, render, {most_pixels, 10.0}, small.diagnostics);
}

Prediction predicted(SmallRun& small, const Pilot& pilot, std::optional<double> time_s = {}) {
  return predict({small.run, small.clock.stages(), time_s, 1}, pilot);
}

TEST_CASE("a pilot looks at as many pixels as it may, each once", "[sim][pilot]") {
  SmallRun small{{}};
  CHECK(pilot_of(small, 5).pixels.size() == 5);
  const Pilot pilot = pilot_of(small, 1000);
  CHECK(pilot.pixels.size() <= 64);
  CHECK(pilot.pixels.size() >= 16);
  // 16 to 512 a pixel, as time allows.
  CHECK(pilot.paths >= 16.0 * static_cast<double>(pilot.pixels.size()));
  CHECK(pilot.paths <= 512.0 * static_cast<double>(pilot.pixels.size()));
  CHECK(pilot.counters.primary_rays == static_cast<std::uint64_t>(pilot.paths));
  REQUIRE(pilot.seconds_per_path.size() == 1);
  CHECK(pilot.seconds_per_path[0] > 0.0);
}

TEST_CASE("a pilot leaves no more pixels out than time forbids", "[sim][pilot]") {
  SmallRun small{{}};
  RenderOptions render = render_options(small.run, 1);
  const Pilot pilot = run_pilot(small.run.world, render, {64, 0.0}, small.diagnostics);
  CHECK(pilot.pixels.size() == 16);  // the first few are always looked at
}

TEST_CASE("what has no noise is foretold to have none", "[sim][pilot]") {
  SmallRun small{{}};  // a plane in the sun
  const Prediction p = predicted(small, pilot_of(small));
  REQUIRE(p.bands.size() == 1);
  // The sun's disc is 0.0047 rad wide on either side: at 60 degrees the cosine of one ray varies by
  // 0.0013 or so, that of 8 by less than half of it.
  CHECK(p.bands[0][0].p95_error < 1e-3);
  CHECK(p.bands[0][0].met == 1.0);
  CHECK(p.mean_paths == 8.0);
}

TEST_CASE("foretold errors and times follow the paths", "[sim][pilot]") {
  SmallScenario scenario = stripes();
  scenario.paths = 4;
  SmallRun few{scenario};
  scenario.paths = 64;
  SmallRun many{scenario};
  const Pilot pilot = pilot_of(few);
  const Prediction a = predicted(few, pilot), b = predicted(many, pilot);
  CHECK(b.mean_paths == 16.0 * a.mean_paths);
  // Error ~ 1 / sqrt(N), time ~ N: rounding alone.
  CHECK(a.bands[0][0].median_error == Approx(4.0 * b.bands[0][0].median_error).epsilon(1e-9));
  CHECK(b.render_cpu_s == Approx(16.0 * a.render_cpu_s).epsilon(1e-9));
  CHECK(a.reachable == a.bands[0][0].p95_error);
}

TEST_CASE("paths are foretold that bring every pixel to the accuracy", "[sim][pilot]") {
  SmallRun small{stripes(), 0.05};
  const Pilot pilot = pilot_of(small);
  const Prediction p = predicted(small, pilot);
  REQUIRE(small.run.goal.has_value());
  CHECK(p.bands[0][0].met == 1.0);
  CHECK(p.bands[0][0].p95_error <= 0.05 * (1.0 + 1e-9));
  CHECK(p.mean_paths >= small.run.goal->replicates * small.run.goal->first_samples);
  // Rounds double: no pixel gets more than twice what its error needs. 1e-9: rounding.
  CHECK(p.bands[0][0].median_error >= 0.05 / std::sqrt(2.0) * (1.0 - 1e-9));
}

TEST_CASE("the accuracy foretold for a time costs that time", "[sim][pilot]") {
  SmallRun small{stripes(), 0.01};
  const Pilot pilot = pilot_of(small);
  const Prediction hour = predicted(small, pilot, 3600.0), two = predicted(small, pilot, 7200.0);
  // 1e-3: the stages before stay the same, the scale is found by bisection.
  CHECK(hour.seconds == Approx(3600.0).epsilon(1e-3));
  CHECK(two.seconds == Approx(7200.0).epsilon(1e-3));
  CHECK(hour.reachable / two.reachable == Approx(std::sqrt(2.0)).epsilon(2e-3));
}

TEST_CASE("the seconds of effects add up to no more than the run's", "[sim][pilot]") {
  SmallRun small{stripes()};
  const Pilot pilot = pilot_of(small);
  PredictionBasis basis{small.run, small.clock.stages(), {}, 1};
  const PlanSheet sheet = plan_sheet(basis, {}, &pilot);
  double seconds = 0.0;
  for (const EffectSheet& effect : sheet.effects) {
    CHECK(effect.seconds >= 0.0);
    CHECK(effect.seconds_if_on >= effect.seconds);
    if (effect.state.rfind("off", 0) == 0) CHECK(effect.seconds == 0.0);
    seconds += effect.seconds;
  }
  REQUIRE(sheet.prediction.has_value());
  CHECK(seconds > 0.0);  // rays to the sun
  CHECK(seconds <= sheet.prediction->seconds);
  CHECK(sheet.effects[radiometry::index_of(Effect::solar_reflection)].seconds > 0.0);
}

}  // namespace
}  // namespace nadir::sim
