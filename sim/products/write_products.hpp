#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/diagnostics.hpp"
#include "sensor/detector/signal_chain.hpp"
#include "sim/products/product_geometry.hpp"
#include "sim/products/report.hpp"
#include "sim/run/image.hpp"
#include "sim/scenario/results_input.hpp"

namespace nadir::sim {

/// What the products tell about the run, and which of them are wanted.
struct ProductContext {
  std::string scenario_name;
  std::string title;     ///< for the quick look's caption; the name where it is empty
  std::string time_utc;  ///< ISO 8601, of the scene, not of the computer's clock
  std::string version;
  ProductsInput wanted;
  Diagnostics* diagnostics = nullptr;  ///< gets a warning for each thing the user should know
  const ProductGeometry* geometry = nullptr;  ///< null: files without a place on the earth
  /// Of digital numbers, by array and band; empty where there are none.
  std::vector<std::vector<sensor::Calibration>> calibrations{};
};

/// A file that was written.
struct ProductFile {
  std::string kind;   ///< "radiance", "standard error", "truth", "exr", "quick look", ...
  std::string array;  ///< name of the array
  std::filesystem::path path;
  std::uint64_t bytes = 0;
};

/// Writes what a run delivers, strip by strip, so that memory does not grow with the number of
/// lines; docs/products.md lists the files. The same images and context give the same bytes. A
/// character of the array's name that could upset a file system becomes an underscore.
class ProductWriter {
 public:
  /// @param output_dir  made where it is missing
  ProductWriter(ProductContext context, std::filesystem::path output_dir);
  ~ProductWriter();
  ProductWriter(const ProductWriter&) = delete;
  ProductWriter& operator=(const ProductWriter&) = delete;

  /// The next strip of an array's lines; the first begins with line 0, the last ends the array. One
  /// array after the other.
  /// @throws std::runtime_error when a file cannot be written, std::invalid_argument when planes
  ///         have not the strip's size, strips do not follow each other, or two arrays would write
  ///         the same files
  void take(const ArrayImage& strip);

  /// Ends the files (those that need all lines are made now from those on the disk).
  struct Written {
    std::vector<ProductFile> files;
    std::vector<ArraySummary> summaries;
  };
  [[nodiscard]] Written finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The same for images that are in memory as a whole.
[[nodiscard]] std::vector<ProductFile> write_products(const std::vector<ArrayImage>& images,
                                                      const ProductContext& context,
                                                      const std::filesystem::path& output_dir);

}  // namespace nadir::sim
