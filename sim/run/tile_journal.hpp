#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostics.hpp"
#include "sim/run/journal_file.hpp"
#include "sim/run/run_key.hpp"
#include "sim/run/tile_bytes.hpp"
#include "sim/run/tile_store.hpp"

namespace nadir::sim {

/// Of the journal in a run's folder.
inline constexpr std::string_view journal_name = "samples.nadir";

/// The finished tiles of a run in a file of its folder, which a killed run goes on from, and which
/// `--more` and `nadir merge` extend. docs/resume.md has the format and what is guaranteed.
///
/// A tile is kept by one write before `keep` returns, so that it outlives the process however that
/// ends; every few seconds all is synced to the disc, so that a power cut costs no more.
class TileJournal : public TileStore {
 public:
  struct Options {
    bool fresh = false;      ///< start over, whatever is there
    bool only_same = false;  ///< refuse to start where there are no samples of this run
    /// Of all samples that will be in it, the key's first; empty: the key's alone.
    std::vector<std::uint64_t> seeds{};
  };
  /// Opens the folder's journal. What is damaged is left out, with a warning. Samples of another
  /// run are set aside as samples.nadir.old until `finish`, with a warning; those that were merged
  /// from several runs are not.
  /// @throws InputError where another process is at work there, and as the options say;
  ///         std::runtime_error where the file cannot be read or written
  TileJournal(const std::filesystem::path& folder, const RunKey& key, const Options& options,
              Diagnostics& diagnostics);
  ~TileJournal() override;

  [[nodiscard]] std::optional<TileRecord> find(const TileKey& key) override;
  void keep(const TileRecord& record) override;

  /// Tiles in it; rounds: one more than the greatest that a tile is of.
  [[nodiscard]] std::size_t tiles() const;
  [[nodiscard]] std::uint32_t rounds() const;
  /// Tiles that were there when it was opened.
  [[nodiscard]] std::size_t tiles_at_start() const noexcept { return tiles_at_start_; }

  /// How many rounds a run was last to make, and how many were last made in full; 0: none yet.
  /// Where more were begun than finished, a run was cut off.
  [[nodiscard]] std::uint32_t begun() const;
  [[nodiscard]] std::uint32_t finished() const;
  /// Notes that a run is to make so many rounds.
  void begin(std::uint32_t rounds);
  /// Notes that so many rounds are made; syncs.
  void mark_finished(std::uint32_t rounds);
  /// The same once their products are written: removes what was set aside, too.
  void finish(std::uint32_t rounds);
  /// Removes the file: for runs that are not to be continued. Nothing may be kept after this.
  void discard();

  /// Of all samples in it. More than one: it was merged.
  [[nodiscard]] const std::vector<std::uint64_t>& seeds() const noexcept { return seeds_; }

 private:
  void open(const RunKey& key, const Options& options, Diagnostics& diagnostics);
  void take_up(const JournalScan& scan, Diagnostics& diagnostics);
  void set_aside(const std::string& reason, Diagnostics& diagnostics);
  /// The number of a list of names; a new one is written down. Needs the lock.
  std::uint32_t number_of(const std::vector<std::string>& names);
  void sync_sometimes();

  using Clock = std::chrono::steady_clock;
  std::filesystem::path folder_;
  std::optional<JournalFile> file_;
  std::vector<std::uint64_t> seeds_;
  std::size_t tiles_at_start_ = 0;
  mutable std::mutex mutex_;  // of all below, and of writing
  std::map<TileKey, Frame> tiles_;
  NameLists names_;
  std::uint32_t begun_ = 0, finished_ = 0;
  Clock::time_point synced_ = Clock::now();
};

/// A journal that is only read.
class KeptSamples {
 public:
  /// @throws InputError where the folder has no journal, or a run is at work there
  explicit KeptSamples(const std::filesystem::path& folder);

  [[nodiscard]] const KeyedSeeds& whose() const noexcept { return whose_; }
  [[nodiscard]] std::uint32_t rounds() const noexcept { return rounds_; }
  /// Whether the run that was last at work came to its end.
  [[nodiscard]] bool is_finished() const noexcept { return finished_ > 0 && finished_ >= begun_; }
  /// In the order of keys.
  [[nodiscard]] std::vector<TileKey> tiles() const;
  /// @throws InputError where the tile can no longer be read
  [[nodiscard]] TileRecord read(const TileKey& key) const;
  [[nodiscard]] const std::filesystem::path& folder() const noexcept { return folder_; }

 private:
  std::filesystem::path folder_;
  JournalFile file_;
  KeyedSeeds whose_;
  std::map<TileKey, Frame> tiles_;
  NameLists names_;
  std::uint32_t rounds_ = 0, begun_ = 0, finished_ = 0;
};

}  // namespace nadir::sim
