#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/products/geo_task.hpp"

namespace nadir::sim {

/// Image support data for the community sensor model (CSM) of USGS: the frame or the line scanner
/// model, in the form that ALE writes and usgscsm reads; docs/geometry-products.md.
/// @param band    index; bands of an array differ by name only
/// @param module  index, of an array that is made of modules: the image is then the module's part
/// @return        JSON text
/// @throws InputError with the reason where the model cannot say what the array does
[[nodiscard]] std::string csm_isd(const GeoTask& task, std::size_t band, std::size_t module = 0);

/// One file a band, and module of an array that is made of them; none, and one warning, where the
/// model cannot say what the array does.
[[nodiscard]] std::vector<ProductFile> write_csm_isds(const GeoTask& task);

}  // namespace nadir::sim
