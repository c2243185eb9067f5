#pragma once

#include <filesystem>
#include <vector>

#include "geometry/terrain.hpp"

namespace nadir::sim {

/// One band of a raster file.
struct Raster {
  int columns = 0, rows = 0;
  int bands = 0;               ///< of the file
  std::vector<double> values;  ///< row-major, first row first; NaN where the file has no value
  bool has_geotransform = false;
  bool has_projection = false;
  double full_scale = 0.0;  ///< largest value of an unsigned whole-number type; 0 for others
};

/// WGS84 bounds; `west_deg` may exceed `east_deg` where they cross the date line.
struct GeodeticBounds {
  double south_deg = -90.0, west_deg = -180.0, north_deg = 90.0, east_deg = 180.0;
};

/// Reads a band (from 1) of any raster that GDAL reads. Scale and offset of the band are applied.
/// Loads the module with GDAL on first use.
/// @throws InputError with GDAL's words for a file that cannot be read, std::runtime_error without
///         the module
[[nodiscard]] Raster read_raster(const std::filesystem::path& file, int band = 1);

/// WGS84 latitude and longitude of places in a raster, in pixels: (0.5, 0.5) is the centre of the
/// first. NaN where the raster's coordinate system has no conversion. Heights are 0.
/// @throws InputError naming what is missing: coordinate system or geotransform
[[nodiscard]] std::vector<geometry::Geodetic> locate_in_raster(const std::filesystem::path& file,
                                                               const std::vector<Vec2>& pixels);

/// The first band as heights in metres, posts at the pixel centres, taken to WGS84 from the
/// raster's own coordinate system.
/// @param height_offset_m  added to every height: the raster's datum above the ellipsoid
/// @param bounds           if given, only the pixels inside, and one more all round
/// @throws InputError naming what is missing: coordinate system, geotransform, any pixel in bounds
[[nodiscard]] geometry::HeightGrid read_height_grid(const std::filesystem::path& file,
                                                    double height_offset_m,
                                                    const GeodeticBounds* bounds = nullptr);

}  // namespace nadir::sim
