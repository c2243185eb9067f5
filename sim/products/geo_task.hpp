#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/products/write_products.hpp"

namespace nadir::sim {

/// An array whose image is to be placed on the earth.
struct GeoTask {
  const ProductContext* context = nullptr;
  const ProductGeometry* geometry = nullptr;
  const sensor::DetectorArray* array = nullptr;
  std::size_t number = 0;      ///< of the array in the camera
  std::filesystem::path stem;  ///< of its files

  [[nodiscard]] std::filesystem::path with(const std::string& ending) const {
    return std::filesystem::path{stem} += ending;
  }
  [[nodiscard]] ProductFile record(const char* kind, const std::filesystem::path& file) const {
    return {kind, array->name, file, std::filesystem::file_size(file)};
  }
  void warn(const std::string& message) const {
    if (context->diagnostics != nullptr) {
      context->diagnostics->warn("array " + array->name + ": " + message);
    }
  }
};

/// What a band is called, where it lies and how wide it is.
struct BandFigures {
  std::string name;
  double centre_um = 0.0, fwhm_um = 0.0;
};
[[nodiscard]] std::vector<BandFigures> band_figures(const sensor::DetectorArray& array);

inline constexpr const char* radiance_unit = "W m-2 sr-1 um-1";

}  // namespace nadir::sim
