#include "sim/run/time_rounds.hpp"

#include <cmath>
#include <numeric>

#include "sim/goal_scene.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

using test::goal_of;
using test::plain_world;
using test::rendered;
using Clock = TimeGoal::Clock;

ArrayImage pixels_with_errors(std::vector<float> errors, std::uint32_t paths) {
  ArrayImage image;
  image.samples = static_cast<int>(errors.size());
  image.lines = 1;
  image.paths = paths;
  image.bands.resize(1);
  image.bands[0].radiance.assign(errors.size(), 10.0F);
  image.bands[0].standard_error = std::move(errors);
  return image;
}

/// A clock that goes on by itself each time it is read.
struct SteppedClock {
  Clock::duration step;
  mutable Clock::time_point time{};
  Clock::time_point operator()() const { return time += step; }
};

}  // namespace

TEST_CASE("a pixel is as far from its goal as its worst band", "[sim][time]") {
  ArrayImage image = pixels_with_errors({0.1F, 0.4F, 0.0F}, 32);
  image.bands.push_back(image.bands[0]);
  image.bands[1].standard_error = {0.6F, 0.1F, 0.0F};
  const auto errors = errors_over_goals(image, {{0.01, 0.0}, {0.01, 20.0}});
  CHECK(errors.at(0) == Approx(3.0).epsilon(1e-6));  // floats
  CHECK(errors.at(1) == Approx(4.0).epsilon(1e-6));
  CHECK(errors.at(2) == 0.0);
}

TEST_CASE("a budget of paths brings all pixels to one error", "[sim][time]") {
  const std::vector<double> errors{8.0, 4.0, 2.0, 0.5};
  const ArrayImage image = pixels_with_errors({0.8F, 0.4F, 0.2F, 0.05F}, 160);
  const PathBudget budget{20000.0, 16, 1 << 20, 0.0};
  const auto samples = samples_for_budget(image, errors, budget);
  const double spent = 16.0 * std::accumulate(samples.begin(), samples.end(), 0);
  CHECK(spent <= 20000.0);
  CHECK(spent > 0.99 * 20000.0);
  // Error e after N paths, common error c: N e^2 = (N + 16 n) c^2 for all that got any.
  const auto after = [&](std::size_t i) {
    return errors[i] * std::sqrt(160.0 / (160.0 + 16.0 * samples[i]));
  };
  CHECK(after(1) == Approx(after(0)).epsilon(0.02));  // whole samples
  CHECK(after(2) == Approx(after(0)).epsilon(0.05));
  CHECK(samples[3] == 0);  // it is there already
}

TEST_CASE("a budget stops at the error that is asked for", "[sim][time]") {
  const ArrayImage image = pixels_with_errors({0.4F, 0.1F}, 160);
  const auto samples = samples_for_budget(image, {4.0, 1.0}, {1e9, 16, 1 << 20, 1.0});
  CHECK(samples.at(0) == 150);  // 16 times as many paths as now
  CHECK(samples[1] == 0);
  const auto few = samples_for_budget(image, {4.0, 1.0}, {1e9, 16, 40, 1.0});
  CHECK(few.at(0) == 40);
}

TEST_CASE("rounds go on until the clock says that it is over", "[sim][time]") {
  const support::ScratchFolder folder;
  const World world = plain_world({.samples = 8, .lines = 8}, folder);
  const SamplingGoal goal = goal_of(0.01, 8);  // the clock knows nothing of what a path takes
  TimeGoal time;
  const SteppedClock clock{std::chrono::milliseconds{1}};
  // Each tile and round reads the clock: some hundred readings.
  time.now = [&clock] { return clock(); };
  time.end = Clock::time_point{} + std::chrono::milliseconds{400};
  RenderOptions options;
  options.goal = &goal;
  options.time = &time;
  options.threads = 1;
  const ArrayImage image = rendered(world, options);
  CHECK(clock.time >= time.end - std::chrono::milliseconds{20});   // worth no round
  CHECK(clock.time <= time.end + std::chrono::milliseconds{100});  // no tile is begun after it
  std::uint64_t paths = 0;
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    CHECK(image.paths_of(i) >= 32);
    CHECK(std::isfinite(image.bands[0].standard_error[i]));
    paths += image.paths_of(i);
  }
  CHECK(paths > 32 * image.pixels());
}

TEST_CASE("time that is over leaves every pixel the least samples", "[sim][time]") {
  const support::ScratchFolder folder;
  const World world = plain_world({.samples = 4, .lines = 4}, folder);
  const SamplingGoal goal = goal_of(0.01);
  TimeGoal time;
  time.end = Clock::now() - std::chrono::seconds{1};
  RenderOptions options;
  options.goal = &goal;
  options.time = &time;
  const ArrayImage image = rendered(world, options);
  for (std::size_t i = 0; i < image.pixels(); ++i) CHECK(image.paths_of(i) == 32);
}

TEST_CASE("with time left, sampling stops where it is told to stop at the goal", "[sim][time]") {
  const support::ScratchFolder folder;
  const World world = plain_world({.samples = 4, .lines = 4}, folder);
  const SamplingGoal goal = goal_of(0.05);
  TimeGoal time;
  time.end = Clock::now() + std::chrono::seconds{20};
  time.stop_at_goal = true;
  RenderOptions options;
  options.goal = &goal;
  options.time = &time;
  Diagnostics diagnostics;
  const auto result = render(world.scene, world.camera, options, diagnostics);
  CHECK(result.outcome.arrays.at(0).met == 1.0);
  CHECK(Clock::now() < time.end);
}

}  // namespace nadir::sim
