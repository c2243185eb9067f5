#include "radiometry/volumes/grid_field.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

namespace nadir::radiometry {
namespace {

/// The two cells about a place along one axis, and how far it is from the first to the second.
struct Neighbours {
  std::size_t first, second;
  float share;
};

Neighbours neighbours(double unit, int cells) {
  const double place = std::clamp(unit * cells - 0.5, 0.0, static_cast<double>(cells - 1));
  const int first = std::min(static_cast<int>(place), std::max(cells - 2, 0));
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(std::min(first + 1, cells - 1)),
          static_cast<float>(place - first)};
}

float mixed(float a, float b, float share) { return (1.0F - share) * a + share * b; }

}  // namespace

GridField::GridField(std::shared_ptr<const ScalarGrid> grid)
    : grid_{std::move(grid)}, cells_{grid_->columns, grid_->rows, grid_->layers} {
  constexpr int most_blocks = 32, least_cells = 4;
  const int longest = *std::max_element(cells_.begin(), cells_.end());
  block_cells_ = std::max(least_cells, (longest + most_blocks - 1) / most_blocks);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    blocks_[axis] = (cells_[axis] + block_cells_ - 1) / block_cells_;
    block_width_[axis] = static_cast<double>(block_cells_) / cells_[axis];
  }
  tabulate_blocks();
}

float GridField::at(Vec3 unit) const noexcept {
  const Neighbours x = neighbours(unit.x, cells_[0]), y = neighbours(unit.y, cells_[1]),
                   z = neighbours(unit.z, cells_[2]);
  const auto columns = static_cast<std::size_t>(cells_[0]);
  const auto rows = static_cast<std::size_t>(cells_[1]);
  const float* const value = grid_->value.data();
  const auto along_x = [&](std::size_t row, std::size_t layer) {
    const float* const line = value + (layer * rows + row) * columns;
    return mixed(line[x.first], line[x.second], x.share);
  };
  const auto plane = [&](std::size_t layer) {
    return mixed(along_x(y.first, layer), along_x(y.second, layer), y.share);
  };
  return mixed(plane(z.first), plane(z.second), z.share);
}

GridField::Range GridField::block(const std::array<int, 3>& index) const noexcept {
  const int number = (index[2] * blocks_[1] + index[1]) * blocks_[0] + index[0];  // 32^3 at most
  return ranges_[static_cast<std::size_t>(number)];
}

void GridField::tabulate_blocks() {
  for (int z = 0; z < blocks_[2]; ++z) {
    for (int y = 0; y < blocks_[1]; ++y) {
      for (int x = 0; x < blocks_[0]; ++x) ranges_.push_back(range_of({x, y, z}));
    }
  }
  whole_ = ranges_.front();
  for (const Range& range : ranges_) {
    whole_ = {std::min(whole_.lo, range.lo), std::max(whole_.hi, range.hi)};
  }
}

/// Interpolation inside a block reaches one cell beyond it on either side.
GridField::Range GridField::range_of(const std::array<int, 3>& block) const {
  std::array<int, 3> first{}, last{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    first[axis] = std::max(block[axis] * block_cells_ - 1, 0);
    last[axis] = std::min((block[axis] + 1) * block_cells_, cells_[axis] - 1);
  }
  Range range{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
  for (int z = first[2]; z <= last[2]; ++z) {
    for (int y = first[1]; y <= last[1]; ++y) {
      const auto line = (std::ptrdiff_t{z} * cells_[1] + y) * cells_[0];
      const auto begin = grid_->value.begin() + line;
      const auto [lo, hi] = std::minmax_element(begin + first[0], begin + last[0] + 1);
      range = {std::min(range.lo, *lo), std::max(range.hi, *hi)};
    }
  }
  return range;
}

BlockWalk::BlockWalk(const GridField* field, Vec3 origin, Vec3 direction, double distance) noexcept
    : field_{field},
      origin_{origin.x, origin.y, origin.z},
      direction_{direction.x, direction.y, direction.z} {
  if (field_ == nullptr) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double place = origin_[axis] + distance * direction_[axis];
    const double block = std::clamp(place / field_->block_width_[axis], 0.0,
                                    static_cast<double>(field_->blocks_[axis] - 1));
    index_[axis] = static_cast<int>(block);
  }
  look();
}

/// Blocks are left where the ray meets their far side, computed anew each time: nothing adds up.
void BlockWalk::look() noexcept {
  range_ = field_->block(index_);
  exit_ = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool up = direction_[axis] > 0.0;
    const bool last = index_[axis] == (up ? field_->blocks_[axis] - 1 : 0);
    if (last || direction_[axis] == 0.0) continue;
    const double side = (index_[axis] + (up ? 1 : 0)) * field_->block_width_[axis];
    const double exit = (side - origin_[axis]) / direction_[axis];
    if (exit < exit_) {
      exit_ = exit;
      axis_ = static_cast<int>(axis);
    }
  }
}

void BlockWalk::step() noexcept {
  const auto axis = static_cast<std::size_t>(axis_);
  assert(exit_ < std::numeric_limits<double>::infinity());
  index_[axis] += direction_[axis] > 0.0 ? 1 : -1;
  look();
}

}  // namespace nadir::radiometry
