#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.hpp"

namespace nadir::sensor {

/// Power spectral density of the shaking about one camera axis, one-sided: its integral over all
/// frequencies is the mean square of the angle.
struct JitterSpectrum {
  std::vector<double> frequencies_hz;   ///< ascending, > 0; none: no shaking
  std::vector<double> density_rad2_hz;  ///< >= 0, log-log between (linear beside a 0), 0 outside
};

struct JitterDescription {
  Vec3 white_rms_rad;         ///< about x, y, z: from moment to moment without memory
  JitterSpectrum spectra[3];  ///< about x, y, z
  std::uint64_t seed = 1;     ///< of the realisation
};

/// Mean square of the shaking by frequencies below one: the integral of the density, exact for
/// power laws between its points.
/// @param spectrum  legal, as Jitter checks it
[[nodiscard]] double power_below(const JitterSpectrum& spectrum, double frequency_hz) noexcept;

/// One realisation of shaking with given spectra, tabulated over a span of time: every line of an
/// image sees the same motion at the same moment. Sums of cosines at even frequencies with random
/// phases (Shinozuka and Deodatis, Applied Mechanics Reviews 44, 191, 1991), each with the power of
/// its share of the spectrum; cubic between the table's steps, of which there are 16 in the
/// shortest period: off by less than 6e-4 of the rms. It does not repeat itself within the span.
class Jitter {
 public:
  /// The table holds no more steps, 96 MB: 250 s at 1 kHz.
  static constexpr std::size_t most_steps = 4'000'000;

  Jitter() = default;  ///< none
  /// @throws InputError for spectra that are not: sizes, order, negative or not finite values; for
  /// a
  ///         span that would need a larger table
  Jitter(const JitterDescription& description, double first_s, double last_s);

  /// Small angles about the camera's axes x, y, z at a moment of the span.
  [[nodiscard]] Vec3 angles_rad(double time_s) const noexcept;
  /// rms of what has memory, about each axis: of many realisations, or a long one.
  [[nodiscard]] Vec3 coloured_rms_rad() const noexcept { return coloured_rms_rad_; }
  [[nodiscard]] Vec3 white_rms_rad() const noexcept { return white_rms_rad_; }
  [[nodiscard]] bool has_memory() const noexcept { return !table_.empty(); }
  [[nodiscard]] bool is_white() const noexcept { return white_rms_rad_ != Vec3{}; }

 private:
  Vec3 white_rms_rad_, coloured_rms_rad_;
  double first_s_ = 0.0, step_s_ = 0.0;
  std::vector<Vec3> table_;
};

}  // namespace nadir::sensor
