#include "sim/run/time_rounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "sim/run/merge_images.hpp"
#include "sim/run/pixel_needs.hpp"

namespace nadir::sim {
namespace {

using Seconds = std::chrono::duration<double>;

// Of the time left a round takes so much: errors and costs are known better after it. The last one
// leaves a little for what its tiles take longer than foretold.
constexpr double share_of_round = 0.6, share_of_last = 0.96;
// Less than this share of the strip's time left is not worth a round.
constexpr double worth_a_round = 0.02, worth_two_rounds = 0.15;

double needed_paths(double paths, double error, double common) {
  return paths * (error / common) * (error / common);
}

int samples_needed(double paths, double error, double common, const PathBudget& budget) {
  if (!(error > common)) return 0;
  const double more = (needed_paths(paths, error, common) - paths) / budget.replicates;
  // Half a sample or less is none: rounding up would spend a round on pixels that are done.
  return static_cast<int>(std::min(std::round(more), static_cast<double>(budget.most)));
}

double paths_in_all(const ArrayImage& image, const std::vector<double>& errors, double common,
                    const PathBudget& budget) {
  double paths = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    paths += budget.replicates *
             static_cast<double>(samples_needed(image.paths_of(i), errors[i], common, budget));
  }
  return paths;
}

/// A strip's clock: what is left, and what a path costs of it.
class StripTime {
 public:
  StripTime(const TimeGoal& goal, TimeGoal::Clock::time_point end)
      : goal_{&goal}, start_{now()}, end_{end} {}
  [[nodiscard]] TimeGoal::Clock::time_point now() const {
    return goal_->now ? goal_->now() : TimeGoal::Clock::now();
  }
  [[nodiscard]] double left_s() const { return Seconds{end_ - now()}.count(); }
  [[nodiscard]] double all_s() const { return Seconds{end_ - start_}.count(); }
  [[nodiscard]] bool over() const { return now() >= end_; }

 private:
  const TimeGoal* goal_;
  TimeGoal::Clock::time_point start_, end_;
};

/// What a path takes, from the latest round that sampled enough of them: short rounds cost more a
/// path than long ones.
class PathCost {
 public:
  void add(std::uint64_t paths, double seconds) {
    if (paths > 0 && seconds > 0.0) seconds_a_path_ = seconds / static_cast<double>(paths);
  }
  [[nodiscard]] bool known() const { return seconds_a_path_ > 0.0; }
  [[nodiscard]] double paths_in(double seconds) const { return seconds / seconds_a_path_; }

 private:
  double seconds_a_path_ = 0.0;
};

/// Renders a strip's rounds and keeps account of time and paths.
class RoundsInTime {
 public:
  RoundsInTime(StripRenderer& strip, const StripTime& time) : strip_{&strip}, time_{&time} {}

  [[nodiscard]] ArrayImage render(const RoundOrder& order) {
    const double left_s = time_->left_s();
    const std::uint64_t before = strip_->computed_paths();
    ArrayImage image = strip_->render_round(order);
    cost_.add(strip_->computed_paths() - before, left_s - time_->left_s());
    return image;
  }
  [[nodiscard]] const PathCost& cost() const { return cost_; }

 private:
  StripRenderer* strip_;
  const StripTime* time_;
  PathCost cost_;
};

/// Merges the rounds that a former run left in the store: those that are said to be there, and what
/// follows of one that was cut off. @return  the number of the first round without any sample
std::uint32_t take_kept(RoundsInTime& rounds, const ArrayJob& job, const RenderOptions& options,
                        ArrayImage& image) {
  if (options.store == nullptr) return 1;
  for (std::uint32_t round = 1;; ++round) {
    const ArrayImage kept = rounds.render({round, &image, {}, true, {}});
    const bool any = paths_in(kept) > 0;
    if (!any && round >= options.rounds.kept) return round;
    if (any) merge(image, kept, job.plan.quadratures);
  }
}

/// No pixel may hold up the end: of the paths that the strip's time is good for, on one thread, a
/// pixel gets at most a hundredth in a round.
int most_samples(const RenderOptions& options, double paths_of_strip) {
  const int threads = options.threads > 0 ? options.threads : available_threads();
  const double most = 0.01 * paths_of_strip / threads / options.goal->replicates;
  return static_cast<int>(std::clamp(most, 1.0, static_cast<double>(options.goal->most_samples)));
}

void tell_progress(const RenderOptions& options, const StripTime& time) {
  if (!options.progress) return;
  constexpr double steps = 1000.0;
  const double done = std::clamp(1.0 - time.left_s() / std::max(time.all_s(), 1e-9), 0.0, 1.0);
  options.progress(static_cast<std::size_t>(steps * done), static_cast<std::size_t>(steps));
}

}  // namespace

std::vector<double> errors_over_goals(const ArrayImage& image, const std::vector<BandGoal>& goals) {
  std::vector<double> errors(image.pixels(), 0.0);
  for (std::size_t b = 0; b < goals.size(); ++b) {
    const BandImage& band = image.bands[b];
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const double goal = goals[b].error_of(band.radiance[i]);
      const double error = static_cast<double>(band.standard_error[i]) / goal;
      if (std::isfinite(error)) errors[i] = std::max(errors[i], error);
    }
  }
  return errors;
}

std::vector<int> samples_for_budget(const ArrayImage& image, const std::vector<double>& errors,
                                    const PathBudget& budget) {
  double low = 1e-6, high = 1.0;  // of the common error, on the safe side of both
  for (const double error : errors) high = std::max(high, error);
  low = std::min(low, high);
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(low * high);
    (paths_in_all(image, errors, middle, budget) > budget.paths ? low : high) = middle;
  }
  const double common = std::max(high, budget.least_error);
  std::vector<int> samples;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    samples.push_back(samples_needed(image.paths_of(i), errors[i], common, budget));
  }
  return samples;
}

ArrayImage render_until(StripRenderer& strip, const ArrayJob& job, const RenderOptions& options,
                        TimeGoal::Clock::time_point end, std::uint32_t& rounds) {
  const SamplingGoal& goal = *options.goal;
  const StripTime time{*options.time, end};
  RoundsInTime in_time{strip, time};
  RoundOrder first;
  first.samples.assign(strip.pixels(), goal.first_samples);
  ArrayImage image = in_time.render(first);
  std::uint32_t round = take_kept(in_time, job, options, image);
  const auto& goals = goal.bands[job.number];
  state_needs_of_blocks(image, goals, job.plan.quadratures);
  for (;; ++round) {
    tell_progress(options, time);
    const double left_s = time.left_s();
    if (left_s < worth_a_round * time.all_s()) break;
    RoundOrder order{round, &image, {}, false, [&time] { return time.over(); }};
    if (in_time.cost().known()) {
      const bool last = left_s < worth_two_rounds * time.all_s();
      const PathBudget budget{
          in_time.cost().paths_in((last ? share_of_last : share_of_round) * left_s),
          goal.replicates, most_samples(options, in_time.cost().paths_in(time.all_s())),
          options.time->stop_at_goal ? 0.98 : 0.0};
      order.samples = samples_for_budget(image, errors_over_goals(image, goals), budget);
    } else {
      order.samples.assign(strip.pixels(), 1);  // all was found: what a path costs is not known yet
    }
    if (std::accumulate(order.samples.begin(), order.samples.end(), 0LL) == 0) break;
    const ArrayImage more = in_time.render(order);
    if (paths_in(more) == 0) break;
    merge(image, more, job.plan.quadratures);
  }
  rounds = std::max(rounds, round);
  state_needs_of_blocks(image, goals, job.plan.quadratures);
  state_bias(image, job.number, options);
  return image;
}

}  // namespace nadir::sim
