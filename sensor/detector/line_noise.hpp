#pragma once

#include <array>
#include <cstdint>

namespace nadir::sensor {

/// Noise that a whole line of an image has in common, from line to line with a memory.
///
/// Stripes: first-order autoregression s' = rho s + sqrt(1 - rho^2) sigma z.
///
/// Flicker (1/f noise): thirteen autoregressions of equal variance whose memories are 1/2, 1, 2,
/// ..., 2048 lines; their sum has a power spectrum within 10 % of 1/f from one cycle in 2700 lines
/// to one in 2.5. `flicker` is its standard deviation over many thousand lines. Source: A. van der
/// Ziel, Physica 16, 359 (1950): 1/f as a sum of relaxations.
class LineNoise {
 public:
  struct Rms {
    double stripe = 0.0, memory = 0.0;  ///< electrons; correlation with the next line, [0, 1)
    double flicker = 0.0;               ///< electrons
  };
  explicit LineNoise(const Rms& rms) noexcept : rms_{rms} {}

  /// The noise of the next line, electrons; lines come in order. @param key  of the line's numbers
  double next(std::uint64_t key) noexcept;

 private:
  Rms rms_;
  bool first_ = true;
  double stripe_ = 0.0;
  std::array<double, 13> relaxations_{};
};

}  // namespace nadir::sensor
