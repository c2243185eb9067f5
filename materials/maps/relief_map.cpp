#include "materials/maps/relief_map.hpp"

#include <cmath>

#include "core/error.hpp"

namespace nadir::materials {
namespace {

std::size_t size_of(const MapFrame& frame) {
  return static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows);
}

Vec2 mix(Vec2 a, Vec2 b, double share_of_b) {
  return {a.x + share_of_b * (b.x - a.x), a.y + share_of_b * (b.y - a.y)};
}

/// Two neighbours of pixel `i` along an axis and how many steps they are apart.
struct Neighbours {
  int before = 0, after = 0;
  double steps = 0.0;
};

Neighbours neighbours(int i, int count, bool repeats) {
  if (repeats) return {(i + count - 1) % count, (i + 1) % count, 2.0};
  const int before = i > 0 ? i - 1 : i, after = i + 1 < count ? i + 1 : i;
  return {before, after, static_cast<double>(after - before)};
}

double per_step(double before, double after, double steps) {
  return steps == 0.0 ? 0.0 : (after - before) / steps;  // a map of one pixel is flat
}

}  // namespace

Vec3 ReliefMap::normal_at(Vec2 place) const noexcept {
  const Vec2 p = frame.pixels(place);
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) return {0.0, 0.0, 1.0};
  const Vec2 corner{std::floor(p.x - 0.5), std::floor(p.y - 0.5)};
  const double right = p.x - 0.5 - corner.x, below = p.y - 0.5 - corner.y;
  const auto at = [&](double columns, double rows) {
    return slope[frame.pixel_at({corner.x + columns + 0.5, corner.y + rows + 0.5})];
  };
  const Vec2 s =
      mix(mix(at(0.0, 0.0), at(1.0, 0.0), right), mix(at(0.0, 1.0), at(1.0, 1.0), right), below);
  return normalised({-s.x, -s.y, 1.0});
}

std::vector<Vec2> slopes_of_heights(const MapFrame& frame, const std::vector<double>& heights,
                                    double strength) {
  if (heights.size() != size_of(frame)) throw InputError{"a relief's heights do not fill its map"};
  const auto at = [&](int column, int row) {
    return heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.columns) +
                   static_cast<std::size_t>(column)];
  };
  std::vector<Vec2> slopes;
  slopes.reserve(heights.size());
  for (int row = 0; row < frame.rows; ++row) {
    const Neighbours v = neighbours(row, frame.rows, frame.repeats);
    for (int column = 0; column < frame.columns; ++column) {
      const Neighbours h = neighbours(column, frame.columns, frame.repeats);
      const Vec2 slope =
          frame.gradient({per_step(at(h.before, row), at(h.after, row), h.steps),
                          per_step(at(column, v.before), at(column, v.after), v.steps)});
      slopes.push_back({strength * slope.x, strength * slope.y});
    }
  }
  return slopes;
}

Vec2 slope_of_normal(Vec3 normal, double strength) {
  return {-strength * normal.x / normal.z, -strength * normal.y / normal.z};
}

}  // namespace nadir::materials
