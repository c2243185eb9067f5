#include "thermal/solve/time_grid.hpp"

#include <algorithm>
#include <cmath>

namespace nadir::thermal {
namespace {

// A hair's breadth: a day over 600 s must not become 145 steps by rounding.
constexpr double whole_slack = 1e-9;

std::size_t rounded_up(double ratio) {
  return static_cast<std::size_t>(std::ceil(ratio * (1.0 - whole_slack)));
}

/// The largest divisor of the day's steps that makes no more than an hour.
std::size_t in_long_step(const TimeGrid& grid) {
  constexpr double most_s = 3600.0 * (1.0 + whole_slack);
  const auto most = std::max<std::size_t>(1, static_cast<std::size_t>(most_s / grid.step_s));
  for (std::size_t steps = most; steps > 1; --steps) {
    if (grid.day_steps % steps == 0) return steps;
  }
  return 1;
}

}  // namespace

double TimeGrid::stage_s(std::size_t stage) const noexcept {
  const double within = (stage & 1U) != 0 ? 1.0 : Column::gamma;
  const std::size_t step = stage / 2;
  return (static_cast<double>(step) + within - static_cast<double>(steps)) * step_s;
}

TimeGrid make_time_grid(const HeatSettings& settings) {
  TimeGrid grid;
  grid.day_steps = std::max<std::size_t>(1, rounded_up(seconds_per_day / settings.step_s));
  grid.step_s = seconds_per_day / static_cast<double>(grid.day_steps);
  grid.steps = std::max(grid.day_steps, rounded_up(settings.history_s / grid.step_s));
  grid.in_long_step = in_long_step(grid);
  return grid;
}

Between EvenMoments::find(double time_s) const noexcept {
  if (time_s < first_s) {
    time_s += seconds_per_day * std::ceil((first_s - time_s) / seconds_per_day);
  }
  const double place = std::max(0.0, (time_s - first_s) / interval_s);
  const double whole = std::floor(place);
  if (whole + 1.0 >= static_cast<double>(count)) {
    // The last one, told as the end of the last interval so that both entries exist.
    if (count < 2) return {0, 0.0F};
    return {static_cast<std::uint32_t>(count - 2), 1.0F};
  }
  return {static_cast<std::uint32_t>(whole), static_cast<float>(place - whole)};
}

EvenMoments moments_of(const SunTrack& track) {
  const std::size_t count = track.time_s.size();
  return {track.time_s.front(), -track.time_s.front() / static_cast<double>(count - 1), count};
}

EvenMoments patch_moments(const SunTrack& track, double interval_s) {
  const double first_s = track.time_s.front();
  const auto count = static_cast<std::size_t>(std::floor(-first_s / interval_s + whole_slack)) + 1;
  return {first_s, interval_s, count};
}

}  // namespace nadir::thermal
