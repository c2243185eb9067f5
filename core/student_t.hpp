#pragma once

#include "core/statistics.hpp"

namespace nadir {

/// Quantile of Student's t distribution: the t that a variable of so many degrees of freedom stays
/// below with the given probability.
///
/// Solves Q(t | nu) = I_x(nu / 2, 1 / 2) / 2 = 1 - probability, x = nu / (nu + t^2), by Newton's
/// method on ln Q against ln t, which is concave; the incomplete beta function I by its continued
/// fraction. A few microseconds: ask once for an image, not once for a pixel.
///
/// @param probability         in (0, 1); outside: NaN
/// @param degrees_of_freedom  >= 1; else NaN
///
/// Accuracy: relative error below 1e-10 for probabilities in [1e-9, 1 - 1e-9] and up to 10^6
/// degrees of freedom (student_t_test.cpp: closed forms for 1, 2 and 4 degrees and published
/// values). Source: W. S. Gosset ("Student"), Biometrika 6, 1 (1908); Abramowitz & Stegun
/// (1964), 26.5.8 (continued fraction) and 26.7.1.
[[nodiscard]] double student_t_quantile(double probability, int degrees_of_freedom);

/// Closed interval on the real line.
struct Interval {
  double lower = 0.0, upper = 0.0;

  [[nodiscard]] constexpr bool contains(double x) const noexcept {
    return lower <= x && x <= upper;
  }
};

/// Two-sided confidence interval of a mean over independent, normally distributed replicates:
/// mean -+ t s, with t the (1 + level) / 2 quantile for replicates - 1 degrees of freedom. In the
/// long run the share `level` of such intervals covers the true mean.
///
/// @param replicates  that the estimate was made of; fewer than 2 tell nothing: NaN bounds
/// @param level       in (0, 1), as 0.95
[[nodiscard]] Interval confidence_interval(const Estimate& estimate, int replicates, double level);

}  // namespace nadir
