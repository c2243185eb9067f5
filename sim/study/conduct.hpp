#pragma once

#include <functional>
#include <string>

#include "sim/study/analyse.hpp"
#include "sim/study/journal.hpp"

namespace nadir::sim {

/// Shares of the time that is left once the scene is loaded.
inline constexpr double reference_share = 0.35;
inline constexpr double rows_share = 0.43;
inline constexpr double confirmation_share = 0.07;
inline constexpr double pictures_share = 0.11;  // the rest is for pages and misjudged costs

/// When the stages of a study end, in seconds since it began.
struct StudySchedule {
  double reference_s = 0.0, rows_s = 0.0, confirmations_s = 0.0, pictures_s = 0.0;
};
/// @param loaded_s  when the scene was ready to be rendered
[[nodiscard]] StudySchedule schedule_of(double loaded_s, double budget_s);

/// How many pixels a study affords, and how it samples the reference.
struct PixelPlan {
  int pixels = 64;
  int reference_samples = 1;  ///< paths of a replicate in each round
};
/// @param path_s  seconds (of the clock) that a path takes
/// @param wanted  by the user; 0: as the time allows
[[nodiscard]] PixelPlan plan_pixels(double path_s, double reference_s, int wanted,
                                    std::uint64_t image_pixels);

/// Measures reference, rows and confirmations into the journal, until all is done or the schedule's
/// times have come. What the journal holds already is not measured again. Needs a header with
/// pixels.
struct StudyConduct {
  Prober probe;
  StudyTime time;
  StudySchedule schedule;
  /// Seconds before a first path can be traced, beyond what every row needs: an air to be solved.
  std::function<double(const StudySettings&)> preparation_s = [](const StudySettings&) {
    return 0.0;
  };
  std::function<void(const std::string&)> tell = [](const std::string&) {};

  void run(StudyJournal& journal) const;

 private:
  void measure_reference(StudyJournal& journal) const;
  void measure_rows(StudyJournal& journal) const;
  /// More paths for what would be recommended, in the time that rows have left.
  void extend_rows(StudyJournal& journal) const;
  void measure_row(const StudyPoint& point, double until_s, StudyJournal& journal) const;
  void measure_levels(const StudyPoint& point, double until_s, StudyJournal& journal) const;
  void confirm(StudyJournal& journal) const;
};

/// The seed of a level: alike for all rows, so that they can be compared path by path.
[[nodiscard]] std::uint64_t level_seed(std::uint64_t seed, int samples);

}  // namespace nadir::sim
