#include "sensor/camera/view_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "core/error.hpp"

namespace nadir::sensor {
namespace {

struct Cell {
  std::size_t index = 0;    // of its first node
  double u = 0.0, v = 0.0;  // share of the way to the next node; beyond [0, 1] outside
};

// Number of the cell of `nodes` that holds a place, and how far into it.
std::pair<int, double> cell_along(double place, int nodes) noexcept {
  const double whole = std::clamp(std::floor(place), 0.0, static_cast<double>(nodes - 2));
  return {static_cast<int>(whole), place - whole};
}

Cell cell_at(const ViewTable& table, Vec2 image) noexcept {
  const auto [column, u] = cell_along((image.x - 0.5) / table.sample_step, table.samples);
  if (table.lines == 1) return {static_cast<std::size_t>(column), u, 0.0};
  const auto [row, v] = cell_along((image.y - 0.5) / table.line_step, table.lines);
  return {static_cast<std::size_t>(row) * static_cast<std::size_t>(table.samples) +
              static_cast<std::size_t>(column),
          u, v};
}

// Bilinear, not of length one, and how it changes from pixel to pixel.
struct Sight {
  Vec3 direction, by_sample, by_line;
};

Sight sight_at(const ViewTable& table, Vec2 image) noexcept {
  const Cell cell = cell_at(table, image);
  const Vec3 *upper = table.directions.data() + cell.index, left = upper[0], right = upper[1];
  const Vec3 along = right - left;
  if (table.lines == 1) {
    const Vec3 by_sample = along / table.sample_step, middle = left + cell.u * along;
    const Vec3 by_line = cross(middle, by_sample);  // z cross x = y: image down
    return {middle + (image.y - 0.5) * by_line, by_sample, by_line};
  }
  const Vec3* lower = upper + table.samples;
  const Vec3 below = lower[1] - lower[0], down = lower[0] - left;
  const Vec3 twist = below - along;
  return {left + cell.u * along + cell.v * (down + cell.u * twist),
          (along + cell.v * twist) / table.sample_step, (down + cell.u * twist) / table.line_step};
}

// The node that looks nearest, of a coarse choice.
Vec2 nearest_node(const ViewTable& table, Vec3 towards) {
  const int right = std::max(1, table.samples / 16), down = std::max(1, table.lines / 16);
  double best = -2.0;
  Vec2 place;
  for (int row = 0; row < table.lines; row += down) {
    for (int column = 0; column < table.samples; column += right) {
      const auto index = static_cast<std::size_t>(row) * static_cast<std::size_t>(table.samples) +
                         static_cast<std::size_t>(column);
      const double cosine = dot(table.directions[index], towards);
      if (cosine <= best) continue;
      best = cosine;
      place = {0.5 + column * table.sample_step, 0.5 + row * table.line_step};
    }
  }
  return place;
}

// How far a line of sight misses, and the step in pixels that would mend it (Gauss and Newton).
struct Miss {
  double squared = 0.0;
  Vec2 step;
};

Miss miss(const ViewTable& table, Vec2 image, Vec3 towards) {
  const Sight sight = sight_at(table, image);
  const double size = length(sight.direction);
  const Vec3 unit = sight.direction / size;
  const auto sideways = [&](Vec3 v) { return (v - dot(v, unit) * unit) / size; };
  const double ahead = dot(towards, unit);
  if (!(ahead > 0.0)) return {4.0, {}};
  const Vec3 e1 = sideways(sight.by_sample), e2 = sideways(sight.by_line);
  const Vec3 gap = towards / ahead - unit;
  const double a = dot(e1, e1), b = dot(e1, e2), c = dot(e2, e2);
  const double p = dot(e1, gap), q = dot(e2, gap), determinant = a * c - b * b;
  if (!(determinant > 0.0)) return {4.0, {}};
  return {dot(gap, gap), {(c * p - b * q) / determinant, (a * q - b * p) / determinant}};
}

void check_neighbours(const ViewTable& table, std::size_t index, std::size_t next) {
  const double cosine = std::cos(std::numbers::pi / 18.0);
  if (dot(table.directions[index], table.directions[next]) >= cosine) return;
  throw InputError{"the lines of sight of nodes " + std::to_string(index) + " and " +
                   std::to_string(next) + " of the view table are more than 10 degrees apart"};
}

}  // namespace

Vec3 direction(const ViewTable& table, Vec2 image) noexcept {
  return normalised(sight_at(table, image).direction);
}

std::optional<Vec2> place_of(const ViewTable& table, Vec3 towards) {
  Vec2 place = nearest_node(table, towards);
  Miss now = miss(table, place, towards);
  for (int i = 0; i < 50; ++i) {
    if (now.squared >= 4.0) return std::nullopt;
    if (std::hypot(now.step.x, now.step.y) < 1e-10) return place;
    double share = 1.0;  // halved while the step makes it worse: the surface has creases
    Vec2 there;
    Miss then;
    do {
      there = {place.x + share * now.step.x, place.y + share * now.step.y};
      then = miss(table, there, towards);
      share *= 0.5;
    } while (then.squared > now.squared && share > 1e-6);
    // No better for rounding: as near as it gets.
    if (then.squared >= now.squared) break;
    place = there;
    now = then;
  }
  if (std::hypot(now.step.x, now.step.y) < 1e-7) return place;
  return std::nullopt;
}

std::shared_ptr<const ViewTable> checked(ViewTable table) {
  if (table.samples < 2 || table.lines < 1) {
    throw InputError{"a view table has at least 2 columns and 1 row"};
  }
  if (!(table.sample_step > 0.0) || !(table.line_step > 0.0) ||
      !std::isfinite(table.sample_step + table.line_step)) {
    throw InputError{"the steps of a view table must be above 0 pixels"};
  }
  const auto columns = static_cast<std::size_t>(table.samples);
  const std::size_t nodes = columns * static_cast<std::size_t>(table.lines);
  if (table.directions.size() != nodes) {
    throw InputError{"a view table of " + std::to_string(table.samples) + " x " +
                     std::to_string(table.lines) + " nodes has " +
                     std::to_string(table.directions.size()) + " lines of sight"};
  }
  for (std::size_t i = 0; i < nodes; ++i) {
    const double size = length(table.directions[i]);
    if (!(size > 0.0) || !std::isfinite(size)) {
      throw InputError{"line of sight " + std::to_string(i) +
                       " of the view table is not finite or of no length"};
    }
    table.directions[i] = table.directions[i] / size;
  }
  for (std::size_t i = 0; i < nodes; ++i) {
    if ((i + 1) % columns != 0) check_neighbours(table, i, i + 1);
    if (i + columns < nodes) check_neighbours(table, i, i + columns);
  }
  return std::make_shared<const ViewTable>(std::move(table));
}

}  // namespace nadir::sensor
