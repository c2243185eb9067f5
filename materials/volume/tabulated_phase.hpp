#pragma once

#include <cstdint>
#include <vector>

#include "materials/volume/medium.hpp"
#include "spectral/lanes.hpp"

namespace nadir::materials {

/// A tabulated phase function at the lanes: each row of the table is normalised over the sphere,
/// then interpolated linearly over wavelength; between angles it is linear in the cosine of the
/// scattering angle, so that normalisation and sampling are exact.
class BoundTabulatedPhase {
 public:
  /// @throws InputError for angles that do not ascend from 0 to pi, values that are missing,
  /// negative or
  ///         not finite, a row of zeros, lanes outside the table's wavelengths
  BoundTabulatedPhase(const TabulatedPhase& phase, const spectral::Lanes& lanes);

  /// @param x  1 - cosine of the scattering angle, [0, 2]
  [[nodiscard]] spectral::Spectrum eval(double x) const noexcept;
  /// A number x = 1 - cos, drawn from the mean of the lanes' functions.
  [[nodiscard]] double sample(double choice) const noexcept;

 private:
  [[nodiscard]] std::size_t interval(double x) const noexcept;
  void tabulate_sampling();

  int lanes_ = 0;
  std::vector<double> x_;             // of the nodes, ascending from 0 to 2
  std::vector<float> value_;          // lane fastest, sr^-1
  std::vector<double> mean_;          // of the lanes at the nodes, sr^-1
  std::vector<double> cumulative_;    // of the mean, at the nodes, from 0 to 1
  std::vector<std::uint32_t> guide_;  // interval that holds the beginning of each part, in sqrt(x)
};

}  // namespace nadir::materials
