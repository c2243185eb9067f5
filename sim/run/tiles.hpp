#pragma once

#include <functional>
#include <memory>
#include <vector>

namespace nadir::sim {

/// A rectangle of pixels of one detector array.
struct Tile {
  int array = 0;
  int first_sample = 0, first_line = 0;
  int samples = 0, lines = 0;
};

/// Cuts an image into tiles of at most `edge` pixels a side, row by row.
[[nodiscard]] std::vector<Tile> cut_into_tiles(int array, int samples, int lines, int edge);

/// Threads that work is spread over when no number is given.
[[nodiscard]] int available_threads();

/// While it lives, this process uses at most (and, where there is work, exactly) so many threads.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);  ///< 0: one per processor
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Runs `work` on every tile, on `threads` threads (0: one per processor). `work` must not depend
/// on the order. The first exception stops the rest and is thrown here.
void for_each_tile(const std::vector<Tile>& tiles, int threads,
                   const std::function<void(const Tile&)>& work);

}  // namespace nadir::sim
