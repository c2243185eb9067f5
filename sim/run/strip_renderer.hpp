#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <vector>

#include "sim/run/array_job.hpp"
#include "sim/run/strips.hpp"
#include "sim/run/tile_store.hpp"
#include "sim/run/tiles.hpp"

namespace nadir::sim {

/// Tells of progress and adds up what threads have done.
struct RenderProgress {
  std::mutex mutex;
  std::size_t done = 0, all = 0;  ///< tiles
  radiometry::Counters counters;
};

/// How one round of a strip is sampled.
struct RoundOrder {
  std::uint32_t round = 0;
  const ArrayImage* known = nullptr;  ///< former rounds, merged; null in the first
  /// Samples a replicate of every pixel of the strip; empty: as the options say.
  std::vector<int> samples{};
  bool only_kept = false;           ///< tiles that the store has not stay blank
  std::function<bool()> give_up{};  ///< asked before each tile: leave the rest blank?
};

/// Renders a strip of an array, round by round, tile by tile, in parallel.
class StripRenderer {
 public:
  StripRenderer(const ArrayJob& job, const Strip& strip, const RenderOptions& options,
                RenderProgress& progress);

  /// All rounds that the options ask for, merged, with what is stated of systematic errors.
  [[nodiscard]] ArrayImage render();

  /// One round of all tiles. Tiles that the store has are taken from there.
  [[nodiscard]] ArrayImage render_round(const RoundOrder& order);

  [[nodiscard]] std::size_t pixels() const;
  /// Paths that were sampled here, and not found in the store.
  [[nodiscard]] std::uint64_t computed_paths() const noexcept { return computed_paths_; }

 private:
  [[nodiscard]] ArrayImage tile(const Tile& tile, const RoundOrder& order);
  [[nodiscard]] ArrayImage compute(const TileKey& key, const RoundOrder& order,
                                   radiometry::Counters& counters) const;
  void count(const radiometry::Counters& counters);

  const ArrayJob* job_;
  Strip strip_;
  const RenderOptions* options_;
  RenderProgress* progress_;
  std::vector<Tile> tiles_;  // in the order of work
  std::atomic<std::uint64_t> computed_paths_{0};
};

/// Edge of a tile, pixels: small enough to keep all processors busy to the end, large enough that a
/// tile outweighs its solvers' construction a thousand times.
inline constexpr int tile_edge = 16;

/// Paths of all pixels.
[[nodiscard]] std::uint64_t paths_in(const ArrayImage& image);

/// Fills what is stated of the systematic error of every band, relative to max(radiance, floor);
/// nothing without a goal.
void state_bias(ArrayImage& image, std::size_t array, const RenderOptions& options);

}  // namespace nadir::sim
