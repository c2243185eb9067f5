#include "sim/run/tile_journal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "sim/files/packed_bytes.hpp"
#include "sim/files/stale_files.hpp"

namespace nadir::sim {
namespace {

// What a power cut may cost. A sync of what some seconds write takes a fraction of one.
constexpr std::chrono::seconds between_syncs{5};

TileKey rounds_key(std::uint32_t rounds) { return {rounds, 0, 0, 0, 0, 0}; }

/// Whose samples a scan found; nothing where its first frame does not say.
std::optional<KeyedSeeds> whose(const JournalFile& file, const JournalScan& scan) {
  if (scan.frames.empty() || scan.frames.front().kind != FrameKind::header) return std::nullopt;
  const auto text = file.read(scan.frames.front());
  return text ? keyed_seeds_from(*text) : std::nullopt;
}

/// What a journal's frames come to.
struct JournalIndex {
  std::map<TileKey, Frame> tiles;
  NameLists names;
  std::uint32_t begun = 0, finished = 0;
};

void index_frame(const JournalFile& file, const Frame& frame, JournalIndex& index) {
  switch (frame.kind) {
    case FrameKind::names:
      if (const auto bytes = file.read(frame)) {
        if (auto names = names_from_bytes(*bytes)) {
          index.names[frame.key.round] = std::move(*names);
        }
      }
      return;
    case FrameKind::tile:
      index.tiles[frame.key] = frame;
      return;
    case FrameKind::begun:
      index.begun = frame.key.round;
      return;
    case FrameKind::finished:
      index.finished = frame.key.round;
      return;
    case FrameKind::header:
      return;
  }
}

JournalIndex index_of(const JournalFile& file, const JournalScan& scan) {
  JournalIndex index;
  for (const Frame& frame : scan.frames) index_frame(file, frame, index);
  return index;
}

bool has_tiles(const JournalScan& scan) {
  return std::any_of(scan.frames.begin(), scan.frames.end(),
                     [](const Frame& frame) { return frame.kind == FrameKind::tile; });
}

std::uint32_t rounds_of(const std::map<TileKey, Frame>& tiles) {
  return tiles.empty() ? 0 : tiles.rbegin()->first.round + 1;  // keys are in the order of rounds
}

/// samples.nadir.old, or with a number behind it: the first that is free.
std::filesystem::path aside_name(const std::filesystem::path& journal, int number) {
  std::filesystem::path name = journal;
  name += number == 1 ? ".old" : fmt::format(".old{}", number);
  return name;
}

std::filesystem::path free_aside_name(const std::filesystem::path& journal) {
  int number = 1;
  while (std::filesystem::exists(aside_name(journal, number))) ++number;
  return aside_name(journal, number);
}

/// There is nothing that could be gone on from, and what there is must not make room.
[[noreturn]] void refuse_others(const std::filesystem::path& file,
                                const std::optional<KeyedSeeds>& found, const RunKey& wanted) {
  const std::string where = file.string();
  if (!found) {
    throw InputError{InputIssue{{where, 0, 0},
                                "there are no samples of a run here that more could be added to",
                                "run the scenario first",
                                {}}};
  }
  throw InputError{
      InputIssue{{where, 0, 0},
                 fmt::format("the samples here are of another run{} (not the same: {})",
                             found->seeds.size() > 1 ? ", merged from several" : "",
                             differences(found->key, wanted, true)),
                 "name another folder with --output, or start over with --fresh",
                 {}}};
}

}  // namespace

TileJournal::TileJournal(const std::filesystem::path& folder, const RunKey& key,
                         const Options& options, Diagnostics& diagnostics)
    : folder_{folder}, seeds_{options.seeds} {
  if (seeds_.empty()) seeds_ = {key.seed};
  open(key, options, diagnostics);
  tiles_at_start_ = tiles_.size();
}

TileJournal::~TileJournal() = default;

void TileJournal::open(const RunKey& key, const Options& options, Diagnostics& diagnostics) {
  file_.emplace(folder_ / journal_name, JournalFile::Access::write);
  remove_stale_temporaries(folder_);
  const JournalScan scan = file_->scan();
  const auto found = whose(*file_, scan);
  if (found && !options.fresh && found->key.same_samples(key)) {
    seeds_ = found->seeds;
    take_up(scan, diagnostics);
    return;
  }
  const bool merged = found && found->seeds.size() > 1 && !options.fresh;
  if (options.only_same || merged) refuse_others(file_->path(), found, key);
  if (has_tiles(scan) || (scan.size > 0 && scan.end == 0)) {
    set_aside(!found          ? "is not a journal that this version reads"
              : options.fresh ? "holds samples of a former run"
                              : fmt::format("holds samples of another run (not the same: {})",
                                            differences(found->key, key, true)),
              diagnostics);
  }
  file_->start_anew(frame_bytes(FrameKind::header, {}, to_json({key, seeds_})));
}

void TileJournal::take_up(const JournalScan& scan, Diagnostics& diagnostics) {
  if (scan.torn() > 0) {
    diagnostics.warn(
        fmt::format("{}: the last {} bytes are of a tile that was not finished: cut off",
                    file_->path().string(), scan.torn()));
    file_->cut_at(scan.end);
  }
  if (scan.damaged > 0) {
    diagnostics.warn(fmt::format("{}: {} bytes are damaged: the tiles in them are made again",
                                 file_->path().string(), scan.damaged));
  }
  JournalIndex index = index_of(*file_, scan);
  tiles_ = std::move(index.tiles);
  names_ = std::move(index.names);
  begun_ = index.begun;
  finished_ = index.finished;
}

void TileJournal::set_aside(const std::string& reason, Diagnostics& diagnostics) {
  const std::filesystem::path aside = free_aside_name(folder_ / journal_name);
  diagnostics.warn(fmt::format("{} {}: kept as {} until this run is finished",
                               (folder_ / journal_name).string(), reason,
                               aside.filename().string()));
  file_->rename(aside);
  file_.emplace(folder_ / journal_name, JournalFile::Access::write);
}

std::optional<TileRecord> TileJournal::find(const TileKey& key) {
  Frame frame;
  {
    const std::scoped_lock lock{mutex_};
    const auto found = tiles_.find(key);
    if (found == tiles_.end()) return std::nullopt;
    frame = found->second;
  }
  const auto bytes = file_->read(frame);
  if (!bytes) return std::nullopt;
  const std::scoped_lock lock{mutex_};  // of the names
  auto record = tile_from_bytes(*bytes, names_);
  if (record && record->key != key) record.reset();
  return record;
}

void TileJournal::keep(const TileRecord& record) {
  TileNames names;
  {
    const std::scoped_lock lock{mutex_};
    names.materials = number_of(record.pixels.truth.material_names);
    names.objects = number_of(record.pixels.truth.object_names);
  }
  const std::string frame = frame_bytes(FrameKind::tile, record.key, to_bytes(record, names));
  {
    const std::scoped_lock lock{mutex_};
    tiles_[record.key] = file_->append(frame);
  }
  sync_sometimes();
}

std::uint32_t TileJournal::number_of(const std::vector<std::string>& names) {
  if (names.empty()) return 0;
  for (const auto& [number, known] : names_) {
    if (known == names) return number;
  }
  const std::string bytes = to_bytes(names);
  // By content, so that a list that was lost to damage comes back under its number.
  std::uint32_t number = std::max(checksum(bytes), 1U);
  while (names_.contains(number)) ++number;
  static_cast<void>(file_->append(frame_bytes(FrameKind::names, rounds_key(number), bytes)));
  names_[number] = names;
  return number;
}

void TileJournal::sync_sometimes() {
  {
    const std::scoped_lock lock{mutex_};
    if (Clock::now() - synced_ < between_syncs) return;
    synced_ = Clock::now();
  }
  file_->sync();  // outside the lock: the others go on meanwhile
}

std::size_t TileJournal::tiles() const {
  const std::scoped_lock lock{mutex_};
  return tiles_.size();
}

std::uint32_t TileJournal::rounds() const {
  const std::scoped_lock lock{mutex_};
  return rounds_of(tiles_);
}

std::uint32_t TileJournal::begun() const {
  const std::scoped_lock lock{mutex_};
  return begun_;
}

std::uint32_t TileJournal::finished() const {
  const std::scoped_lock lock{mutex_};
  return finished_;
}

void TileJournal::begin(std::uint32_t rounds) {
  const std::scoped_lock lock{mutex_};
  static_cast<void>(file_->append(frame_bytes(FrameKind::begun, rounds_key(rounds), {})));
  begun_ = rounds;
}

void TileJournal::mark_finished(std::uint32_t rounds) {
  {
    const std::scoped_lock lock{mutex_};
    static_cast<void>(file_->append(frame_bytes(FrameKind::finished, rounds_key(rounds), {})));
    finished_ = rounds;
  }
  file_->sync();
}

void TileJournal::finish(std::uint32_t rounds) {
  mark_finished(rounds);
  for (int number = 1; std::filesystem::remove(aside_name(folder_ / journal_name, number));) {
    ++number;
  }
}

void TileJournal::discard() { std::filesystem::remove(file_->path()); }

KeptSamples::KeptSamples(const std::filesystem::path& folder)
    : folder_{folder},
      file_{[&] {
              if (std::filesystem::exists(folder / journal_name)) return folder / journal_name;
              throw InputError{
                  InputIssue{{folder.string(), 0, 0},
                             fmt::format("there are no samples of a run here ({})", journal_name),
                             "runs keep them unless <products keep_samples=\"false\"/>",
                             {}}};
            }(),
            JournalFile::Access::read} {
  const JournalScan scan = file_.scan();
  auto found = sim::whose(file_, scan);
  if (!found) {
    throw InputError{InputIssue{{file_.path().string(), 0, 0},
                                "this is not a journal of samples that this version reads",
                                {},
                                {}}};
  }
  whose_ = std::move(*found);
  JournalIndex index = index_of(file_, scan);
  tiles_ = std::move(index.tiles);
  names_ = std::move(index.names);
  begun_ = index.begun;
  finished_ = index.finished;
  rounds_ = rounds_of(tiles_);
}

std::vector<TileKey> KeptSamples::tiles() const {
  std::vector<TileKey> keys;
  for (const auto& [key, frame] : tiles_) keys.push_back(key);
  return keys;
}

TileRecord KeptSamples::read(const TileKey& key) const {
  const auto bytes = file_.read(tiles_.at(key));
  auto record = bytes ? tile_from_bytes(*bytes, names_) : std::nullopt;
  if (!record) {
    throw InputError{InputIssue{{file_.path().string(), 0, 0},
                                "a tile of this journal cannot be read",
                                "run the scenario into this folder again: what is missing is made",
                                {}}};
  }
  return *record;
}

}  // namespace nadir::sim
