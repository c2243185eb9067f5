#include "sim/run/air_cache.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "sim/files/air_table_file.hpp"
#include "sim/files/atomic_file.hpp"
#include "sim/files/hash.hpp"

namespace nadir::sim {
namespace {

namespace fs = std::filesystem;
using atmosphere::AirTable;

fs::path from_environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? fs::path{} : fs::path{value};
}

struct Kept {
  fs::path file;
  std::uint64_t bytes = 0;
  fs::file_time_type used;
};

/// A writer's temporary file, which outlives only a writer that was killed.
bool is_left_over(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.starts_with('.') && name.find(".air.") != std::string::npos && name.ends_with(".tmp");
}

/// Another process may remove any of them meanwhile: what cannot be asked is passed over.
template <class Wanted>
std::vector<Kept> files_in(const fs::path& folder, const Wanted& wanted) {
  std::vector<Kept> files;
  std::error_code error;
  for (fs::directory_iterator entry{folder, error}, end; !error && entry != end;
       entry.increment(error)) {
    if (!wanted(entry->path())) continue;
    std::error_code gone;
    const auto bytes = fs::file_size(entry->path(), gone);
    if (gone) continue;
    const auto used = fs::last_write_time(entry->path(), gone);
    if (!gone) files.push_back({entry->path(), bytes, used});
  }
  return files;
}

std::vector<Kept> tables_in(const fs::path& folder) {
  return files_in(folder, [](const fs::path& file) { return file.extension() == ".air"; });
}

AirCacheSize size_of(const std::vector<Kept>& tables) {
  AirCacheSize size;
  for (const Kept& table : tables) {
    ++size.tables;
    size.bytes += table.bytes;
  }
  return size;
}

/// Removes what was used longest ago, until the rest fits; `newest` stays in any case.
void keep_within(std::uint64_t limit_bytes, const fs::path& newest) {
  std::vector<Kept> tables = tables_in(newest.parent_path());
  std::uint64_t bytes = size_of(tables).bytes;
  std::sort(tables.begin(), tables.end(),
            [](const Kept& a, const Kept& b) { return a.used < b.used; });
  std::error_code ignored;
  for (const Kept& table : tables) {
    if (bytes <= limit_bytes) break;
    if (table.file == newest) continue;
    fs::remove(table.file, ignored);
    bytes -= table.bytes;
  }
  // A day: no writer takes that long.
  const auto stale = fs::file_time_type::clock::now() - std::chrono::hours{24};
  for (const Kept& left : files_in(newest.parent_path(), is_left_over)) {
    if (left.used < stale) fs::remove(left.file, ignored);
  }
}

std::optional<AirTable> kept_table(const fs::path& file, const std::string& key,
                                   Diagnostics& diagnostics) {
  std::error_code error;
  if (!fs::exists(file, error)) return std::nullopt;
  try {
    AirTableFile kept = read_air_table(file);
    if (kept.inputs == key) {
      fs::last_write_time(file, fs::file_time_type::clock::now(), error);  // for keep_within
      return std::move(kept.table);
    }
    diagnostics.warn("the kept table of the air " + file.string() +
                     " was made from other inputs; it is made anew");
  } catch (const InputError& damage) {
    // Gone meanwhile: another process made room. Nothing to report.
    if (fs::exists(file, error)) {
      diagnostics.warn("the kept table of the air " + file.string() +
                       " is damaged and made anew: " + damage.issues().front().message);
    }
  }
  return std::nullopt;
}

/// @return whether the table is kept now
bool keep(const fs::path& file, const std::string& bytes, Diagnostics& diagnostics) {
  try {
    fs::create_directories(file.parent_path());
    write_file(file, bytes);
    return true;
  } catch (const std::runtime_error& error) {  // of the file system, or of the writer
    diagnostics.warn(std::string{"the table of the air is not kept for later runs: "} +
                     error.what());
    return false;
  }
}

}  // namespace

fs::path air_cache_folder() {
  if (fs::path named = from_environment("NADIR_CACHE"); !named.empty()) return named;
  // Relative paths in it are to be ignored: XDG Base Directory Specification 0.8.
  if (const fs::path base = from_environment("XDG_CACHE_HOME"); base.is_absolute()) {
    return base / "nadir" / "air";
  }
  const fs::path home = from_environment("HOME");
  return home.empty() ? fs::path{} : home / ".cache" / "nadir" / "air";
}

AirTable cached_air_table(const std::string& key_text, const std::function<AirTable()>& make,
                          Diagnostics& diagnostics, CacheOutcome& outcome,
                          const AirCacheOptions& options) {
  outcome = {};
  const fs::path folder = options.folder.empty() ? air_cache_folder() : options.folder;
  if (!options.on || folder.empty()) return make();
  const std::string key = digest_bytes(key_text).sha256;
  const fs::path file = folder / (key + ".air");
  if (auto table = kept_table(file, key, diagnostics)) {
    outcome = {true, file};
    return *std::move(table);
  }
  AirTableFile made{make(), key};
  if (keep(file, air_table_bytes(made), diagnostics)) {
    outcome.file = file;
    keep_within(options.limit_bytes, file);
  }
  return std::move(made.table);
}

AirCacheSize air_cache_size(const fs::path& folder) { return size_of(tables_in(folder)); }

AirCacheSize clear_air_cache(const fs::path& folder) {
  std::vector<Kept> removed;
  std::error_code error;
  for (const Kept& table : tables_in(folder)) {
    if (fs::remove(table.file, error)) removed.push_back(table);
  }
  for (const Kept& left : files_in(folder, is_left_over)) fs::remove(left.file, error);
  return size_of(removed);
}

}  // namespace nadir::sim
