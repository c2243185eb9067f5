#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "atmosphere/table/air_table.hpp"
#include "core/diagnostics.hpp"

namespace nadir::sim {

/// Where tables of the air are kept between runs: the folder that NADIR_CACHE names; else
/// nadir/air in XDG_CACHE_HOME, or in ~/.cache. Empty where the environment names none of them: no
/// cache then.
[[nodiscard]] std::filesystem::path air_cache_folder();

struct AirCacheOptions {
  bool on = true;                ///< off: always made anew, nothing read or written
  std::filesystem::path folder;  ///< empty: air_cache_folder()
  /// Of all tables together. The one used longest ago goes first; the newest always stays.
  std::uint64_t limit_bytes = 2'000'000'000;
};

struct CacheOutcome {
  bool hit = false;
  std::filesystem::path file;  ///< where the table is kept; empty where it is not
};

/// The table that `make` would make, from the cache if it is there.
///
/// A file that is damaged, or was made from other inputs than its name says, is reported and
/// replaced. A folder that cannot be written is a warning: the table is made and used all the same.
/// Several processes may share the folder, and ask for the same table at once.
/// @param key_text  everything that the table depends on, the program's version of the physics
///                  included: tables are told apart by this text's SHA-256
[[nodiscard]] atmosphere::AirTable cached_air_table(
    const std::string& key_text, const std::function<atmosphere::AirTable()>& make,
    Diagnostics& diagnostics, CacheOutcome& outcome, const AirCacheOptions& options = {});

struct AirCacheSize {
  std::uint64_t tables = 0, bytes = 0;
};
/// What lies in the cache.
[[nodiscard]] AirCacheSize air_cache_size(const std::filesystem::path& folder);
/// Removes every table and what interrupted writers left; other files stay. @return what was
/// removed
AirCacheSize clear_air_cache(const std::filesystem::path& folder);

}  // namespace nadir::sim
