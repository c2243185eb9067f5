#include "sim/run/tiles.hpp"

#include <atomic>
#include <stdexcept>
#include <vector>

#include "support/catch.hpp"

namespace nadir::sim {
namespace {

TEST_CASE("tiles cover every pixel of an image once", "[sim][tiles]") {
  std::vector<int> covered(37 * 23);
  for (const Tile& tile : cut_into_tiles(0, 37, 23, 16)) {
    for (int line = tile.first_line; line < tile.first_line + tile.lines; ++line) {
      for (int s = tile.first_sample; s < tile.first_sample + tile.samples; ++s) {
        ++covered[static_cast<std::size_t>(line * 37 + s)];
      }
    }
  }
  for (const int count : covered) REQUIRE(count == 1);
}

TEST_CASE("every tile is worked on once, on any number of threads", "[sim][tiles]") {
  const auto tiles = cut_into_tiles(0, 160, 160, 16);
  for (const int threads : {0, 1, 2, 7}) {
    std::vector<std::atomic<int>> worked(tiles.size());
    for_each_tile(tiles, threads, [&](const Tile& tile) {
      ++worked[static_cast<std::size_t>(tile.first_line / 16 * 10 + tile.first_sample / 16)];
    });
    for (const auto& count : worked) REQUIRE(count == 1);
  }
}

TEST_CASE("what a tile throws reaches the caller", "[sim][tiles]") {
  CHECK_THROWS_AS(for_each_tile(cut_into_tiles(0, 64, 64, 16), 2,
                                [](const Tile&) { throw std::runtime_error{"no"}; }),
                  std::runtime_error);
}

}  // namespace
}  // namespace nadir::sim
