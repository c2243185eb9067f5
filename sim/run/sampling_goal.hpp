#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/statistics.hpp"

namespace nadir::sim {

/// When a band of a pixel has been sampled enough: its standard error is at most `error_of`.
struct BandGoal {
  double relative = 0.01;
  double floor_radiance = 0.0;  ///< W m^-2 sr^-1 um^-1: darker pixels need no smaller error
  [[nodiscard]] double error_of(double radiance) const noexcept {
    return relative * (radiance > floor_radiance ? radiance : floor_radiance);
  }
};

/// Sampling until a stated accuracy: every pixel is sampled in rounds, each of which doubles its
/// paths, until every band meets its goal. docs/accuracy-and-time.md has the rule and what it was
/// measured to hold.
struct SamplingGoal {
  std::vector<std::vector<BandGoal>> bands;  ///< by array and band
  /// Independent scramblings: 16 leave 15 degrees of freedom, so that two standard errors hold the
  /// truth in 93.6 % of pixels (Student) where four would in 86 %.
  int replicates = 16;
  int first_samples = 2;  ///< a replicate: no pixel gets fewer, so that dark ones are not given up
  int most_samples = 16384;  ///< a replicate: what is not done then is reported as such
};

/// Sampling until a moment. The goal beside it says what errors are worth: time goes where the
/// error relative to the goal is largest.
struct TimeGoal {
  using Clock = std::chrono::steady_clock;
  Clock::time_point end;                        ///< when the last strip is to be done
  bool stop_at_goal = false;                    ///< sooner, where all pixels meet the goal
  std::function<Clock::time_point()> now = {};  ///< null: the steady clock
};

/// The factor by which a standard error from so many replicates is made larger, so that twice of it
/// holds the truth as often as two standard deviations of a normal law do, in 95.45 % of cases.
///
///     t_nu / 2  with  t_nu = z + (z^3 + z) / 4 nu + (5 z^5 + 16 z^3 + 3 z) / 96 nu^2
///                          + (3 z^7 + 19 z^5 + 17 z^3 - 15 z) / 384 nu^3,   z = 2
///
/// Student's quantile for nu = replicates - 1. Source: Abramowitz and Stegun, 26.7.5.
/// Accuracy: 1 % for nu = 3, 1e-4 for nu = 15.
[[nodiscard]] double student_factor(int replicates);

/// The error that is stated of a band of a pixel while its samples grow:
///
///     s_k = f max(e_k, e_{k-1} sqrt(n_{k-1} / n_k)),
///
/// e_k the standard error of the replicates' means after n_k samples each, f as above. An estimate
/// from 16 replicates is itself 18 % uncertain, and sampling that ends as soon as it looks small
/// ends by luck; the former round's, carried on, must agree that it is.
class ErrorStatement {
 public:
  explicit ErrorStatement(int replicates) : factor_{student_factor(replicates)} {}
  void begin_pixel() noexcept { samples_ = 0; }
  /// @return  the error to be stated
  double add(int samples, double standard_error) noexcept;

 private:
  double factor_;
  int samples_ = 0;
  double former_ = 0.0;
};

/// Two independent estimates of one thing: their mean, weighted by the paths of each, and its
/// standard error.
struct PathEstimate {
  Estimate value;
  std::uint32_t paths = 0;
};
[[nodiscard]] Estimate merged(const PathEstimate& a, const PathEstimate& b) noexcept;

/// How a band of an array came out against its goal.
struct BandOutcome {
  double met = 0.0;               ///< share of pixels whose standard error meets the goal
  double worst = 0.0, p95 = 0.0;  ///< standard error / max(radiance, floor)
};
struct ArrayOutcome {
  std::vector<BandOutcome> bands;
  double met = 0.0;  ///< share of pixels that meet the goals of all bands
  std::uint64_t pixels = 0;
  std::uint32_t least_paths = 0, most_paths = 0;  ///< a pixel
  double mean_paths = 0.0;
};
/// By array; empty without a goal.
struct GoalOutcome {
  std::vector<ArrayOutcome> arrays;
};

struct ArrayImage;

/// Counts how the pixels of an array came out, strip by strip.
class GoalTally {
 public:
  explicit GoalTally(std::vector<BandGoal> goals);
  /// @param strip  its errors as they are stated
  void take(const ArrayImage& strip);
  [[nodiscard]] ArrayOutcome outcome() const;

 private:
  struct Band {
    BandGoal goal;
    std::uint64_t met = 0;
    double worst = 0.0;
    std::vector<std::uint64_t> histogram;  // of the relative errors' logarithm
  };
  std::vector<Band> bands_;
  std::uint64_t pixels_ = 0, met_ = 0, paths_ = 0;
  std::uint32_t least_ = 0, most_ = 0;
};

}  // namespace nadir::sim
