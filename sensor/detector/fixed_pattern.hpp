#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sensor/camera/detector_array.hpp"
#include "sensor/detector/detector.hpp"

namespace nadir::sensor {

/// Key of the random numbers of a band of an array: other arrays and bands have other numbers,
/// whatever else the camera has.
[[nodiscard]] std::uint64_t band_key(std::uint64_t seed, const DetectorArray& array,
                                     std::size_t band) noexcept;

/// What differs from detector to detector and stays from image to image. A frame has a detector
/// for each pixel; a pushbroom one for each sample; a whiskbroom one for each line of its sweep.
class FixedPattern {
 public:
  struct Rms {
    double gain = 0.0;    ///< of PRNU, relative
    double offset = 0.0;  ///< of DSNU, electrons
    double dead_share = 0.0;
  };
  FixedPattern(const DetectorArray& array, std::uint64_t key, const Rms& rms);

  /// Makes the pattern of a line of the image the current one. Lines in any order.
  void line(int line);
  /// Factor of the light, >= 0; mean 1.
  [[nodiscard]] double gain(std::size_t sample) const noexcept { return gain_[sample]; }
  [[nodiscard]] double offset(std::size_t sample) const noexcept { return offset_[sample]; }
  [[nodiscard]] bool dead(std::size_t sample) const noexcept { return dead_[sample] != 0; }

 private:
  enum class Layout { frame, row, column };
  [[nodiscard]] std::uint64_t detector(std::size_t sample, int line) const noexcept;

  std::uint64_t key_;
  Rms rms_;
  Layout layout_ = Layout::frame;
  int rows_ = 1;  ///< of a whiskbroom's column
  int current_ = -1;
  std::vector<double> gain_, offset_;
  std::vector<std::uint8_t> dead_;
};

/// Fall-off of the focal plane's light towards the corners, cos^n of the angle between the axis and
/// the principal ray, for each sample of a line. 1 for parallel and for tabulated lines of sight.
class FallOff {
 public:
  FallOff(const DetectorArray& array, double power);

  void line(int line);
  [[nodiscard]] double at(std::size_t sample) const noexcept { return values_[sample]; }

 private:
  DetectorArray array_;  ///< without its bands
  double power_;
  double focal_length_m_ = 0.0;  ///< 0: no fall-off
  bool same_every_line_ = true, filled_ = false;
  std::vector<double> values_;
};

}  // namespace nadir::sensor
