#include "sim/run/merge_runs.hpp"

#include "core/error.hpp"
#include "sim/kept_samples.hpp"
#include "sim/run/tile_journal.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

namespace fs = std::filesystem;
using support::ScratchFolder;
using support::some_key;

TileKey kept_tile(int first_sample, std::uint32_t round) {
  return {round, 0, first_sample, 0, 3, 2};
}

/// A finished run of some rounds over two tiles, told apart by its tiles' paths.
fs::path kept_run(const ScratchFolder& scratch, const RunKey& key, std::uint32_t rounds) {
  const fs::path folder = scratch / ("run" + std::to_string(scratch.entries()));
  fs::create_directories(folder);
  Diagnostics diagnostics;
  TileJournal journal{folder, key, {}, diagnostics};
  journal.begin(rounds);
  support::TileMaker maker;
  for (std::uint32_t round = 0; round < rounds; ++round) {
    for (const int sample : {0, 3}) {
      TileRecord record = maker(kept_tile(sample, round));
      record.pixels.paths = static_cast<std::uint32_t>(100 * key.seed) + round;
      journal.keep(record);
    }
  }
  journal.finish(rounds);
  return folder;
}

MergedSamples merged(const std::vector<fs::path>& runs, const fs::path& output) {
  Diagnostics diagnostics;
  const MergedSamples samples = merge_journals(runs, output, diagnostics);
  CHECK(diagnostics.messages().empty());
  return samples;
}

void check_refused(const std::vector<fs::path>& runs, const fs::path& output,
                   const std::string& message) {
  Diagnostics diagnostics;
  CHECK_THROWS_WITH(static_cast<void>(merge_journals(runs, output, diagnostics)),
                    Catch::Contains(message));
}

TEST_CASE("the rounds of merged runs are numbered on", "[sim][merge]") {
  const ScratchFolder scratch;
  const fs::path a = kept_run(scratch, some_key(1), 2), b = kept_run(scratch, some_key(2), 1),
                 c = kept_run(scratch, some_key(3), 3);
  const fs::path output = scratch / "merged";
  const MergedSamples samples = merged({a, b, c}, output);
  CHECK(samples.rounds == 6);
  CHECK(samples.tiles == 12);
  CHECK(samples.whose.seeds == std::vector<std::uint64_t>{1, 2, 3});
  const KeptSamples kept{output};
  CHECK(kept.is_finished());
  CHECK(kept.rounds() == 6);
  CHECK(kept.whose().key.same_samples(some_key(1)));
  const std::uint32_t paths[] = {100, 101, 200, 300, 301, 302};
  for (std::uint32_t round = 0; round < 6; ++round) {
    CAPTURE(round);
    const TileRecord record = kept.read(kept_tile(3, round));
    CHECK(record.pixels.paths == paths[round]);
    CHECK(record.pixels.bands.size() == 2);
    // The truth is the first run's.
    CHECK(record.pixels.truth.material.empty() == (round > 0));
  }
}

TEST_CASE("a merged run is merged again and extended", "[sim][merge]") {
  const ScratchFolder scratch;
  const fs::path a = kept_run(scratch, some_key(1), 1), b = kept_run(scratch, some_key(2), 1),
                 c = kept_run(scratch, some_key(3), 1);
  static_cast<void>(merged({a, b}, scratch / "ab"));
  const MergedSamples all = merged({c, scratch / "ab"}, scratch / "abc");
  CHECK(all.rounds == 3);
  CHECK(all.whose.seeds == std::vector<std::uint64_t>{3, 1, 2});
  check_refused({scratch / "abc", b}, scratch / "twice", "both have the samples of seed 2");
  Diagnostics diagnostics;
  TileJournal journal{scratch / "ab", some_key(1), {}, diagnostics};
  CHECK(journal.tiles() == 4);
  CHECK(journal.seeds() == std::vector<std::uint64_t>{1, 2});
  support::TileMaker maker;
  journal.keep(maker(kept_tile(0, 2)));
  CHECK(journal.rounds() == 3);
}

TEST_CASE("merged samples do not make room for another run's", "[sim][merge]") {
  const ScratchFolder scratch;
  static_cast<void>(merged({kept_run(scratch, some_key(1), 1), kept_run(scratch, some_key(2), 1)},
                           scratch / "ab"));
  Diagnostics diagnostics;
  CHECK_THROWS_WITH((TileJournal{scratch / "ab", some_key(2), {}, diagnostics}),
                    Catch::Contains("of another run, merged from several (not the same: seed)"));
  CHECK(KeptSamples{scratch / "ab"}.rounds() == 2);
}

TEST_CASE("runs that only sample otherwise are merged", "[sim][merge]") {
  const ScratchFolder scratch;
  RunKey denser = some_key(2);
  denser.sampling[0].second = "8 x 4";
  const MergedSamples samples =
      merged({kept_run(scratch, some_key(1), 1), kept_run(scratch, denser, 1)}, scratch / "merged");
  CHECK(samples.whose.key.sampling == some_key().sampling);
}

TEST_CASE("runs that must not be merged are refused in one sentence", "[sim][merge]") {
  const ScratchFolder scratch;
  const fs::path a = kept_run(scratch, some_key(1), 1), same = kept_run(scratch, some_key(1), 1);
  const fs::path output = scratch / "merged";
  check_refused({a, same}, output,
                same.string() + ": error: this run and " + a.string() +
                    " both have the samples of seed 1: the same samples cannot count twice");
  check_refused({a, a}, output, "both have the samples of seed 1");
  RunKey other = some_key(2);
  other.physics[2].second = "changed";
  check_refused(
      {a, kept_run(scratch, other, 1)}, output,
      "this run is of another picture than " + a.string() + " (not the same: file \"ball.obj\")");
  check_refused({a, scratch / "nothing"}, output, "there are no samples of a run here");
  check_refused({a, kept_run(scratch, some_key(4), 1)}, a,
                "the merged run cannot be written into one of the runs");
  check_refused({a}, output, "two runs or more");
  CHECK_FALSE(fs::exists(output));
}

TEST_CASE("an interrupted run is not merged", "[sim][merge]") {
  const ScratchFolder scratch;
  const fs::path a = kept_run(scratch, some_key(1), 1), b = kept_run(scratch, some_key(2), 1);
  {
    Diagnostics diagnostics;
    TileJournal journal{b, some_key(2), {}, diagnostics};
    journal.begin(2);
  }
  check_refused({a, b}, scratch / "merged", "this run was interrupted");
}

}  // namespace
}  // namespace nadir::sim
