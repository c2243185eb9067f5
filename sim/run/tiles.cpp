#include "sim/run/tiles.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>

namespace nadir::sim {

std::vector<Tile> cut_into_tiles(int array, int samples, int lines, int edge) {
  std::vector<Tile> tiles;
  for (int line = 0; line < lines; line += edge) {
    for (int sample = 0; sample < samples; sample += edge) {
      tiles.push_back(
          {array, sample, line, std::min(edge, samples - sample), std::min(edge, lines - line)});
    }
  }
  return tiles;
}

int available_threads() { return oneapi::tbb::info::default_concurrency(); }

// More threads than processors need the process-wide limit raised; an arena alone would be cut.
struct ThreadLimit::State {
  oneapi::tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads) {
  using Control = oneapi::tbb::global_control;
  if (threads > 0) {
    state_.reset(
        new State{Control{Control::max_allowed_parallelism, static_cast<std::size_t>(threads)}});
  }
}
ThreadLimit::~ThreadLimit() = default;

void for_each_tile(const std::vector<Tile>& tiles, int threads,
                   const std::function<void(const Tile&)>& work) {
  namespace tbb = oneapi::tbb;
  const ThreadLimit limit{threads};
  tbb::task_arena arena{threads > 0 ? threads : tbb::task_arena::automatic};
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>{0, tiles.size(), 1},
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i != range.end(); ++i) work(tiles[i]);
        },
        tbb::simple_partitioner{});
  });
}

}  // namespace nadir::sim
