#pragma once

#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "core/vec.hpp"
#include "radiometry/volumes/volume.hpp"

namespace nadir::radiometry {

/// A grid that can be looked up in its box, mapped to [0, 1]^3, with the least and greatest value
/// of each of its blocks: at most 32 blocks along an axis, each at least 4 cells long.
class GridField {
 public:
  struct Range {
    float lo = 1.0F, hi = 1.0F;
  };

  /// @param grid  with as many finite values as its size says
  explicit GridField(std::shared_ptr<const ScalarGrid> grid);

  /// Linear between cell centres, held beyond the outer ones.
  [[nodiscard]] float at(Vec3 unit) const noexcept;
  [[nodiscard]] Range range() const noexcept { return whole_; }

 private:
  friend class BlockWalk;
  [[nodiscard]] Range block(const std::array<int, 3>& index) const noexcept;
  void tabulate_blocks();
  [[nodiscard]] Range range_of(const std::array<int, 3>& block) const;

  std::shared_ptr<const ScalarGrid> grid_;
  std::array<int, 3> cells_{}, blocks_{};
  std::array<double, 3> block_width_{};  // in the unit box
  int block_cells_ = 1;
  std::vector<Range> ranges_;
  Range whole_;
};

/// Follows a ray through the blocks of a grid (Amanatides & Woo, Eurographics 1987). Distances are
/// the ray's own.
class BlockWalk {
 public:
  /// @param field             null: one block of value 1 everywhere
  /// @param origin,direction  of the ray, in axes in which the box is [0, 1]^3
  /// @param distance          where to begin
  BlockWalk(const GridField* field, Vec3 origin, Vec3 direction, double distance) noexcept;
  BlockWalk() noexcept = default;

  [[nodiscard]] GridField::Range range() const noexcept { return range_; }
  /// Where the ray leaves the present block.
  [[nodiscard]] double leave() const noexcept { return exit_; }
  void step() noexcept;

 private:
  void look() noexcept;

  const GridField* field_ = nullptr;
  std::array<double, 3> origin_{}, direction_{};
  std::array<int, 3> index_{};
  int axis_ = 0;  // across which the ray leaves
  double exit_ = std::numeric_limits<double>::infinity();
  GridField::Range range_;
};

}  // namespace nadir::radiometry
