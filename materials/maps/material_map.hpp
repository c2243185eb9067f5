#pragma once

#include <cstdint>
#include <vector>

#include "materials/maps/map_frame.hpp"

namespace nadir::materials {

/// A raster that says which material is where: one index a pixel, or a fraction of each of several
/// materials. Fractions are met by drawing one material at random with its fraction as its chance:
/// radiance is linear in them, so that the mean is right, temperatures and all.
///
/// The choice among many spectra of one material by an image's local contrast is a map of this
/// kind as well, made when the image is read (contrast_choice.hpp).
struct MaterialMap {
  MapFrame frame;
  std::vector<std::uint32_t> materials;  ///< indices of the scene's materials, one a layer
  std::vector<std::uint16_t> choice;     ///< a layer for each pixel, row-major; or empty
  std::vector<float> cumulative;  ///< else running sums of the fractions, layer fastest; last is 1

  /// The material at (east, north) or (u, v). `u` in [0, 1) decides where materials are mixed.
  [[nodiscard]] std::uint32_t at(Vec2 place, double u) const noexcept;
};

}  // namespace nadir::materials
