#pragma once

#include <array>
#include <limits>
#include <vector>

#include "geometry/scene.hpp"
#include "radiometry/volumes/bound_volume.hpp"
#include "radiometry/volumes/grid_field.hpp"
#include "spectral/lanes.hpp"

namespace nadir::radiometry {

/// How many volumes may overlap at one place.
inline constexpr int most_overlapping = 16;

/// A volume that a step of a ray lies in. Its density there is from `lo` to `lo + span`.
struct ActiveVolume {
  const BoundVolume* volume;
  Vec3 origin, direction;  ///< of the ray, in the region's own axes; only for grids
  double crossing_length;  ///< of the ray with the whole region, m
  float lo, span;

  [[nodiscard]] Vec3 own_axes(double distance) const { return origin + distance * direction; }
};

/// Part of a ray on which the same volumes overlap and every grid stays in one of its blocks. What
/// is there is split into a constant part, which is treated exactly, and the rest of the grids,
/// which is met by chance.
struct Step {
  double begin = 0.0, end = 0.0;  ///< distances from the ray's origin, m
  int count = 0;
  std::array<ActiveVolume, most_overlapping> active;
  // The constant part, per lane, 1/m and W m^-3 sr^-1 um^-1.
  spectral::Spectrum extinction, scattering, emission;
  bool scatters = false, emits = false, attenuates = false;  ///< of the constant part
  /// Bound of the extinction that is not in the constant part; of all that whose emission is not,
  /// 1/m.
  double majorant = 0.0;
  /// 1 over the length of crossings on which something is met by chance that scatters or emits,
  /// 1/m.
  double chances = 0.0;
};

/// Cuts a ray into steps, in order, leaving out where no volume is. Holds a fixed number of
/// crossings: a ray that meets more is worked through in windows.
class Walk {
 public:
  Walk(const std::vector<BoundVolume>& volumes, const geometry::Ray& ray, double distance) noexcept;

  /// Goes to the next step; false at the ray's end.
  [[nodiscard]] bool next() noexcept;
  [[nodiscard]] const Step& step() const noexcept { return step_; }

 private:
  struct Crossing {
    const BoundVolume* volume;
    geometry::Interval part;
    Vec3 origin, direction;
    BlockWalk blocks;
  };
  void fill() noexcept;
  void insert(const BoundVolume& volume, const geometry::Interval& part) noexcept;
  void prepare(Crossing& crossing) noexcept;
  void gather(double begin) noexcept;
  void add(const Crossing& crossing) noexcept;

  const std::vector<BoundVolume>* volumes_;
  geometry::Ray ray_;
  std::array<Crossing, most_overlapping> crossings_;
  int count_ = 0;
  double position_ = 0.0, window_end_ = 0.0;
  Step step_;
};

}  // namespace nadir::radiometry
