#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

// Zeros of smooth functions of one variable that are dear to ask, such as where in time a place
// crosses a row of detectors. The functions are in pixels; NaN where they have no value.

namespace nadir::sensor {

struct Interval {
  double low = 0.0, high = 0.0;
};

/// As near as it gets: far places have rounding of some 1e-8 pixel.
inline constexpr double zero_px = 1e-9, rounding_px = 3e-8;

/// The secant method from a guess, kept in the interval. None where it does not arrive soon.
template <class F>
[[nodiscard]] std::optional<double> secant_zero(const F& f, Interval within, double guess,
                                                double first_step) {
  double a = std::clamp(guess, within.low, within.high);
  double fa = f(a);
  if (std::abs(fa) <= zero_px) return a;
  double b = a + first_step <= within.high ? a + first_step : a - first_step;
  b = std::clamp(b, within.low, within.high);
  for (int i = 0; i < 30; ++i) {
    const double fb = f(b);
    if (std::abs(fb) <= zero_px) return b;
    const double next = std::clamp(b - fb * (b - a) / (fb - fa), within.low, within.high);
    // NaN: no value, or no slope.
    if (!(std::abs(next - b) > 2e-16 * std::max(std::abs(b), 1.0))) {
      return std::abs(fb) <= rounding_px ? std::optional{b} : std::nullopt;
    }
    a = std::exchange(b, next);
    fa = fb;
  }
  return std::abs(fa) <= rounding_px ? std::optional{a} : std::nullopt;
}

/// The zero between two places where f has values of different sign (Illinois: false position that
/// halves the value of the end that stays; G. Dahlquist and A. Bjorck, Numerical Methods, 1974,
/// section 6.4.3).
template <class F>
[[nodiscard]] double bracketed_zero(const F& f, Interval bracket, double at_low, double at_high) {
  auto [a, b] = bracket;
  for (int i = 0; i < 100; ++i) {
    const double c =
        std::clamp((a * at_high - b * at_low) / (at_high - at_low), std::min(a, b), std::max(a, b));
    const double fc = f(c);
    if (!(std::abs(fc) > zero_px) || c == a || c == b) return c;
    if ((fc > 0.0) == (at_high > 0.0)) {
      at_low *= 0.5;
    } else {
      a = b;
      at_low = at_high;
    }
    b = c;
    at_high = fc;
  }
  return b;
}

/// Calls found(zero) for the zeros that evenly spaced places tell apart, in ascending order, until
/// it says true.
template <class F, class Found>
void every_zero(const F& f, Interval within, int places, const Found& found) {
  const double step = (within.high - within.low) / places;
  double before = within.low, value_before = f(before);
  for (int i = 1; i <= places; ++i) {
    const double here = i == places ? within.high : within.low + i * step, value = f(here);
    if (value_before == 0.0 || value_before * value < 0.0) {
      if (found(bracketed_zero(f, {before, here}, value_before, value))) return;
    }
    before = here;
    value_before = value;
  }
  if (value_before == 0.0) found(before);
}

}  // namespace nadir::sensor
