#include "thermal/temperature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"

namespace nadir::thermal {
namespace {

/// What the heat balance keeps its temperatures within (conduction/column.hpp).
constexpr TemperatureRange solved_range{Kelvin{2.7}, Kelvin{2000.0}};
void check_kelvin(double value) {
  if (!std::isfinite(value) || value < 0.0) {
    throw InputError{"a temperature is " + std::to_string(value) + " K, expected at least 0 K"};
  }
}

void check_source(const ConstantTemperature& source) { check_kelvin(source.value.value); }

void check_source(const MappedTemperature& source) {
  const auto pixels =
      static_cast<std::size_t>(source.frame.columns) * static_cast<std::size_t>(source.frame.rows);
  if (pixels == 0 || source.kelvin.size() != pixels) {
    throw InputError{"a map of temperatures has " + std::to_string(source.kelvin.size()) +
                     " values for " + std::to_string(pixels) + " pixels"};
  }
  for (const float value : source.kelvin) check_kelvin(static_cast<double>(value));
}

void check_source(const VertexTemperature& source) {
  if (!source.scene) throw InputError{"temperatures of vertices without a scene"};
}

void check_source(const SolvedTemperature& source) {
  if (!source.solver) throw InputError{"temperatures to be solved without a heat balance"};
}

void check_source(const UnaskedTemperature& /*source*/) {}

/// Bilinear between the centres of pixels; at the edges, or across them where the map repeats.
double value_at(const MappedTemperature& map, Vec2 place) {
  const Vec2 p = map.frame.pixels(place);
  const double x = std::floor(p.x - 0.5), y = std::floor(p.y - 0.5);
  const double u = p.x - 0.5 - x, v = p.y - 0.5 - y;
  const auto pixel = [&](double column, double row) {
    return static_cast<double>(map.kelvin[map.frame.pixel_at({column + 0.5, row + 0.5})]);
  };
  return (1.0 - v) * ((1.0 - u) * pixel(x, y) + u * pixel(x + 1.0, y)) +
         v * ((1.0 - u) * pixel(x, y + 1.0) + u * pixel(x + 1.0, y + 1.0));
}

Kelvin kelvin_at(const ConstantTemperature& source, const geometry::Hit& /*hit*/) {
  return source.value;
}

Kelvin kelvin_at(const MappedTemperature& source, const geometry::Hit& hit) {
  const bool draped = source.frame.by == materials::MapFrame::By::ground;
  return Kelvin{value_at(source, draped ? Vec2{hit.position.x, hit.position.y} : hit.texture)};
}

Kelvin kelvin_at(const VertexTemperature& source, const geometry::Hit& hit) {
  const double value = source.gain * source.scene->vertex_value(hit) + source.offset_k;
  return Kelvin{value > 0.0 ? value : 0.0};  // NaN, where a mesh gives none, does not emit
}

Kelvin kelvin_at(const SolvedTemperature& source, const geometry::Hit& hit) {
  return source.solver->at(hit);
}

Kelvin kelvin_at(const UnaskedTemperature& /*source*/, const geometry::Hit& /*hit*/) {
  return Kelvin{std::numeric_limits<double>::quiet_NaN()};
}

TemperatureRange range_of(const ConstantTemperature& source) {
  return {source.value, source.value};
}
TemperatureRange range_of(const MappedTemperature& source) {
  const auto [lo, hi] = std::minmax_element(source.kelvin.begin(), source.kelvin.end());
  return {Kelvin{static_cast<double>(*lo)}, Kelvin{static_cast<double>(*hi)}};
}
TemperatureRange range_of(const VertexTemperature& source) { return {Kelvin{0.0}, source.hottest}; }
TemperatureRange range_of(const SolvedTemperature& /*source*/) { return solved_range; }
TemperatureRange range_of(const UnaskedTemperature& /*source*/) { return {}; }

}  // namespace

TemperatureField::TemperatureField(std::vector<TemperatureSource> by_material)
    : by_material_{std::move(by_material)} {
  for (const TemperatureSource& source : by_material_) {
    std::visit([](const auto& one) { check_source(one); }, source);
    range_.push_back(std::visit([](const auto& one) { return range_of(one); }, source));
  }
}

Kelvin TemperatureField::at(const geometry::Hit& hit) const {
  return std::visit([&](const auto& source) { return kelvin_at(source, hit); },
                    by_material_[hit.material]);
}

std::optional<Kelvin> TemperatureField::constant(std::size_t material) const noexcept {
  const auto* source = std::get_if<ConstantTemperature>(&by_material_[material]);
  return source != nullptr ? std::optional{source->value} : std::nullopt;
}

Kelvin TemperatureField::warmest_expected(std::size_t material) const noexcept {
  const auto* solved = std::get_if<SolvedTemperature>(&by_material_[material]);
  return solved != nullptr ? solved->warmest : range_[material].hottest;
}

const materials::MapFrame* TemperatureField::map_frame(std::size_t material) const noexcept {
  const auto* map = std::get_if<MappedTemperature>(&by_material_[material]);
  return map != nullptr ? &map->frame : nullptr;
}

bool TemperatureField::solved(std::size_t material) const noexcept {
  return std::holds_alternative<SolvedTemperature>(by_material_[material]);
}

}  // namespace nadir::thermal
