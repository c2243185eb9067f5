#include "sim/run/tile_journal.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <fstream>
#include <string>
#include <thread>

#include "core/error.hpp"
#include "sim/kept_samples.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

namespace fs = std::filesystem;
using support::same_bits;
using support::ScratchFolder;
using support::some_key;

TileKey tile_at(int first_sample, std::uint32_t round = 0) {
  return {round, 0, first_sample, 32, 3, 2};
}

/// A journal opened, and what it had to say.
struct Opened {
  Diagnostics diagnostics;
  TileJournal journal;
  explicit Opened(const ScratchFolder& folder, const RunKey& key = some_key(),
                  const TileJournal::Options& options = {})
      : journal{folder.path(), key, options, diagnostics} {}
};

/// A journal with tiles at samples 0, 3, 6, ...
void fill(const ScratchFolder& folder, int tiles, const RunKey& key = some_key()) {
  Opened opened{folder, key};
  support::TileMaker maker;
  for (int i = 0; i < tiles; ++i) opened.journal.keep(maker(tile_at(3 * i)));
}

void write_tile_journal(const fs::path& file, const std::string& content) {
  std::ofstream{file, std::ios::binary} << content;
}

void check_same_band(const BandImage& a, const BandImage& b) {
  CHECK(a.name == b.name);
  CHECK(a.centre_um == b.centre_um);
  CHECK(a.fwhm_um == b.fwhm_um);
  for (auto plane :
       {&BandImage::radiance, &BandImage::standard_error, &BandImage::brightness_temperature,
        &BandImage::brightness_temperature_error, &BandImage::bias}) {
    CHECK(same_bits(a.*plane, b.*plane));
  }
  CHECK(same_bits(a.shares.path, b.shares.path));
  CHECK(same_bits(a.shares.emission, b.shares.emission));
  CHECK((b.dn.empty() && b.electrons.empty() && b.noise.empty()));
}

void check_same_truth(const TruthImage& a, const TruthImage& b) {
  CHECK(a.material_names == b.material_names);
  CHECK(a.object_names == b.object_names);
  CHECK(a.material == b.material);
  CHECK(a.object == b.object);
  for (const auto& plane : truth_planes) {
    CAPTURE(plane.name);
    CHECK(same_bits(a.*plane.values, b.*plane.values));
  }
  for (const auto& plane : place_planes) {
    CAPTURE(plane.name);
    CHECK(same_bits(a.*plane.values, b.*plane.values));
  }
  REQUIRE(a.fractions.size() == b.fractions.size());
  for (std::size_t i = 0; i < a.fractions.size(); ++i) {
    CHECK(same_bits(a.fractions[i], b.fractions[i]));
  }
}

void check_same(const TileRecord& a, const TileRecord& b) {
  CHECK(a.key == b.key);
  const ArrayImage &x = a.pixels, &y = b.pixels;
  CHECK(x.name == y.name);
  CHECK(x.samples == y.samples);
  CHECK(x.lines == y.lines);
  CHECK(x.first_sample == y.first_sample);
  CHECK(x.first_line == y.first_line);
  CHECK(x.all_lines == y.all_lines);
  CHECK(x.paths == y.paths);
  CHECK(x.pixel_paths == y.pixel_paths);
  REQUIRE(x.bands.size() == y.bands.size());
  for (std::size_t i = 0; i < x.bands.size(); ++i) check_same_band(x.bands[i], y.bands[i]);
  check_same_truth(x.truth, y.truth);
  CHECK(std::memcmp(&a.counters, &b.counters, sizeof a.counters) == 0);
}

TEST_CASE("every plane of a tile comes back bit by bit", "[sim][journal]") {
  const ScratchFolder folder;
  support::TileMaker maker;
  TileRecord full = maker(tile_at(0));
  full.pixels.bands[0].dn.assign(full.pixels.pixels(), 9);  // the detectors' is not kept
  full.pixels.bands[0].electrons.assign(full.pixels.pixels(), 9.0F);
  full.pixels.bands[0].noise.assign(full.pixels.pixels(), 9.0F);
  TileRecord bare;  // planes that nobody asked for stay empty
  bare.key = tile_at(3, 2);
  {
    Opened opened{folder};
    opened.journal.keep(full);
    opened.journal.keep(bare);
    check_same(full, opened.journal.find(full.key).value());  // while it is written as well
  }
  Opened opened{folder};
  CHECK(opened.diagnostics.messages().empty());
  CHECK(opened.journal.tiles_at_start() == 2);
  CHECK(opened.journal.rounds() == 3);
  check_same(full, opened.journal.find(full.key).value());
  check_same(bare, opened.journal.find(bare.key).value());
  CHECK_FALSE(opened.journal.find(tile_at(1)));
}

TEST_CASE("names that tiles have in common are stored once", "[sim][journal]") {
  const ScratchFolder folder;
  support::TileMaker maker;
  TileRecord record = maker(tile_at(0));
  for (int i = 0; i < 500; ++i) {
    record.pixels.truth.object_names.push_back("house " + std::to_string(i * i));
  }
  Opened opened{folder};
  opened.journal.keep(record);
  const auto once = fs::file_size(folder / "samples.nadir");
  record.key = tile_at(3);
  opened.journal.keep(record);
  CHECK(fs::file_size(folder / "samples.nadir") - once < once / 2);
  CHECK(opened.journal.find(tile_at(3))->pixels.truth.object_names ==
        record.pixels.truth.object_names);
}

TEST_CASE("a journal cut off at any byte of its last tile has all tiles before it",
          "[sim][journal]") {
  const ScratchFolder folder;
  fill(folder, 2);
  const fs::path file = folder / "samples.nadir";
  const auto two = fs::file_size(file);
  fill(folder, 0);  // opened once more: unchanged
  REQUIRE(fs::file_size(file) == two);
  {
    Opened opened{folder};
    support::TileMaker maker;
    TileRecord small = maker(tile_at(6));
    small.pixels.truth = {};  // fewer bytes to cut at
    small.pixels.bands.clear();
    opened.journal.keep(small);
  }
  const std::string whole = support::content_of(file);
  for (std::size_t length = two; length < whole.size(); ++length) {
    write_tile_journal(file, whole.substr(0, length));
    Opened opened{folder};
    if (opened.journal.tiles() != 2 || !opened.journal.find(tile_at(3)) ||
        opened.journal.find(tile_at(6)) || fs::file_size(file) != two ||
        opened.diagnostics.messages().size() != (length > two ? 1U : 0U)) {
      FAIL("cut at byte " << length);
    }
  }
  write_tile_journal(file, whole);
  CHECK(Opened{folder}.journal.tiles() == 3);
}

TEST_CASE("a journal goes on behind what was cut off", "[sim][journal]") {
  const ScratchFolder folder;
  fill(folder, 2);
  const fs::path file = folder / "samples.nadir";
  fs::resize_file(file, fs::file_size(file) - 5);
  support::TileMaker maker;
  {
    Opened opened{folder};
    REQUIRE(opened.diagnostics.messages().size() == 1);
    CHECK(opened.diagnostics.messages()[0].find("of a tile that was not finished: cut off") !=
          std::string::npos);
    opened.journal.keep(maker(tile_at(3)));
  }
  Opened opened{folder};
  CHECK(opened.diagnostics.messages().empty());
  CHECK(opened.journal.tiles() == 2);
  CHECK(opened.journal.find(tile_at(3)));
}

TEST_CASE("a flipped byte costs the tile that it is in, and no other", "[sim][journal]") {
  const ScratchFolder folder;
  fill(folder, 1);
  const fs::path file = folder / "samples.nadir";
  const auto one = fs::file_size(file);
  fill(folder, 3);  // the first again, and two more
  const std::string whole = support::content_of(file);
  // A prime step: mark, head and content, and never the same places of two frames.
  for (std::size_t at = one; at < whole.size(); at += 31) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    write_tile_journal(file, damaged);
    Opened opened{folder};
    int found = 0;
    for (const int sample : {0, 3, 6}) found += opened.journal.find(tile_at(sample)) ? 1 : 0;
    // The first tile stands there twice.
    if (found < 2 || opened.diagnostics.messages().size() != 1) FAIL("flipped byte " << at);
  }
}

TEST_CASE("any byte of a journal may be anything", "[sim][journal]") {
  const ScratchFolder folder;
  fill(folder, 1);
  const fs::path file = folder / "samples.nadir";
  const std::string whole = support::content_of(file);
  for (std::size_t at = 0; at < whole.size(); at += 29) {
    std::string damaged = whole;
    for (std::size_t i = at; i < std::min(at + 4, damaged.size()); ++i) damaged[i] = '\xFF';
    write_tile_journal(file, damaged);
    Opened opened{folder};
    CHECK(opened.journal.tiles() <= 1);
    fs::remove(folder / "samples.nadir.old");
  }
}

TEST_CASE("samples of another run are set aside until the new run is finished", "[sim][journal]") {
  const ScratchFolder folder;
  fill(folder, 2, some_key(1));
  const std::string former = support::content_of(folder / "samples.nadir");
  RunKey other = some_key(2);
  other.physics[1].second = "changed";
  {
    Opened opened{folder, other};
    REQUIRE(opened.diagnostics.messages().size() == 1);
    CHECK(opened.diagnostics.messages()[0] ==
          (folder / "samples.nadir").string() +
              " holds samples of another run (not the same: scenario, seed): kept as "
              "samples.nadir.old until this run is finished");
    CHECK(opened.journal.tiles() == 0);
    support::TileMaker maker;
    opened.journal.keep(maker(tile_at(0)));
  }
  CHECK(support::content_of(folder / "samples.nadir.old") == former);
  {  // a third, before the second is finished: neither is lost
    Opened opened{folder, some_key(3)};
    CHECK(support::content_of(folder / "samples.nadir.old") == former);
    CHECK(fs::exists(folder / "samples.nadir.old2"));
    opened.journal.finish(1);
  }
  CHECK(folder.entries() == 1);
}

TEST_CASE("an empty journal makes room, a file of another kind is set aside", "[sim][journal]") {
  const ScratchFolder folder;
  fill(folder, 0, some_key(1));
  CHECK(Opened{folder, some_key(2)}.diagnostics.messages().empty());
  CHECK(folder.entries() == 1);
  write_tile_journal(folder / "samples.nadir", "my own notes");
  const Opened opened{folder, some_key(2)};
  CHECK(opened.diagnostics.messages().size() == 1);
  CHECK(support::content_of(folder / "samples.nadir.old") == "my own notes");
}

TEST_CASE("starting over sets the same run's samples aside", "[sim][journal]") {
  const ScratchFolder folder;
  fill(folder, 2);
  const Opened opened{folder, some_key(), {.fresh = true, .only_same = false, .seeds = {}}};
  CHECK(opened.journal.tiles() == 0);
  CHECK(fs::exists(folder / "samples.nadir.old"));
}

TEST_CASE("what is to be extended must be there", "[sim][journal]") {
  const ScratchFolder folder;
  const TileJournal::Options extend{.fresh = false, .only_same = true, .seeds = {}};
  CHECK_THROWS_WITH((Opened{folder, some_key(), extend}),
                    Catch::Contains("there are no samples of a run here"));
  fill(folder, 2);
  CHECK(Opened{folder, some_key(), extend}.journal.tiles() == 2);
  CHECK_THROWS_WITH((Opened{folder, some_key(5), extend}),
                    Catch::Contains("another run (not the same: seed)"));
  CHECK(Opened{folder}.journal.tiles() == 2);
}

TEST_CASE("a journal knows what its runs began and finished", "[sim][journal]") {
  const ScratchFolder folder;
  {
    Opened opened{folder};
    CHECK(opened.journal.begun() == 0);
    CHECK(opened.journal.finished() == 0);
    opened.journal.begin(1);
    opened.journal.finish(1);
    opened.journal.begin(2);
  }
  const Opened opened{folder};
  CHECK(opened.journal.begun() == 2);
  CHECK(opened.journal.finished() == 1);
}

TEST_CASE("one run at a time has a folder", "[sim][journal]") {
  const ScratchFolder folder;
  Opened first{folder};
  CHECK_THROWS_WITH(Opened{folder}, Catch::Contains("another run is at work in this folder"));
  CHECK_THROWS_AS(KeptSamples{folder.path()}, InputError);
}

TEST_CASE("a discarded journal is gone", "[sim][journal]") {
  const ScratchFolder folder;
  fill(folder, 1);
  Opened{folder}.journal.discard();
  CHECK(folder.entries() == 0);
  CHECK_THROWS_WITH(KeptSamples{folder.path()}, Catch::Contains("there are no samples of a run"));
}

/// While it lives, no file may grow beyond so many bytes: a full disc.
class FullDisc {
 public:
  explicit FullDisc(std::uintmax_t bytes) : former_handler_{std::signal(SIGXFSZ, SIG_IGN)} {
    ::getrlimit(RLIMIT_FSIZE, &former_);
    rlimit limit = former_;
    limit.rlim_cur = static_cast<rlim_t>(bytes);
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisc() {
    ::setrlimit(RLIMIT_FSIZE, &former_);
    std::signal(SIGXFSZ, former_handler_);
  }
  FullDisc(const FullDisc&) = delete;
  FullDisc& operator=(const FullDisc&) = delete;

 private:
  rlimit former_{};
  void (*former_handler_)(int);
};

TEST_CASE("a full disc is told, and costs no tile that was kept", "[sim][journal]") {
  const ScratchFolder folder;
  fill(folder, 2);
  support::TileMaker maker;
  {
    Opened opened{folder};
    const TileRecord record = maker(tile_at(6));
    {
      const FullDisc full{fs::file_size(folder / "samples.nadir") + 100};  // half a tile
      CHECK_THROWS_WITH(opened.journal.keep(record), Catch::Contains("cannot write "));
    }
    CHECK(opened.journal.tiles() == 2);
    opened.journal.keep(record);  // there is room again
    CHECK(opened.journal.find(tile_at(6)));
  }
  Opened opened{folder};
  CHECK(opened.diagnostics.messages().empty());
  CHECK(opened.journal.tiles() == 3);
}

TEST_CASE("what a killed run left half written is cleared away", "[sim][journal]") {
  const ScratchFolder folder;
  const std::string dead = ".a_radiance.img.999999999-3.tmp";  // beyond the greatest process
  const std::string alive = ".a_radiance.img." + std::to_string(::getpid()) + "-4.tmp";
  for (const std::string& name : {dead, alive, std::string{"mine.999999999-3.tmp"}}) {
    write_tile_journal(folder / name, "half");
  }
  const Opened opened{folder};
  CHECK_FALSE(fs::exists(folder / dead));
  CHECK(fs::exists(folder / alive));
  CHECK(fs::exists(folder / "mine.999999999-3.tmp"));
}

TEST_CASE("threads keep and find tiles at once", "[sim][journal]") {
  const ScratchFolder folder;
  constexpr int each = 40;
  {
    Opened opened{folder};
    const auto work = [&](int thread) {
      support::TileMaker maker;
      for (int i = 0; i < each; ++i) {
        const TileKey key = tile_at(3 * i, static_cast<std::uint32_t>(thread));
        opened.journal.keep(maker(key));
        static_cast<void>(opened.journal.find(tile_at(3 * i, 1U - static_cast<unsigned>(thread))));
      }
    };
    std::thread one{work, 0}, two{work, 1};
    one.join();
    two.join();
  }
  Opened opened{folder};
  CHECK(opened.diagnostics.messages().empty());
  REQUIRE(opened.journal.tiles() == 2 * each);
  for (std::uint32_t round : {0U, 1U}) {
    support::TileMaker maker;
    for (int i = 0; i < each; ++i) {
      const TileRecord made = maker(tile_at(3 * i, round));
      const auto found = opened.journal.find(made.key);
      REQUIRE(found);
      CHECK(same_bits(found->pixels.bands[1].bias, made.pixels.bands[1].bias));
    }
  }
}

}  // namespace
}  // namespace nadir::sim
