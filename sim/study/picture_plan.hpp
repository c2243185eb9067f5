#pragma once

#include <array>
#include <string>

#include "sim/study/analyse.hpp"
#include "sim/study/study_pixels.hpp"

namespace nadir::sim {

/// One of the pictures along the curve.
struct PictureShot {
  std::string label;
  StudySettings settings;
  int replicates = 1, samples = 1;
  double path_wall_s = 0.0, setup_s = 0.0;  ///< of its row
  [[nodiscard]] double paths() const noexcept { return static_cast<double>(replicates) * samples; }
};

/// One path a pixel, a few, what is recommended, and the best that there is time for; every
/// `step`-th sample of every `step`-th line.
struct PicturePlan {
  std::array<PictureShot, 4> shots;
  int step = 1;
  bool affordable = false;  ///< a picture of some thousand pixels
};
/// @param seconds  for all four
[[nodiscard]] PicturePlan plan_pictures(const StudyResult& result, const StudyHeader& header,
                                        const ImageSize& image, double seconds);

}  // namespace nadir::sim
