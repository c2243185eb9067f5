#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/run/image.hpp"

namespace nadir::sim {

/// Which planes an image has, and of what size. Two images with equal `filled` have the same
/// planes.
struct PlaneList {
  std::vector<bool> filled;
};

/// Whether all planes that an image has are of its size, and those that it must have are there.
/// @param truth  whether the truth is wanted
/// @throws std::invalid_argument naming array and plane
[[nodiscard]] PlaneList check_planes(const ArrayImage& image, bool truth);

/// Whether a strip begins an image.
/// @throws std::invalid_argument
void check_first_strip(const ArrayImage& strip);

/// Letters, digits, point, dash, underscore and what is not ASCII stay; the rest becomes an
/// underscore, and a leading point too.
[[nodiscard]] std::string product_file_name(const std::string& array);

}  // namespace nadir::sim
