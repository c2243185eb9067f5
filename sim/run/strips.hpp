#pragma once

#include <vector>

#include "sim/run/image.hpp"

namespace nadir::sim {

/// Consecutive whole lines of an image.
struct Strip {
  int first_line = 0, lines = 0;
};

/// Cuts an image into strips of at least 2^17 pixels: enough work to keep all processors busy, some
/// tens of megabytes of planes. Strips are whole multiples of `unit` lines, the last one excepted.
[[nodiscard]] std::vector<Strip> cut_into_strips(int samples, int lines, int unit);

/// Puts a tile's pixels where they belong in a strip that has the same planes.
void paste(ArrayImage& strip, const ArrayImage& tile);

/// Adds the lines of a strip below those of an image that has the same planes.
void append(ArrayImage& image, const ArrayImage& strip);

}  // namespace nadir::sim
