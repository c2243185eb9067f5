#include "sim/run/sampling_goal.hpp"

#include <algorithm>
#include <cmath>

#include "sim/run/image.hpp"

namespace nadir::sim {
namespace {

// Relative errors are counted in steps of 1 % from 1e-8 to 1e2: what lies outside is counted at the
// ends. 2,303 numbers a band.
constexpr double least_counted = 1e-8, step_of_log = 0.01;
constexpr std::size_t error_bins = 2304;

std::size_t bin_of(double relative) {
  if (!(relative > least_counted)) return 0;
  const double bin = std::log(relative / least_counted) / step_of_log;
  return static_cast<std::size_t>(std::min(bin, static_cast<double>(error_bins - 1)));
}

double relative_error_of(double error, double radiance, const BandGoal& goal) {
  const double scale = std::max(radiance, goal.floor_radiance);
  if (scale > 0.0) return error / scale;
  return error > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

}  // namespace

double student_factor(int replicates) {
  const double nu = replicates - 1.0;
  constexpr double z = 2.0, z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  const double t = z + (z3 + z) / (4.0 * nu) + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * nu * nu) +
                   (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * nu * nu * nu);
  return t / z;
}

double ErrorStatement::add(int samples, double standard_error) noexcept {
  double stated = standard_error;
  if (samples_ > 0) {
    const double carried = former_ * std::sqrt(static_cast<double>(samples_) / samples);
    stated = standard_error < carried ? carried : standard_error;  // NaN stays
  }
  samples_ = samples;
  former_ = standard_error;
  return factor_ * stated;
}

Estimate merged(const PathEstimate& a, const PathEstimate& b) noexcept {
  if (b.paths == 0) return a.value;
  if (a.paths == 0) return b.value;
  const double all = static_cast<double>(a.paths) + b.paths;
  const double share_a = a.paths / all, share_b = b.paths / all;
  return {share_a * a.value.mean + share_b * b.value.mean,
          std::hypot(share_a * a.value.standard_error, share_b * b.value.standard_error)};
}

GoalTally::GoalTally(std::vector<BandGoal> goals) {
  for (const BandGoal& goal : goals) {
    bands_.push_back({goal, 0, 0.0, std::vector<std::uint64_t>(error_bins)});
  }
}

void GoalTally::take(const ArrayImage& strip) {
  for (std::size_t pixel = 0; pixel < strip.pixels(); ++pixel) {
    bool all_met = true;
    for (std::size_t b = 0; b < bands_.size(); ++b) {
      Band& band = bands_[b];
      const double radiance = strip.bands[b].radiance[pixel];
      const double error = strip.bands[b].standard_error[pixel];
      const double relative = relative_error_of(error, radiance, band.goal);
      // The planes' floats round: 1e-6 of the goal is no failure.
      const bool met = error <= band.goal.error_of(radiance) * (1.0 + 1e-6);
      band.met += met ? 1 : 0;
      all_met = all_met && met;
      band.worst = std::fmax(band.worst, relative);
      ++band.histogram[std::isnan(relative) ? error_bins - 1 : bin_of(relative)];
    }
    met_ += all_met ? 1 : 0;
    const std::uint32_t paths = strip.paths_of(pixel);
    least_ = pixels_ == 0 ? paths : std::min(least_, paths);
    most_ = std::max(most_, paths);
    paths_ += paths;
    ++pixels_;
  }
}

ArrayOutcome GoalTally::outcome() const {
  ArrayOutcome result;
  result.pixels = pixels_;
  result.least_paths = least_;
  result.most_paths = most_;
  if (pixels_ == 0) return result;
  const double all = static_cast<double>(pixels_);
  result.met = static_cast<double>(met_) / all;
  result.mean_paths = static_cast<double>(paths_) / all;
  for (const Band& band : bands_) {
    BandOutcome outcome{static_cast<double>(band.met) / all, band.worst, 0.0};
    double below = 0.0;
    std::size_t bin = 0;
    while (bin + 1 < error_bins && below + static_cast<double>(band.histogram[bin]) < 0.95 * all) {
      below += static_cast<double>(band.histogram[bin++]);
    }
    // The upper edge of the bin: no less than the percentile, no more than 1 % above it.
    outcome.p95 =
        bin == 0 ? 0.0 : least_counted * std::exp(static_cast<double>(bin + 1) * step_of_log);
    outcome.p95 = std::min(outcome.p95, band.worst);
    result.bands.push_back(outcome);
  }
  return result;
}

}  // namespace nadir::sim
