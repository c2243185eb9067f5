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
  [[nodiscard]] std::size_t pixel_of(int sample, int line) const;  // in the strip
  [[nodiscard]] ArrayImage compute(const TileKey& key, const RoundOrder& order,
                                   radiometry::Counters& counters) const;
  void render_as_ordered(PixelRenderer& pixels, const RoundOrder& order, ArrayImage& image) const;
  void count(const radiometry::Counters& counters);

  const ArrayJob* job_;
  Strip strip_;
  const RenderOptions* options_;
  RenderProgress* progress_;
  std::vector<Tile> tiles_;  // in the order of work
  std::atomic<std::uint64_t> computed_paths_{0};
};

/// Edge of a tile, pixels, at the most. Strips are whole rows of such tiles.
inline constexpr int tile_edge = 16;

/// The tiles of a strip of an array.
[[nodiscard]] std::vector<Tile> tiles_of(const sensor::DetectorArray& array, const Strip& strip);

/// Samples a replicate that every pixel of a tile gets at first when it is sampled to a goal.
/// @param pixels  of the tile
[[nodiscard]] int first_look(const SamplingGoal& goal, std::size_t pixels);

/// Paths of all pixels.
[[nodiscard]] std::uint64_t paths_in(const ArrayImage& image);

/// Fills what is stated of the systematic error of every band, relative to max(radiance, floor);
/// nothing without a goal.
void state_bias(ArrayImage& image, std::size_t array, const RenderOptions& options);

}  // namespace nadir::sim
