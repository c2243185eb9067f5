#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "sim/products/write_products.hpp"
#include "sim/run/detect.hpp"
#include "sim/run/render.hpp"
#include "sim/run/world.hpp"

namespace nadir::sim {

/// Hands strips to a sink as StripSink wants them: rendered, or read back and merged.
using StripSource = std::function<void(const StripSink&)>;

struct ImagingOptions {
  std::filesystem::path output;
  std::uint64_t noise_seed = 1;  ///< of the detectors' noise
};

/// Lets the detectors count what the strips bring, and writes the products as they come. Nothing of
/// it depends on where the strips come from.
class Imaging {
 public:
  /// @param scenario, world, diagnostics  must outlive this
  Imaging(const Scenario& scenario, const World& world, const ImagingOptions& options,
          Diagnostics& diagnostics);

  /// Takes all strips. @param source  of every line of every array
  void take(const StripSource& source);
  /// Ends the files.
  [[nodiscard]] ProductWriter::Written finish();

 private:
  ProductGeometry geometry_;
  DetectorStage detectors_;
  ProductWriter writer_;
};

/// Finds out before the work, not after it, whether its results can be kept: makes the folder, and
/// loads the modules that write what is wanted (half a second that a run with a time limit has to
/// know of).
/// @throws InputError; std::runtime_error where a module is missing
void prepare_output(const std::filesystem::path& folder, const ProductsInput& wanted);

/// The files that were read, with their digests.
[[nodiscard]] std::vector<FileRecord> record_inputs(const InputFiles& inputs,
                                                    const Scenario& scenario);

}  // namespace nadir::sim
