#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "sensor/camera/path_view.hpp"
#include "sim/products/product_geometry.hpp"

namespace nadir::sim {

/// A place of an array's image and where its line of sight ends.
struct GroundPoint {
  sensor::ImagePoint image;
  Vec3 place;  ///< scene axes
  geometry::Geodetic geodetic;
  double time_s = 0.0;      ///< after the scenario's
  bool on_surface = false;  ///< of the scene; else at the scene's mean height
};

/// Where a line of sight first comes to a height above the ellipsoid, within a micrometre; none
/// where it does not, or only beyond the earth: lines that go down from below that height.
[[nodiscard]] std::optional<Vec3> at_height(const geometry::LocalFrame& frame,
                                            const geometry::Ray& ray, double height_m);

/// The surface that a place of the image shows; beside the scene the place at its mean height.
[[nodiscard]] std::optional<GroundPoint> ground_at(const ProductGeometry& geometry,
                                                   const sensor::DetectorArray& array,
                                                   sensor::ImagePoint image);
/// The same at a given height, whatever the scene has there.
[[nodiscard]] std::optional<GroundPoint> ground_at(const ProductGeometry& geometry,
                                                   const sensor::DetectorArray& array,
                                                   sensor::ImagePoint image, double height_m);

/// How many places of an image, evenly over it.
struct GridSize {
  int columns = 2, rows = 2;
};
/// Image places from corner to corner, row by row; with `inner`, the centres of the cells.
[[nodiscard]] std::vector<sensor::ImagePoint> image_grid(const sensor::DetectorArray& array,
                                                         GridSize size, bool inner = false);

/// Where the image's edge lies on the earth, clockwise in the image from its first corner, not
/// closed; places that show the sky are left out.
[[nodiscard]] std::vector<GroundPoint> footprint(const ProductGeometry& geometry,
                                                 const sensor::DetectorArray& array);

/// Pixel centres' latitude, longitude, height and time as an ENVI image of doubles (four planes),
/// line by line; NaN for the sky.
void write_places(const std::filesystem::path& image, const ProductGeometry& geometry,
                  const sensor::DetectorArray& array);

}  // namespace nadir::sim
