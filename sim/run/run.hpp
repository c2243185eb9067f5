#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/products/report.hpp"
#include "sim/products/write_products.hpp"

namespace nadir::sim {

struct RunOptions {
  std::filesystem::path scenario;
  std::filesystem::path output;  ///< folder of the products; made where it is missing
  std::uint64_t seed = 1;
  std::uint64_t noise_seed = 1;    ///< of the detectors' noise, apart from the render's
  int threads = 0;                 ///< 0: one per processor
  std::optional<double> accuracy;  ///< relative standard error to be reached
  std::optional<double> time_s;    ///< wall clock that the run may take
  std::optional<int> audit;        ///< pixels; 0: no audit; none: as many as 3 % of the run pay for
  bool more = false;               ///< adds as many samples again to a finished run
  bool fresh = false;              ///< forgets what an interrupted or finished run has left
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< tiles rendered
  std::function<void(const std::string&)> tell;  ///< what the user should know before the end
};

struct RunOutcome {
  RunReport report;
  std::filesystem::path report_file;
  /// What was promised and not kept, one sentence each; empty: all was kept.
  std::vector<std::string> broken_promises;
};

/// Runs a scenario from its file to its products and its report. Tiles that an interrupted run of
/// the same scenario and options has left in the folder are not rendered again.
/// @throws InputError for mistakes in the scenario or in a file that it names, before anything is
///         rendered or written; std::runtime_error where a product cannot be written
[[nodiscard]] RunOutcome run_scenario(const RunOptions& options);

/// What a scenario's check found.
struct Validation {
  std::string name;
  std::size_t objects = 0, materials = 0, arrays = 0, bands = 0;
  std::uint64_t stored_primitives = 0, represented_primitives = 0;
  std::vector<std::string> warnings;
};

/// Reads a scenario and everything that it names, as a run would, and renders nothing.
/// @throws InputError with every mistake found
[[nodiscard]] Validation validate_scenario(const std::filesystem::path& scenario);

}  // namespace nadir::sim
