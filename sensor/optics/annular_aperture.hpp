#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace nadir::sensor {

/// Fraunhofer diffraction by a circular aperture with a round obscuration of diameter ratio e in
/// its middle. Distances x = pi r / (lambda N) from the geometric image of a point, dimensionless,
/// with N the focal ratio; frequencies rho = f lambda N, 1 at the cut-off.
/// Source: V. N. Mahajan, "Optical Imaging and Aberrations II" (2001), section 2.4 (spread and
/// encircled power); E. L. O'Neill, J. Opt. Soc. Am. 46, 285 (1956) (transfer function).
class AnnularAperture {
 public:
  /// @param obscuration  e, in [0, 1)
  explicit AnnularAperture(double obscuration);

  /// Share of the light per unit area of the x plane; from a table, to 1e-3 of its peak.
  [[nodiscard]] double density(double x) const noexcept;
  /// Share of the light within x, to 1e-6. What lies beyond `reach`, 2 / (pi (1 - e) reach) (0.04 %
  /// of a clear aperture's light, 0.13 % at an obscuration of 0.7), is taken in evenly between half
  /// of it and the whole: all that is nearer, and with it the modulation of what a camera resolves,
  /// stays true.
  [[nodiscard]] double encircled(double x) const noexcept;
  /// The distance that holds a share of the light within it: undoes `encircled`. Fast: called for
  /// every path.
  [[nodiscard]] double distance(double share) const noexcept;
  /// Modulation at a frequency: the transfer function is real and not negative.
  [[nodiscard]] double mtf(double rho) const noexcept;

  static constexpr double reach = 1600.0;

 private:
  static constexpr std::size_t bins = 1024;
  double e_;
  std::vector<double> encircled_;      // at even steps of x
  std::vector<double> density_;        // at the same
  std::array<int, bins + 1> guide_{};  // step in which each bin of the light begins
};

}  // namespace nadir::sensor
