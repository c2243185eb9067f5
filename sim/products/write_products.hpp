#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/diagnostics.hpp"
#include "sim/run/image.hpp"

namespace nadir::sim {

/// What the products tell about the run, and which of them are wanted.
struct ProductContext {
  std::string scenario_name;
  std::string title;     ///< for the quick look's caption; the name where it is empty
  std::string time_utc;  ///< ISO 8601, of the scene, not of the computer's clock
  std::string version;
  bool envi = true, exr = true, quick_look = true, truth = true;
  std::vector<std::string> quick_look_bands;
  Diagnostics* diagnostics = nullptr;  ///< gets a warning for each thing the user should know
};

/// A file that was written.
struct ProductFile {
  std::string kind;   ///< "radiance", "standard error", "truth", "material", "exr", "quick look"
  std::string array;  ///< name of the array
  std::filesystem::path path;
  std::uint64_t bytes = 0;
};

/// Writes into `output_dir`, which is made where it is missing, for each array:
///
///     <array>_radiance.img/.hdr   <array>_error.img/.hdr              ENVI, float32
///     <array>_truth.img/.hdr      <array>_material.img/.hdr           ENVI, float32 and uint32
///     <array>.exr                 all planes in one file
///     <array>.png                 quick look
///
/// The same images and context give the same bytes. A character of the array's name that could
/// upset a file system becomes an underscore.
/// @throws std::runtime_error when a file cannot be written, std::invalid_argument when planes
///         have not the array's size or two arrays would write the same files.
[[nodiscard]] std::vector<ProductFile> write_products(const std::vector<ArrayImage>& images,
                                                      const ProductContext& context,
                                                      const std::filesystem::path& output_dir);

}  // namespace nadir::sim
