#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/products/geo_task.hpp"

namespace nadir::sim {

/// Image support data for the community sensor model (CSM) of USGS: the frame or the line scanner
/// model, in the form that ALE writes and usgscsm reads; docs/geometry-products.md.
/// @param band  index; bands of an array differ by name only
/// @return      JSON text
/// @throws InputError with the reason where the model cannot say what the array does
[[nodiscard]] std::string csm_isd(const GeoTask& task, std::size_t band);

/// One file a band; none, and one warning, where the model cannot say what the array does.
[[nodiscard]] std::vector<ProductFile> write_csm_isds(const GeoTask& task);

}  // namespace nadir::sim
