#pragma once
// The table through which the program calls the module `nadir_rasters`. Plain C types only: no
// exception and no memory of one side is handled by the other.

#include <cstddef>

#include "raster_output.hpp"

extern "C" {

/// A raster band on its way out of the module. What it points to lives until `release`.
struct NadirRaster {
  int columns;
  int rows;
  int bands;               ///< of the file
  const double* values;    ///< row-major; NaN where the file has no value
  double full_scale;       ///< largest value of an unsigned whole-number type; 0 for others
  double geotransform[6];  ///< pixel corner to projected coordinates, GDAL's order
  int has_geotransform;
  int has_projection;
  const double* latitude_deg;  ///< of pixel centres, WGS84; null unless asked for
  const double* longitude_deg;
  void* owner;  ///< the module's own
};

/// Cuts to the pixels whose centres lie in these bounds, and a margin of one pixel. West may exceed
/// east across the date line.
struct NadirRasterWindow {
  double south_deg, west_deg, north_deg, east_deg;
};

struct NadirRasterModule {
  int version;  ///< of this table
  /// Reads band `band` (from 1). With `geodetic` the places of the pixel centres too, which needs
  /// a geotransform and a projection. `window` may be null. Returns 0 for success; otherwise
  /// `message` (of `message_size` bytes) says what is wrong, and `out` holds nothing.
  int (*read)(const char* path, int band, int geodetic, const NadirRasterWindow* window,
              NadirRaster* out, char* message, std::size_t message_size);
  void (*release)(NadirRaster* raster);
  /// Where `count` places of the raster lie. `column` and `row` are in pixels, (0.5, 0.5) being the
  /// centre of the first; they are replaced by longitude and latitude in degrees, WGS84, NaN where
  /// there is no conversion. Returns and complains as `read`.
  int (*locate)(const char* path, int count, double* column, double* row, char* message,
                std::size_t message_size);
  /// Longitudes and latitudes in degrees (WGS84) become x and y of a coordinate system, NaN where
  /// there is no conversion. Returns and complains as `read`; so do the writers.
  int (*project)(const char* coordinates, int count, double* x, double* y, char* message,
                 std::size_t message_size);
  int (*write_geotiff)(const NadirGeoTiff* wanted, char* message, std::size_t message_size);
  int (*write_netcdf)(const NadirNetCdf* wanted, char* message, std::size_t message_size);
};

enum { nadir_raster_module_version = 3 };

/// The one exported function.
const NadirRasterModule* nadir_raster_module(void);
}
