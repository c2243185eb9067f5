#include "materials/scattering/direction_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "materials/scattering/local_direction.hpp"

namespace nadir::materials {
namespace {

using std::numbers::pi;

constexpr std::size_t view_count = 16, row_count = 32, column_count = 32;
constexpr std::size_t cell_count = row_count * column_count;
constexpr double cosine_share = 0.1;
constexpr double cell_solid_angle = 2.0 * pi / cell_count;  // both halves of the turn

std::size_t cell_of(double share, std::size_t count) {
  return std::min(static_cast<std::size_t>(share * static_cast<double>(count)), count - 1);
}

/// Unit vector in the plane towards which a view leans; x for one along the normal.
Vec2 heading(Vec3 wo) {
  const double across = std::sqrt(wo.x * wo.x + wo.y * wo.y);
  return across > 0.0 ? Vec2{wo.x / across, wo.y / across} : Vec2{1.0, 0.0};
}

/// Index drawn from a cumulative row, and where within its step, as a share.
struct Pick {
  std::size_t index;
  double within;
};

Pick pick(const float* cumulative, std::size_t count, double u) {
  const float* const end = cumulative + count;
  const float* const found = std::upper_bound(cumulative, end - 1, static_cast<float>(u));
  const auto index = static_cast<std::size_t>(found - cumulative);
  const double low = index > 0 ? static_cast<double>(cumulative[index - 1]) : 0.0;
  const double step = static_cast<double>(cumulative[index]) - low;
  return {index, step > 0.0 ? std::clamp((u - low) / step, 0.0, 1.0) : 0.5};
}

/// Running sum, scaled to end at exactly 1.
void accumulate(const double* share, std::size_t count, float* cumulative) {
  double total = 0.0;
  for (std::size_t i = 0; i < count; ++i) total += share[i];
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    sum += share[i];
    cumulative[i] = static_cast<float>(sum / total);
  }
  cumulative[count - 1] = 1.0F;
}

/// Mean of f mu over a cell from two points on its diagonal.
double cell_mean(const std::function<double(Vec3, Vec3)>& f, Vec3 wo, std::size_t row,
                 std::size_t column) {
  double sum = 0.0;
  for (const double i : {0.25, 0.75}) {
    const double mu = (static_cast<double>(row) + i) / row_count;
    const double azimuth = pi * (static_cast<double>(column) + 1.0 - i) / column_count;
    sum += mu * f(local_direction(mu, azimuth), wo);
  }
  return 0.5 * sum;
}

}  // namespace

DirectionTable::DirectionTable(const std::function<double(Vec3 wi, Vec3 wo)>& f)
    : density_(view_count * cell_count),
      columns_(view_count * cell_count),
      rows_(view_count * row_count) {
  for (std::size_t view = 0; view < view_count; ++view) tabulate(view, f);
}

void DirectionTable::tabulate(std::size_t view, const std::function<double(Vec3 wi, Vec3 wo)>& f) {
  const Vec3 wo = local_direction((static_cast<double>(view) + 0.5) / view_count, 0.0);
  std::array<double, cell_count> share{};
  double total = 0.0;
  for (std::size_t cell = 0; cell < cell_count; ++cell) {
    share[cell] = std::max(0.0, cell_mean(f, wo, cell / column_count, cell % column_count));
    total += share[cell];
  }
  std::array<double, row_count> row_share{};
  for (std::size_t cell = 0; cell < cell_count; ++cell) {
    const std::size_t row = cell / column_count;
    const double mu = (static_cast<double>(row) + 0.5) / row_count;
    const double by_cosine = 2.0 * mu / cell_count;
    share[cell] = total > 0.0
                      ? (1.0 - cosine_share) * share[cell] / total + cosine_share * by_cosine
                      : by_cosine;
    row_share[row] += share[cell];
  }
  float* const rows = &rows_[view * row_count];
  accumulate(row_share.data(), row_count, rows);
  for (std::size_t row = 0; row < row_count; ++row) {
    const std::size_t at = view * cell_count + row * column_count;
    accumulate(&share[row * column_count], column_count, &columns_[at]);
    // The density is that of the rounded cumulative rows, which `draw` uses.
    const double row_chance =
        static_cast<double>(rows[row]) - (row > 0 ? static_cast<double>(rows[row - 1]) : 0.0);
    for (std::size_t column = 0; column < column_count; ++column) {
      const double low = column > 0 ? static_cast<double>(columns_[at + column - 1]) : 0.0;
      const double chance = static_cast<double>(columns_[at + column]) - low;
      density_[at + column] = static_cast<float>(row_chance * chance / cell_solid_angle);
    }
  }
}

double DirectionTable::pdf(Vec3 wi, Vec3 wo) const noexcept {
  const Vec2 ahead = heading(wo);
  const double along = wi.x * ahead.x + wi.y * ahead.y;
  const double aside = std::abs(wi.y * ahead.x - wi.x * ahead.y);
  const std::size_t row = cell_of(wi.z, row_count);
  const std::size_t column = cell_of(std::atan2(aside, along) / pi, column_count);
  const std::size_t view = cell_of(wo.z, view_count);
  return static_cast<double>(density_[view * cell_count + row * column_count + column]);
}

Vec3 DirectionTable::draw(Vec3 wo, Vec2 u) const noexcept {
  const std::size_t view = cell_of(wo.z, view_count);
  const Pick row = pick(&rows_[view * row_count], row_count, u.x);
  const bool left = u.y < 0.5;
  const Pick column = pick(&columns_[view * cell_count + row.index * column_count], column_count,
                           2.0 * (left ? u.y : u.y - 0.5));
  const double mu = std::min(1.0, (static_cast<double>(row.index) + row.within) / row_count);
  const double turn = pi * (static_cast<double>(column.index) + column.within) / column_count;
  const Vec3 local = local_direction(mu, left ? turn : -turn);
  const Vec2 ahead = heading(wo);
  return {local.x * ahead.x - local.y * ahead.y, local.x * ahead.y + local.y * ahead.x, local.z};
}

}  // namespace nadir::materials
