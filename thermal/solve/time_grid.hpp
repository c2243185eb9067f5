#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "thermal/solve/heat_model.hpp"

// Private to this folder.

namespace nadir::thermal {

inline constexpr double seconds_per_day = 86400.0;

/// The steps of the record, which end at the picture. Each step has two stages, at the share
/// Column::gamma of it and at its end: stage 2 n + k of step n.
struct TimeGrid {
  double step_s = 600.0;
  std::size_t day_steps = 144;  ///< of the record's first day, which the spin-up repeats
  std::size_t steps = 144;
  /// Of which one long step of that day is made, an hour at most: 1 where none fits.
  std::size_t in_long_step = 6;

  [[nodiscard]] std::size_t long_steps() const noexcept { return day_steps / in_long_step; }
  [[nodiscard]] std::size_t stages() const noexcept { return 2 * steps; }
  [[nodiscard]] double stage_s(std::size_t stage) const noexcept;
};
/// The longest step up to the wanted one of which a day is a whole number.
[[nodiscard]] TimeGrid make_time_grid(const HeatSettings& settings);

/// A place between two entries of an evenly spaced series: linear between `index` and the next.
struct Between {
  std::uint32_t index = 0;
  float share = 0.0F;
};

/// Moments t_i = first + i interval, i < count.
struct EvenMoments {
  double first_s = 0.0, interval_s = 1.0;
  std::size_t count = 1;

  /// Times before the first are looked up whole days later; those outside get the nearest moment.
  [[nodiscard]] Between find(double time_s) const noexcept;
  [[nodiscard]] double at(std::size_t i) const noexcept {
    return first_s + static_cast<double>(i) * interval_s;
  }
};
[[nodiscard]] EvenMoments moments_of(const SunTrack& track);
/// Those at which SurroundingPatch::sun_cosine stands.
[[nodiscard]] EvenMoments patch_moments(const SunTrack& track, double interval_s);

/// The series at a place, which may be shorter than expected (0 if empty).
template <class Series>
[[nodiscard]] double interpolated(const Series& series, Between place) noexcept {
  if (place.index + 1 < series.size()) {
    const double below = series[place.index], above = series[place.index + 1];
    return below + static_cast<double>(place.share) * (above - below);
  }
  return series.empty() ? 0.0 : static_cast<double>(series.back());
}

}  // namespace nadir::thermal
