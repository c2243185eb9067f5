#pragma once

#include <vector>

#include "sim/products/geo_task.hpp"

namespace nadir::sim {

/// The array's image as a NetCDF swath by the CF conventions 1.10: radiance and its standard error
/// by band, line and sample, with latitude, longitude and height of every pixel and the time of
/// every line; docs/geometry-products.md.
[[nodiscard]] std::vector<ProductFile> write_netcdf_swath(const GeoTask& task);

}  // namespace nadir::sim
