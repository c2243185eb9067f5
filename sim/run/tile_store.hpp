#pragma once

#include <compare>
#include <cstdint>
#include <optional>

#include "radiometry/counters.hpp"
#include "sim/run/image.hpp"

namespace nadir::sim {

/// A piece of a picture's work: one round of samples of a rectangle of pixels.
struct TileKey {
  std::uint32_t round = 0;  ///< rounds have random numbers of their own; 0 is the first
  std::uint32_t array = 0;
  int first_sample = 0, first_line = 0;  ///< in the image
  int samples = 0, lines = 0;
  [[nodiscard]] auto operator<=>(const TileKey&) const = default;
};

/// A finished piece.
struct TileRecord {
  TileKey key;
  ArrayImage pixels;  ///< of the tile's size; truth only in round 0
  radiometry::Counters counters;
};

/// Where finished pieces are kept while a picture is made, so that an interrupted run goes on from
/// them. Thread-safe.
class TileStore {
 public:
  TileStore() = default;
  TileStore(const TileStore&) = delete;
  TileStore& operator=(const TileStore&) = delete;
  virtual ~TileStore() = default;
  /// What is kept under a key; nothing where it is not there.
  [[nodiscard]] virtual std::optional<TileRecord> find(const TileKey& key) = 0;
  /// Keeps a piece before this returns, whatever becomes of the process afterwards.
  virtual void keep(const TileRecord& record) = 0;
};

}  // namespace nadir::sim
