#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.hpp"

namespace nadir::sensor {

/// Power spectral density of the shaking about one camera axis, one-sided.
struct JitterSpectrum {
  std::vector<double> frequencies_hz;   ///< ascending, > 0; none: no shaking
  std::vector<double> density_rad2_hz;  ///< >= 0, log-log between, 0 outside
};

struct JitterDescription {
  Vec3 white_rms_rad;         ///< about x, y, z: from moment to moment without memory
  JitterSpectrum spectra[3];  ///< about x, y, z
  std::uint64_t seed = 1;     ///< of the realisation
};

/// One realisation of shaking with given spectra, tabulated over a span of time: every line of an
/// image sees the same motion at the same moment. Sums of cosines with random phases (Shinozuka and
/// Deodatis, Applied Mechanics Reviews 44, 191, 1991), cubic between the table's steps.
class Jitter {
 public:
  Jitter() = default;  ///< none
  /// @throws InputError for spectra that are not: sizes, order, negative or not finite values
  Jitter(const JitterDescription& description, double first_s, double last_s);

  /// Small angles about the camera's axes x, y, z at a moment.
  [[nodiscard]] Vec3 angles_rad(double time_s) const noexcept;
  /// rms of what has memory, about each axis.
  [[nodiscard]] Vec3 coloured_rms_rad() const noexcept { return coloured_rms_rad_; }
  [[nodiscard]] Vec3 white_rms_rad() const noexcept { return white_rms_rad_; }

 private:
  Vec3 white_rms_rad_, coloured_rms_rad_;
  double first_s_ = 0.0, step_s_ = 0.0;
  std::vector<Vec3> table_;
};

}  // namespace nadir::sensor
