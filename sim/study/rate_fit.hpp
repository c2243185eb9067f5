#pragma once

#include <vector>

namespace nadir::sim {

/// An error that was found with so many paths.
struct RatePoint {
  double paths = 1.0;        ///< > 0
  double error = 0.0;        ///< >= 0, any unit
  double uncertainty = 0.0;  ///< standard error of `error`, > 0
};

/// How an error falls with the number of paths: error^2 = bias^2 + (scale * paths^-rate)^2.
struct RateFit {
  double bias = 0.0;              ///< >= 0; unit of the errors
  double scale = 0.0;             ///< error of one path without the bias
  double rate = 0.5;              ///< p; independent paths have 1/2, low-discrepancy points more
  double rate_uncertainty = 0.0;  ///< infinity where the points do not tell
  double reduced_chi2 = 0.0;      ///< of the fit, a degree of freedom; 0 where there is none
  [[nodiscard]] double error(double paths) const noexcept;
};

enum class RateBias { none, fitted };

/// Weighted least squares in error^2. For a given p the law is linear in bias^2 and scale^2, which
/// are solved with both held at 0 or above; p is then searched in [0.1, 1.6] by golden section. The
/// uncertainty of p comes from the curvature of chi^2, times sqrt(reduced chi^2) where that is
/// above 1. Fewer than two different numbers of paths (three with a bias) leave p at 1/2 and its
/// uncertainty infinite.
[[nodiscard]] RateFit fit_rate(const std::vector<RatePoint>& points, RateBias bias);

}  // namespace nadir::sim
