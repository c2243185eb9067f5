#include "sim/run/merge_runs.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <system_error>

#include "core/error.hpp"
#include "sim/run/tile_journal.hpp"

namespace nadir::sim {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_merge(const fs::path& folder, std::string message, std::string hint) {
  throw InputError{InputIssue{{folder.string(), 0, 0}, std::move(message), std::move(hint), {}}};
}

using Runs = std::vector<std::unique_ptr<KeptSamples>>;

void check_physics(const KeptSamples& first, const KeptSamples& run) {
  const RunKey &a = first.whose().key, &b = run.whose().key;
  if (a.same_physics(b)) return;
  refuse_merge(run.folder(),
               fmt::format("this run is of another picture than {} (not the same: {})",
                           first.folder().string(), differences(a, b, false)),
               "only runs that differ in their seeds can be merged");
}

/// The seeds of all, in order. Samples of one seed are the same samples: to take them twice would
/// change nothing but make the error look smaller than it is.
std::vector<std::uint64_t> seeds_of(const Runs& runs) {
  std::vector<std::uint64_t> seeds;
  std::map<std::uint64_t, fs::path> owners;
  for (const auto& run : runs) {
    for (const std::uint64_t seed : run->whose().seeds) {
      const auto [owner, is_new] = owners.emplace(seed, run->folder());
      if (!is_new) {
        refuse_merge(run->folder(),
                     fmt::format("this run and {} both have the samples of seed {}: the same "
                                 "samples cannot count twice",
                                 owner->second.string(), seed),
                     "run one of them with another --seed");
      }
      seeds.push_back(seed);
    }
  }
  return seeds;
}

Runs open_runs(const std::vector<fs::path>& folders, const fs::path& output) {
  if (folders.size() < 2) throw InputError{"merging takes the folders of two runs or more"};
  Runs runs;
  for (const fs::path& folder : folders) {
    std::error_code ignored;
    if (fs::equivalent(folder, output, ignored)) {
      refuse_merge(folder, "the merged run cannot be written into one of the runs",
                   "name another folder with --output");
    }
    runs.push_back(std::make_unique<KeptSamples>(folder));
    if (!runs.back()->is_finished()) {
      refuse_merge(folder, "this run was interrupted", "finish it first: run it again");
    }
    check_physics(*runs.front(), *runs.back());
  }
  return runs;
}

}  // namespace

MergedSamples merge_journals(const std::vector<fs::path>& folders, const fs::path& output,
                             Diagnostics& diagnostics) {
  const Runs runs = open_runs(folders, output);
  MergedSamples merged{{runs.front()->whose().key, seeds_of(runs)}, 0, 0};
  fs::create_directories(output);
  TileJournal journal{output,
                      merged.whose.key,
                      {.fresh = true, .only_same = false, .seeds = merged.whose.seeds},
                      diagnostics};
  std::uint32_t all_rounds = 0;
  for (const auto& run : runs) all_rounds += run->rounds();
  journal.begin(all_rounds);
  for (const auto& run : runs) {
    for (const TileKey& key : run->tiles()) {
      TileRecord record = run->read(key);
      record.key.round += merged.rounds;
      if (record.key.round > 0) record.pixels.truth = {};
      journal.keep(record);
      ++merged.tiles;
    }
    merged.rounds += run->rounds();
  }
  journal.mark_finished(merged.rounds);  // the run that writes the products renders nothing
  return merged;
}

RunOutcome merge_runs(const MergeOptions& options) {
  Diagnostics diagnostics;
  const MergedSamples merged = merge_journals(options.runs, options.output, diagnostics);
  if (options.tell) {
    for (const std::string& warning : diagnostics.messages()) options.tell(warning);
    options.tell(fmt::format("merged: {} runs, {} tiles in {} rounds", options.runs.size(),
                             merged.tiles, merged.rounds));
  }
  RunOptions run;
  run.scenario = merged.whose.key.scenario;
  run.output = options.output;
  run.seed = merged.whose.key.seed;
  run.noise_seed = options.noise_seed;
  run.threads = options.threads;
  run.accuracy = merged.whose.key.accuracy;
  run.time_s = merged.whose.key.time_s;
  run.audit = 0;  // the runs had theirs
  run.progress = options.progress;
  run.tell = options.tell;
  return run_scenario(run);
}

}  // namespace nadir::sim
