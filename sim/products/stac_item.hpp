#pragma once

#include <string>
#include <vector>

#include "sim/products/geo_task.hpp"
#include "sim/products/geotiff.hpp"

namespace nadir::sim {

/// The array's image as a STAC item (1.1.0) with the extensions eo, view, raster, and proj and sat
/// where they apply: what a catalogue of scenes needs to find it. JSON text.
/// @param files  of the array, its assets
[[nodiscard]] std::string stac_item(const GeoTask& task, const Georeference& georeference,
                                    const std::vector<ProductFile>& files);

/// One file an array.
[[nodiscard]] std::vector<ProductFile> write_stac_item(const GeoTask& task,
                                                       const Georeference& georeference,
                                                       const std::vector<ProductFile>& files);

}  // namespace nadir::sim
