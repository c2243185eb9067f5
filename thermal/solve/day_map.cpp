#include "thermal/solve/day_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "thermal/conduction/temperature_range.hpp"

namespace nadir::thermal {
namespace {

/// A square matrix, row after row.
struct Square {
  std::size_t n;
  std::vector<double> values = std::vector<double>(n * n, 0.0);

  double& at(std::size_t i, std::size_t j) { return values[i * n + j]; }
};

/// Subtracts `factor` times a row from another.
void subtract_row(Square& matrix, std::size_t from, std::size_t to, double factor) {
  for (std::size_t j = 0; j < matrix.n; ++j) matrix.at(to, j) -= factor * matrix.at(from, j);
}

std::size_t pivot_row(Square& matrix, std::size_t column) {
  std::size_t best = column;
  for (std::size_t i = column + 1; i < matrix.n; ++i) {
    if (std::abs(matrix.at(i, column)) > std::abs(matrix.at(best, column))) best = i;
  }
  return best;
}

/// Gauss and Jordan with pivots by column; empty if a pivot vanishes.
std::vector<double> inverted(Square matrix) {
  const std::size_t n = matrix.n;
  Square result{n};
  for (std::size_t i = 0; i < n; ++i) result.at(i, i) = 1.0;
  for (std::size_t column = 0; column < n; ++column) {
    const std::size_t best = pivot_row(matrix, column);
    const double pivot = matrix.at(best, column);
    if (!(std::abs(pivot) > 1e-12)) return {};
    for (std::size_t j = 0; j < n; ++j) {
      std::swap(matrix.at(best, j), matrix.at(column, j));
      std::swap(result.at(best, j), result.at(column, j));
      matrix.at(column, j) /= pivot;
      result.at(column, j) /= pivot;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const double factor = matrix.at(i, column);
      if (i == column || factor == 0.0) continue;
      subtract_row(matrix, column, i, factor);
      subtract_row(result, column, i, factor);
    }
  }
  return std::move(result.values);
}

double largest(std::span<const double> values) noexcept {
  double most = 0.0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

/// Where the next day begins.
void move_begin(std::span<const double> begin, std::span<const double> step,
                std::span<double> result) noexcept {
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = std::clamp(begin[i] + step[i], least_temperature.value, greatest_temperature.value);
  }
}

/// A day that has been gone through, and Newton's step after it.
struct DayDone {
  std::span<double> begin, step;
  bool held = false;
};
/// Leaves in temperature_k what the day changed.
DayDone go_through(const ColumnRun& day, const DayMap& map, std::span<double> temperature_k,
                   std::span<double> memory) {
  const std::size_t nodes = temperature_k.size();
  DayDone done{memory.first(nodes), memory.subspan(nodes, nodes)};
  std::copy(temperature_k.begin(), temperature_k.end(), done.begin.begin());
  done.held = day.march(temperature_k) > 0;
  for (std::size_t i = 0; i < nodes; ++i) temperature_k[i] -= done.begin[i];
  map.step(temperature_k, done.step);
  return done;
}

/// M times the step: what of it the day does not forget, and where a wrong M tells. Of a mode that
/// falls to M within a day, at a rate that is off by a share d, Newton's step leaves the share
/// d M |ln M| / (1 - M); with d = 1/4 that is at most M down to M = 0.02 (ln 0.02 = -3.9), and
/// beneath it nothing.
double remembered(std::span<const double> step, std::span<const double> change) noexcept {
  double most = 0.0;
  for (std::size_t i = 0; i < step.size(); ++i) {
    most = std::max(most, std::abs(step[i] - change[i]));
  }
  return most;
}

}  // namespace

DayMap::DayMap(const ColumnRun& day, std::span<const double> begin_k) : nodes_{begin_k.size()} {
  // Small against the curvature of radiation, large against the tolerance of the surface's root.
  constexpr double push_k = 0.25;
  constexpr double most_magnified = 1e5;
  std::vector<double> plain(begin_k.begin(), begin_k.end());
  day.march(plain);
  Square matrix{nodes_};
  for (std::size_t j = 0; j < nodes_; ++j) {
    std::vector<double> pushed(begin_k.begin(), begin_k.end());
    const double push = pushed[j] + push_k <= greatest_temperature.value ? push_k : -push_k;
    pushed[j] += push;
    day.march(pushed);
    for (std::size_t i = 0; i < nodes_; ++i) {
      matrix.at(i, j) = (i == j ? 1.0 : 0.0) - (pushed[i] - plain[i]) / push;
    }
  }
  inverse_ = inverted(std::move(matrix));
  if (!(largest(inverse_) < most_magnified)) inverse_.clear();
}

void DayMap::step(std::span<const double> change_k, std::span<double> result) const noexcept {
  if (inverse_.empty()) {
    std::copy(change_k.begin(), change_k.end(), result.begin());
    return;
  }
  const double* row = inverse_.data();
  for (std::size_t i = 0; i < nodes_; ++i, row += nodes_) {
    double sum = 0.0;
    for (std::size_t j = 0; j < nodes_; ++j) sum += row[j] * change_k[j];
    result[i] = sum;
  }
}

void approach(const ColumnRun& day, const DayMap& map, std::span<double> temperature_k,
              std::span<double> memory) {
  const DayDone done = go_through(day, map, temperature_k, memory);
  move_begin(done.begin, done.step, temperature_k);
}

SpinUp spin_up(const ColumnRun& day, const DayMap& map, const SpinUpLimits& limits,
               std::span<double> temperature_k, std::span<double> memory) {
  // Until two steps have shown it: slopes of one material's places differ by less than a quarter.
  double remains = 0.25, before = std::numeric_limits<double>::infinity();
  for (int days = 1;; ++days) {
    const DayDone done = go_through(day, map, temperature_k, memory);
    const double change = largest(temperature_k), away = largest(done.step);
    if (days > 1) remains = std::min(1.0, away / before);
    const double first = days == 1 ? remembered(done.step, temperature_k) : away;
    // A step that did not help is not repeated: the day itself always leads on.
    const bool helps = remains < 0.7;
    if (!helps) std::copy(temperature_k.begin(), temperature_k.end(), done.step.begin());
    move_begin(done.begin, done.step, temperature_k);
    const double left = map.steps_far() ? std::min(remains * away, first) : change;
    const bool repeats = left <= limits.spin_up_k;
    if (repeats || days >= limits.most_days) {
      return {days, repeats, repeats && map.steps_far() && !done.held};
    }
    before = away;
  }
}

}  // namespace nadir::thermal
