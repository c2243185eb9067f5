#include "sim/run/file_weather_series.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nadir::sim {
namespace {

constexpr double touching_s = 1.0;  // spans whose ends are nearer than this touch

/// Adds a node; of two at one time the first stays.
void add_node(thermal::TimeSeries& series, double time_s, double value) {
  if (!series.time_s.empty() && time_s <= series.time_s.back() + 0.5 * touching_s) return;
  series.time_s.push_back(time_s);
  series.value.push_back(value);
}

/// Where spans touch the line runs through their mean, but not so high that one of them would have
/// to go below zero to keep its own.
double value_between(const SpanValue& before, const SpanValue& after) {
  return std::min({0.5 * (before.value + after.value), 2.0 * before.value, 2.0 * after.value});
}

/// The nodes within a span whose ends are given, so that the mean is the span's value: one in the
/// middle, (first + 2 m + last) / 4; or, where that would stick out, a plateau over the middle
/// half, (first + 6 m + last) / 8.
void add_within(thermal::TimeSeries& series, const SpanValue& span, double ends, double most) {
  const double width = span.to_s - span.from_s;
  const double peak = 2.0 * span.value - 0.5 * ends;
  if (peak <= 4.0 / 3.0 * span.value) {
    add_node(series, span.from_s + 0.5 * width, std::clamp(peak, 0.0, most));
    return;
  }
  const double plateau = std::clamp((8.0 * span.value - ends) / 6.0, 0.0, most);
  add_node(series, span.from_s + 0.25 * width, plateau);
  add_node(series, span.from_s + 0.75 * width, plateau);
}

}  // namespace

thermal::TimeSeries line_through(const std::vector<SpanValue>& values) {
  thermal::TimeSeries series;
  for (const SpanValue& v : values) {
    series.time_s.push_back(0.5 * (v.from_s + v.to_s));
    series.value.push_back(v.value);
  }
  return series;
}

thermal::TimeSeries line_of_means(const std::vector<SpanValue>& values, double most) {
  thermal::TimeSeries series;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const SpanValue& v = values[i];
    const bool joins_before = i > 0 && v.from_s - values[i - 1].to_s < touching_s;
    const bool joins_after = i + 1 < values.size() && values[i + 1].from_s - v.to_s < touching_s;
    const double first = joins_before ? value_between(values[i - 1], v) : v.value;
    const double last = joins_after ? value_between(v, values[i + 1]) : v.value;
    add_node(series, v.from_s, std::min(first, most));
    add_within(series, v, first + last, most);
    add_node(series, v.to_s, std::min(last, most));
  }
  return series;
}

std::vector<SpanValue> joined(const std::vector<SpanValue>& values, double span_s) {
  std::vector<SpanValue> result;
  int count = 0;
  for (const SpanValue& v : values) {
    const double begin = span_s * std::floor(0.5 * (v.from_s + v.to_s) / span_s);
    if (result.empty() || result.back().from_s != begin) {
      result.push_back({begin, begin + span_s, 0.0});
      count = 0;
    }
    SpanValue& mean = result.back();
    mean.value += (v.value - mean.value) / ++count;
  }
  return result;
}

}  // namespace nadir::sim
