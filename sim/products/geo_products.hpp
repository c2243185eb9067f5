#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "sim/products/write_products.hpp"

namespace nadir::sim {

/// The products that place an array's image on the earth, as far as `context.wanted` asks for them:
/// GeoTIFF, NetCDF swath, STAC item, CSM image support data. docs/geometry-products.md lists them.
///
/// They are made from the array's finished ENVI files: `stem` with the endings below, each beside
/// its header. Only the radiance is needed; what is not there is left out. Nothing is held in
/// memory as a whole. Whoever wants no ENVI files may remove these afterwards.
///
///     _radiance.img  _error.img  _dn.img  _place.img (latitude, longitude, height, time)
///
/// @param context  with a geometry; without one nothing is written
/// @param array    index into the camera's arrays
/// @param written  the array's files so far, for the STAC item's list of assets (those that are to
///                 stay; others of the same folder do no harm if they belong to the array)
/// @return         the files written here
/// @throws std::runtime_error when a file cannot be written or GDAL is not there
[[nodiscard]] std::vector<ProductFile> write_geo_products(const ProductContext& context,
                                                          std::size_t array,
                                                          const std::filesystem::path& stem,
                                                          const std::vector<ProductFile>& written);

}  // namespace nadir::sim
