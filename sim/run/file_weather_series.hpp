#pragma once

#include <string>
#include <vector>

#include "thermal/weather/weather.hpp"

namespace nadir::sim {

/// A value that holds for a span of time as its mean, or at a time (from == to).
struct SpanValue {
  double from_s = 0.0, to_s = 0.0;
  double value = 0.0;
};

/// A line through values at times, the middle of spans among them.
[[nodiscard]] thermal::TimeSeries line_through(const std::vector<SpanValue>& values);

/// A line whose mean over every span is that span's value, never below zero: no energy is lost or
/// added by interpolation. Spans ascend and do not overlap; where they touch, the line runs through
/// a value between theirs. Linear rises over even spans are reproduced.
/// @param most  the line is cut off here; above 4/3 of the largest value it never comes
[[nodiscard]] thermal::TimeSeries line_of_means(const std::vector<SpanValue>& values, double most);

/// Values closer than `span_s` joined into their means over spans of that length, counted from 0: a
/// heat balance that looks every ten minutes must not pick single minutes.
[[nodiscard]] std::vector<SpanValue> joined(const std::vector<SpanValue>& values, double span_s);

}  // namespace nadir::sim
