#include "sim/run/sampling_goal.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "core/normal_pair.hpp"
#include "core/random.hpp"
#include "sim/run/image.hpp"
#include "sim/run/pixel_needs.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

/// A band of pixels with these radiances and errors.
ArrayImage goal_image(std::vector<float> radiance, std::vector<float> error,
                      std::vector<std::uint32_t> paths) {
  ArrayImage image;
  image.samples = static_cast<int>(radiance.size());
  image.lines = 1;
  image.bands.resize(1);
  image.bands[0].radiance = std::move(radiance);
  image.bands[0].standard_error = std::move(error);
  image.pixel_paths = std::move(paths);
  return image;
}

}  // namespace

TEST_CASE("errors from few replicates are made larger by Student's law", "[sim][goal]") {
  // Quantiles of Student's law at 0.97725 over 2, from scipy.stats.t.ppf; the series is good to 1 %
  // at three degrees of freedom, better beyond.
  CHECK(student_factor(4) == Approx(1.6534).epsilon(0.01));
  CHECK(student_factor(8) == Approx(1.2144).epsilon(1e-3));
  CHECK(student_factor(16) == Approx(1.0906).epsilon(2e-4));
  CHECK(student_factor(1000) == Approx(1.0).epsilon(2e-3));
}

TEST_CASE("the first error is stated as it is, later ones not below what the former foretold",
          "[sim][goal]") {
  ErrorStatement statement{16};
  const double f = student_factor(16);
  statement.begin_pixel();
  CHECK(statement.add(2, 1.0) == Approx(f).epsilon(1e-15));
  // Four times the samples would halve 1.0; an estimate of 0.1 is luck.
  CHECK(statement.add(8, 0.1) == Approx(0.5 * f).epsilon(1e-15));
  CHECK(statement.add(16, 0.3) == Approx(0.3 * f).epsilon(1e-15));
  statement.begin_pixel();
  CHECK(statement.add(4, 0.1) == Approx(0.1 * f).epsilon(1e-15));
  CHECK(std::isnan(statement.add(8, std::numeric_limits<double>::quiet_NaN())));
}

TEST_CASE("twice the stated error holds the truth of a normal pixel in 95 of 100 cases",
          "[sim][goal]") {
  // Pixels of variance 1 a path that stop as soon as the stated error is below a goal. 4000 of
  // them: the standard deviation of the share is 0.35 %.
  Rng rng{5};
  constexpr int pixels = 4000, replicates = 16;
  constexpr double goal = 0.05;
  const double normal_law = 0.9545;
  int inside = 0;
  for (int pixel = 0; pixel < pixels; ++pixel) {
    ErrorStatement statement{replicates};
    std::vector<double> sums(replicates);
    double stated = 1.0, mean = 0.0;
    for (int done = 0, next = 1; done < 4096 && (done < 2 || stated > goal); next *= 2) {
      Welford spread;
      for (double& sum : sums) {
        // The sum of the next paths at once.
        sum += std::sqrt(next - done) * normal_pair({rng.next(), rng.next()}).x;
        spread.add(sum / next);
      }
      done = next;
      stated = statement.add(done, spread.estimate().standard_error);
      mean = spread.mean();
    }
    inside += std::abs(mean) <= 2.0 * stated ? 1 : 0;
  }
  const double share = static_cast<double>(inside) / pixels;
  CHECK(share > 0.95);
  CHECK(share < normal_law + 0.035);  // nor is it so careful that it says nothing
}

TEST_CASE("two estimates merge by their paths, and what has none counts nothing", "[sim][goal]") {
  const PathEstimate a{{10.0, 0.3}, 100}, b{{16.0, 0.4}, 50};
  CHECK(merged(a, b).mean == Approx(12.0).epsilon(1e-15));
  CHECK(merged(a, b).standard_error == Approx(std::sqrt(4.0 * 0.09 + 0.16) / 3.0).epsilon(1e-15));
  const PathEstimate none{{std::numeric_limits<double>::quiet_NaN(), 0.0}, 0};
  CHECK(merged(a, none).mean == 10.0);
  CHECK(merged(none, b).mean == 16.0);
}

TEST_CASE("an outcome counts pixels that meet their goal", "[sim][goal]") {
  GoalTally tally{{{0.01, 5.0}}};
  // Goals: 1 % of 10, of the floor 5, of 100, of 100.
  tally.take(goal_image({10.0F, 1.0F}, {0.1F, 0.06F}, {32, 64}));
  tally.take(goal_image({100.0F, 100.0F}, {0.5F, 0.0F}, {32, 320}));
  const ArrayOutcome outcome = tally.outcome();
  CHECK(outcome.pixels == 4);
  CHECK(outcome.met == 0.75);
  CHECK(outcome.bands.at(0).met == 0.75);
  CHECK(outcome.bands[0].worst == Approx(0.012).epsilon(1e-6));
  CHECK(outcome.bands[0].p95 == Approx(0.012).epsilon(0.011));  // its bins are 1 % wide
  CHECK(outcome.least_paths == 32);
  CHECK(outcome.most_paths == 320);
  CHECK(outcome.mean_paths == 112.0);
}

TEST_CASE("a pixel without numbers never meets its goal", "[sim][goal]") {
  GoalTally tally{{{0.01, 0.0}}};
  const float none = std::numeric_limits<float>::quiet_NaN();
  tally.take(goal_image({none, 0.0F, 0.0F}, {none, 0.0F, 0.1F}, {32, 32, 32}));
  const ArrayOutcome outcome = tally.outcome();
  CHECK(outcome.met == Approx(1.0 / 3.0).epsilon(1e-15));  // black and certain
  CHECK(std::isinf(outcome.bands.at(0).worst));
}

TEST_CASE("what a pixel needs falls with the square of its error", "[sim][goal]") {
  const std::vector<BandGoal> goals{{0.01, 0.0}};
  ArrayImage image = goal_image({10.0F, 10.0F, 0.0F}, {0.2F, 0.05F, 0.0F}, {100, 100, 100});
  CHECK(paths_needed(image, 0, goals) == Approx(400.0).epsilon(1e-6));  // floats
  CHECK(paths_needed(image, 1, goals) == Approx(25.0).epsilon(1e-6));
  CHECK(paths_needed(image, 2, goals) == 0.0);
  CHECK(mean_need(image, goals, 1e6) == Approx(425.0 / 3.0).epsilon(1e-6));
  CHECK(mean_need(image, goals, 200.0) == Approx(225.0 / 3.0).epsilon(1e-6));
  // One that needs 81 of its 100 paths has an error of 0.9 of the goal.
  state_need(image, 1, goals, {81.0, {}});
  CHECK(image.bands[0].standard_error[1] == Approx(0.09).epsilon(1e-6));
  state_need(image, 0, goals, {81.0, {}});
  CHECK(image.bands[0].standard_error[0] == 0.2F);  // its own is larger
}

TEST_CASE("a pixel whose replicates happen to agree is judged by its block", "[sim][goal]") {
  const std::vector<BandGoal> goals{{0.01, 0.0}};
  // Needs 400, 400, 4 and none sampled: half of the mean of three is 134.
  ArrayImage image =
      goal_image({10.0F, 10.0F, 10.0F, 0.0F}, {0.2F, 0.2F, 0.02F, 0.0F}, {100, 100, 100, 0});
  state_needs_of_blocks(image, goals, {});
  CHECK(image.bands[0].standard_error[0] == 0.2F);
  CHECK(image.bands[0].standard_error[2] == Approx(0.1 * std::sqrt(1.34)).epsilon(1e-6));
  CHECK(image.bands[0].standard_error[3] == 0.0F);
}

}  // namespace nadir::sim
