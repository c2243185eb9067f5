#pragma once

#include <filesystem>

#include "sim/products/write_products.hpp"
#include "sim/run/image.hpp"

namespace nadir::sim {

/// `stem` is the path without the part of the name that tells the products apart.
/// Radiance, standard error and, if wanted, truth as ENVI files.
void write_array_envi(const ArrayImage& image, const ProductContext& context,
                      const std::filesystem::path& stem, std::vector<ProductFile>& written);

/// All planes in one EXR.
void write_array_exr(const ArrayImage& image, const ProductContext& context,
                     const std::filesystem::path& stem, std::vector<ProductFile>& written);

/// The stem with an ending: `out/oli` and `_error.img` make `out/oli_error.img`.
[[nodiscard]] inline std::filesystem::path with_ending(std::filesystem::path stem,
                                                       const char* ending) {
  return stem += ending;
}

}  // namespace nadir::sim
