#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/vec.hpp"
#include "geometry/earth.hpp"

// Raster formats that GDAL writes for us, in its module. Each file appears under its name only when
// it is whole.

namespace nadir::sim {

using TextItems = std::vector<std::pair<std::string, std::string>>;

/// Where the pixels of an image lie in a coordinate system: x = a[0] + sample a[1] + line a[2],
/// y = a[3] + sample a[4] + line a[5], pixel corners counted.
struct MapPlacement {
  std::string coordinates;  ///< any form that GDAL reads: "EPSG:32617", WKT, PROJ
  std::array<double, 6> transform{};
};

/// A pixel place, (0.5, 0.5) being the centre of the first, and where it lies on the earth.
struct ControlPoint {
  Vec2 image;
  geometry::Geodetic place;
};

struct GeoTiffBand {
  std::string description, unit;
  double scale = 1.0, offset = 0.0;
  TextItems items{};  ///< metadata
};

struct GeoTiff {
  std::filesystem::path source;  ///< a raster file that GDAL reads
  std::optional<MapPlacement> map;
  std::vector<ControlPoint> control;  ///< excludes `map`
  TextItems rpc;                      ///< GDAL's names of rational polynomial coefficients
  TextItems items;
  std::vector<GeoTiffBand> bands;  ///< one a band of the source
  bool nan_is_no_data = false;
};

/// Writes a cloud-optimised GeoTIFF, deflated, with overviews, in bounded memory.
/// @throws std::runtime_error with GDAL's words
void write_geotiff(const std::filesystem::path& target, const GeoTiff& wanted);

/// An attribute of a NetCDF file or variable.
using NetCdfValue = std::variant<std::string, double, int>;
using NetCdfAttributes = std::vector<std::pair<std::string, NetCdfValue>>;

struct RasterPlanes {
  std::filesystem::path file;  ///< its rows and columns are the variable's last two dimensions
  int first_plane = 1;         ///< and one for each index of a third dimension, the first
};

struct NetCdfVariable {
  enum class Type { float32, float64, int32 };
  std::string name;
  std::vector<int> dimensions;  ///< indices into the file's, slowest first
  Type type = Type::float32;
  /// All values, row-major, or texts, or where planes of values lie.
  std::variant<std::vector<double>, std::vector<std::string>, RasterPlanes> values;
  NetCdfAttributes attributes{};
  bool nan_is_fill = false;
};

struct NetCdf {
  std::vector<std::pair<std::string, int>> dimensions;
  std::vector<NetCdfVariable> variables;
  NetCdfAttributes attributes;
};

/// Writes a NetCDF file (version 4, deflated), planes by blocks of lines.
/// @throws std::runtime_error with GDAL's words
void write_netcdf(const std::filesystem::path& target, const NetCdf& wanted);

/// Places in a coordinate system (x, y), heights left out; NaN where there is no conversion.
/// @throws std::runtime_error for a system that GDAL does not know
[[nodiscard]] std::vector<Vec2> projected(const std::string& coordinates,
                                          const std::vector<geometry::Geodetic>& places);

}  // namespace nadir::sim
