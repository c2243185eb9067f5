#include "sim/run/air_cache.hpp"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <thread>
#include <vector>

#include "air_table_support.hpp"
#include "message_of.hpp"
#include "scratch_folder.hpp"
#include "sim/files/air_table_file.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
namespace fs = std::filesystem;

namespace {

/// A cache of one test, and how often a table had to be made.
struct Cache {
  support::ScratchFolder scratch;
  AirCacheOptions options{true, scratch / "air"};
  Diagnostics diagnostics;
  std::atomic<int> made{0};

  CacheOutcome get(const std::string& key) {
    CacheOutcome outcome;
    const auto table = cached_air_table(
        key,
        [&] {
          ++made;
          atmosphere::AirTable fresh = support::some_table();
          fresh.made_by = key;
          return fresh;
        },
        diagnostics, outcome, options);
    CHECK(table.made_by == key);
    return outcome;
  }
  [[nodiscard]] std::vector<std::string> messages() const { return diagnostics.messages(); }
};

/// Sets a variable of the environment for a while.
class Environment {
 public:
  Environment(const char* name, const char* value) : name_{name} {
    if (const char* before = std::getenv(name)) before_ = before;
    value == nullptr ? ::unsetenv(name) : ::setenv(name, value, 1);
  }
  ~Environment() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

}  // namespace

TEST_CASE("a table is made once and found again", "[air_cache]") {
  Cache cache;
  const CacheOutcome first = cache.get("a");
  CHECK_FALSE(first.hit);
  CHECK(fs::exists(first.file));
  const CacheOutcome again = cache.get("a");
  CHECK(again.hit);
  CHECK(again.file == first.file);
  CHECK_FALSE(cache.get("b").hit);
  CHECK(cache.made == 2);
  CHECK(cache.messages().empty());
  CHECK(air_cache_size(cache.options.folder).tables == 2);
}

TEST_CASE("without the cache tables are made each time and nothing is kept", "[air_cache]") {
  Cache cache;
  cache.options.on = false;
  CHECK(cache.get("a").file.empty());
  CHECK_FALSE(cache.get("a").hit);
  CHECK(cache.made == 2);
  CHECK_FALSE(fs::exists(cache.options.folder));
}

TEST_CASE("a damaged table is told, made anew and replaced", "[air_cache]") {
  const std::string damage = GENERATE("empty", "cut", "flipped", "other file");
  Cache cache;
  const fs::path file = cache.get("a").file;
  std::string bytes = support::content_of(file);
  if (damage == "empty") bytes.clear();
  if (damage == "cut") bytes.resize(bytes.size() / 2);
  if (damage == "flipped") bytes[bytes.size() - 5] = static_cast<char>(bytes[bytes.size() - 5] ^ 1);
  if (damage == "other file") bytes = "hello";
  std::ofstream{file, std::ios::binary} << bytes;
  CAPTURE(damage);
  CHECK_FALSE(cache.get("a").hit);
  REQUIRE(cache.messages().size() == 1);
  CHECK(cache.messages()[0].starts_with("the kept table of the air " + file.string() +
                                        " is damaged and made anew: "));
  CHECK(cache.get("a").hit);
  CHECK(cache.made == 2);
}

TEST_CASE("a table under a foreign name is not taken", "[air_cache]") {
  Cache cache;
  const fs::path a = cache.get("a").file, b = cache.get("b").file;
  fs::copy_file(a, b, fs::copy_options::overwrite_existing);
  CHECK_FALSE(cache.get("b").hit);
  CHECK(cache.messages() ==
        std::vector<std::string>{"the kept table of the air " + b.string() +
                                 " was made from other inputs; it is made anew"});
  CHECK(cache.get("b").hit);
}

// A folder below a plain file can be made by nobody, root included.
TEST_CASE("a cache that cannot be written is a warning, never a failure", "[air_cache]") {
  Cache cache;
  std::ofstream{cache.scratch / "file"} << "x";
  cache.options.folder = cache.scratch / "file" / "air";
  const CacheOutcome outcome = cache.get("a");
  CHECK(outcome.file.empty());
  REQUIRE(cache.messages().size() == 1);
  CHECK(cache.messages()[0].starts_with("the table of the air is not kept for later runs: "));
}

TEST_CASE("what fails to be made fails, and leaves nothing in the cache", "[air_cache]") {
  Cache cache;
  CacheOutcome outcome;
  const auto fails = [&]() -> atmosphere::AirTable { throw std::runtime_error{"no air"}; };
  CHECK(support::message_of([&] {
          static_cast<void>(
              cached_air_table("a", fails, cache.diagnostics, outcome, cache.options));
        }) == "no air");
  CHECK(air_cache_size(cache.options.folder).tables == 0);
}

TEST_CASE("writers and readers of one table do not disturb each other", "[air_cache]") {
  Cache cache;
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int round = 0; round < 8; ++round) {
        CacheOutcome outcome;
        const auto table = cached_air_table(
            "a", [] { return support::some_table(); }, cache.diagnostics, outcome, cache.options);
        if (table.lanes.size() != 3) ++wrong;
        if (round % 3 == 2) clear_air_cache(cache.options.folder);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(wrong == 0);
}

TEST_CASE("the tables used longest ago make room", "[air_cache]") {
  Cache cache;
  const fs::path a = cache.get("a").file, b = cache.get("b").file;
  const auto hours_ago = [](int hours) {
    return fs::file_time_type::clock::now() - std::chrono::hours{hours};
  };
  fs::last_write_time(a, hours_ago(3));
  fs::last_write_time(b, hours_ago(2));
  CHECK(cache.get("a").hit);  // now b was used longest ago
  cache.options.limit_bytes = 2 * fs::file_size(a) + 100;
  const fs::path c = cache.get("c").file;
  CHECK(fs::exists(a));
  CHECK_FALSE(fs::exists(b));
  CHECK(fs::exists(c));
  cache.options.limit_bytes = 1;
  const fs::path d = cache.get("d").file;
  CHECK(fs::exists(d));
  CHECK(air_cache_size(cache.options.folder).tables == 1);
}

TEST_CASE("clearing the cache removes its files and no others", "[air_cache]") {
  Cache cache;
  cache.get("a");
  cache.get("b");
  std::ofstream{cache.options.folder / "mine.txt"} << "x";
  std::ofstream{cache.options.folder / ".k.air.12-0.tmp"} << "left by a writer that was killed";
  const AirCacheSize removed = clear_air_cache(cache.options.folder);
  CHECK(removed.tables == 2);
  CHECK(removed.bytes > 2000);
  CHECK(fs::exists(cache.options.folder / "mine.txt"));
  CHECK_FALSE(fs::exists(cache.options.folder / ".k.air.12-0.tmp"));
  CHECK(clear_air_cache(cache.scratch / "none").tables == 0);
}

TEST_CASE("the cache lies where the environment says", "[air_cache]") {
  const Environment home{"HOME", "/home/somebody"};
  {
    const Environment named{"NADIR_CACHE", "/n"}, xdg{"XDG_CACHE_HOME", "/x"};
    CHECK(air_cache_folder() == "/n");
  }
  const Environment named{"NADIR_CACHE", nullptr};
  {
    const Environment xdg{"XDG_CACHE_HOME", "/x"};
    CHECK(air_cache_folder() == "/x/nadir/air");
  }
  {
    const Environment xdg{"XDG_CACHE_HOME", "relative"};
    CHECK(air_cache_folder() == "/home/somebody/.cache/nadir/air");
  }
  const Environment xdg{"XDG_CACHE_HOME", nullptr};
  const Environment nobody{"HOME", nullptr};
  CHECK(air_cache_folder().empty());
}
