#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/diagnostics.hpp"
#include "sim/run/run.hpp"
#include "sim/run/run_key.hpp"

namespace nadir::sim {

/// The samples of several runs in one journal.
struct MergedSamples {
  KeyedSeeds whose;          ///< the first run's key, the seeds of all
  std::uint32_t rounds = 0;  ///< of all together: those of each run numbered on
  std::size_t tiles = 0;
};

/// Puts the samples of finished runs of one picture with different seeds into the journal of
/// another folder. A round of one run becomes a round of the merged one, so that it can be extended
/// and merged again. The truth is the first run's.
/// @param runs    folders, at least two
/// @param output  another folder; made where it is missing
/// @throws InputError where runs are not of one picture, share a seed or are not finished;
///         std::runtime_error where a file cannot be written
[[nodiscard]] MergedSamples merge_journals(const std::vector<std::filesystem::path>& runs,
                                           const std::filesystem::path& output,
                                           Diagnostics& diagnostics);

struct MergeOptions {
  std::vector<std::filesystem::path> runs;
  std::filesystem::path output;
  std::uint64_t noise_seed = 1;                                     ///< of the detectors' noise
  int threads = 0;                                                  ///< 0: one per processor
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< tiles merged
  std::function<void(const std::string&)> tell;  ///< what the user should know before the end
};

/// Merges the samples, then writes products and report as a run does, rendering nothing.
/// @throws as `merge_journals` and `run_scenario`; InputError where the scenario or a file that it
///         names is no longer what the runs had
[[nodiscard]] RunOutcome merge_runs(const MergeOptions& options);

}  // namespace nadir::sim
