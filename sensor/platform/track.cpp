#include "sensor/platform/track.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::sensor {
namespace {

constexpr int most_points = 8;

void check_track(const std::vector<double>& times_s, const std::vector<Vec3>& positions,
                 int points) {
  if (points < 2 || points > most_points) {
    throw InputError{"a track is interpolated through 2 to 8 points, not " +
                     std::to_string(points)};
  }
  if (times_s.size() != positions.size()) {
    throw InputError{"a track has " + std::to_string(times_s.size()) + " times but " +
                     std::to_string(positions.size()) + " positions"};
  }
  if (times_s.size() < 2) throw InputError{"a track needs at least two times"};
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    if (!std::isfinite(times_s[i]) || !is_finite(positions[i])) {
      throw InputError{"entry " + std::to_string(i + 1) + " of the track is not finite"};
    }
    if (i > 0 && !(times_s[i] > times_s[i - 1])) {
      throw InputError{"the times of a track must ascend: " + number_text(times_s[i]) +
                       " s follows " + number_text(times_s[i - 1]) + " s"};
    }
  }
}

}  // namespace

/// The points that a moment's polynomial goes through, and the moment's distance from each.
struct Track::Window {
  const Vec3* positions;
  const double* weights;
  std::array<double, most_points> away;  // in steps where they are even, else s
};

Track::Track(Vec3 position) : times_s_{0.0}, positions_{position}, points_{1} {}

Track::Track(std::vector<double> times_s, std::vector<Vec3> positions, int points)
    : times_s_{std::move(times_s)}, positions_{std::move(positions)}, points_{points} {
  check_track(times_s_, positions_, points);
  points_ = std::min(points, static_cast<int>(times_s_.size()));
  find_step();
  prepare_weights();
}

void Track::find_step() {
  const double first = times_s_.front(), last = times_s_.back();
  const double step = (last - first) / static_cast<double>(times_s_.size() - 1);
  // Rounding of the times alone: 1e-13 s at 100 s, a nanometre of an orbit.
  const double rounding =
      4.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(first), std::abs(last));
  for (std::size_t i = 0; i < times_s_.size(); ++i) {
    if (std::abs(times_s_[i] - (first + step * static_cast<double>(i))) > rounding) return;
  }
  step_s_ = step;
}

void Track::prepare_weights() {
  const auto count = static_cast<std::size_t>(points_);
  const std::size_t windows = step_s_ > 0.0 ? 1 : times_s_.size() - count + 1;
  for (std::size_t w = 0; w < windows; ++w) {
    for (std::size_t j = 0; j < count; ++j) {
      double product = 1.0;
      for (std::size_t i = 0; i < count; ++i) {
        if (i == j) continue;
        product *= step_s_ > 0.0 ? static_cast<double>(j) - static_cast<double>(i)
                                 : times_s_[w + j] - times_s_[w + i];
      }
      weights_.push_back(1.0 / product);
    }
  }
}

double Track::first_s() const noexcept {
  return is_fixed() ? -std::numeric_limits<double>::infinity() : times_s_.front();
}

double Track::last_s() const noexcept {
  return is_fixed() ? std::numeric_limits<double>::infinity() : times_s_.back();
}

/// Number of the interval [t_i, t_i+1) that holds a moment; the outermost for those beyond.
std::size_t Track::interval(double time_s) const noexcept {
  const std::size_t last = times_s_.size() - 2;
  if (step_s_ > 0.0) {
    const double steps = (time_s - times_s_.front()) / step_s_;
    return steps > 0.0 ? std::min(last, static_cast<std::size_t>(steps)) : 0;
  }
  const auto above = std::upper_bound(times_s_.begin(), times_s_.end(), time_s);
  const auto index = above - times_s_.begin();
  return index > 0 ? std::min(last, static_cast<std::size_t>(index - 1)) : 0;
}

Track::Window Track::window(double time_s, std::size_t interval) const noexcept {
  const auto count = static_cast<std::size_t>(points_);
  const std::size_t before = (count - 1) / 2;
  const std::size_t first =
      std::min(interval > before ? interval - before : 0, times_s_.size() - count);
  Window window;
  window.positions = &positions_[first];
  window.weights = &weights_[step_s_ > 0.0 ? 0 : first * count];
  const double from_first =
      step_s_ > 0.0 ? (time_s - times_s_.front()) / step_s_ - static_cast<double>(first) : 0.0;
  for (std::size_t j = 0; j < count; ++j) {
    window.away[j] =
        step_s_ > 0.0 ? from_first - static_cast<double>(j) : time_s - times_s_[first + j];
  }
  return window;
}

/// Lagrange's basis by products from both sides: exact at the points, and no division.
Vec3 Track::position(double time_s) const noexcept {
  if (is_fixed()) return positions_.front();
  const Window w = window(time_s, interval(time_s));
  const auto count = static_cast<std::size_t>(points_);
  std::array<double, most_points> after;  // products of those to the right
  after[count - 1] = 1.0;
  for (std::size_t j = count - 1; j > 0; --j) after[j - 1] = after[j] * w.away[j];
  double before = 1.0;
  Vec3 sum;
  for (std::size_t j = 0; j < count; ++j) {
    sum += w.positions[j] * (w.weights[j] * before * after[j]);
    before *= w.away[j];
  }
  return sum;
}

TrackState Track::state(double time_s, std::size_t interval) const noexcept {
  const Window w = window(time_s, interval);
  const auto count = static_cast<std::size_t>(points_);
  std::array<double, most_points> after, after_slope;
  after[count - 1] = 1.0;
  after_slope[count - 1] = 0.0;
  for (std::size_t j = count - 1; j > 0; --j) {
    after[j - 1] = after[j] * w.away[j];
    after_slope[j - 1] = after_slope[j] * w.away[j] + after[j];
  }
  double before = 1.0, before_slope = 0.0;
  TrackState state;
  // The weights of the velocity sum to 0: differences from one point keep its digits.
  const Vec3 origin = w.positions[count / 2];
  for (std::size_t j = 0; j < count; ++j) {
    const Vec3 offset = w.positions[j] - origin;
    state.position += offset * (w.weights[j] * before * after[j]);
    state.velocity += offset * (w.weights[j] * (before_slope * after[j] + before * after_slope[j]));
    before_slope = before_slope * w.away[j] + before;
    before *= w.away[j];
  }
  state.position += origin;
  if (step_s_ > 0.0) state.velocity = state.velocity / step_s_;
  return state;
}

/// The same by the table itself: at its moments division may round to the wrong side.
std::size_t Track::exact_interval(double time_s) const noexcept {
  const std::size_t near = interval(time_s);
  if (near > 0 && time_s < times_s_[near]) return near - 1;
  return near + 2 < times_s_.size() && time_s >= times_s_[near + 1] ? near + 1 : near;
}

TrackState Track::at(double time_s) const noexcept {
  if (is_fixed()) return {positions_.front(), {}};
  return state(time_s, exact_interval(time_s));
}

TrackState Track::before(double time_s) const noexcept {
  if (is_fixed()) return {positions_.front(), {}};
  const std::size_t begun = exact_interval(time_s);
  const bool at_start = begun > 0 && time_s <= times_s_[begun];
  return state(time_s, at_start ? begun - 1 : begun);
}

}  // namespace nadir::sensor
