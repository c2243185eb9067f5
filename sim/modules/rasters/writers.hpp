#pragma once

#include "raster_output.hpp"

namespace nadir_rasters {

/// @throws std::runtime_error with GDAL's words
void write_geotiff(const NadirGeoTiff& wanted);
void write_netcdf(const NadirNetCdf& wanted);

/// Longitude and latitude in degrees (WGS84) to x and y of a coordinate system; NaN where there is
/// no conversion.
/// @throws std::runtime_error for a system that GDAL does not know
void project(const char* coordinates, int count, double* x, double* y);

}  // namespace nadir_rasters
