#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "core/quantity.hpp"
#include "geometry/scene.hpp"
#include "materials/maps/map_frame.hpp"
#include "thermal/solve/heat_solver.hpp"

namespace nadir::thermal {

/// The same temperature everywhere on the material.
struct ConstantTemperature {
  Kelvin value;  ///< >= 0; 0 K: the surface does not emit
};
/// A raster of temperatures, interpolated bilinearly between pixel centres.
struct MappedTemperature {
  materials::MapFrame frame;
  std::vector<float> kelvin;  ///< row-major, one a pixel, finite, >= 0
};
/// What the mesh gives vertex by vertex: kelvin = gain value + offset.
struct VertexTemperature {
  std::shared_ptr<const geometry::Scene> scene;
  double gain = 1.0, offset_k = 0.0;
  Kelvin hottest{6000.0};  ///< of all that the scene's meshes give
};
/// What the sun heats stays below this.
inline constexpr Kelvin warmest_under_the_sun{400.0};
/// From the heat balance.
struct SolvedTemperature {
  std::shared_ptr<const HeatSolver> solver;
  Kelvin warmest = warmest_under_the_sun;  ///< to be expected: decides who sees it emit
};
/// Nobody asks: no band of the picture sees what the surface emits.
struct UnaskedTemperature {};

/// Where a surface's temperature comes from. Tables over time and the weather's air are constants
/// by the time that a picture is taken.
using TemperatureSource = std::variant<ConstantTemperature, MappedTemperature, VertexTemperature,
                                       SolvedTemperature, UnaskedTemperature>;

/// The temperatures between which a source may lie.
struct TemperatureRange {
  Kelvin coldest, hottest;
};

/// Surface temperatures of a scene.
class TemperatureField {
 public:
  /// @param by_material  a source for each material index that hits can carry
  /// @throws InputError  for a negative or non-finite temperature, a map that is not full
  explicit TemperatureField(std::vector<TemperatureSource> by_material);

  /// Kinetic temperature of the surface at a hit (maps of materials resolved); NaN where nobody was
  /// to ask.
  [[nodiscard]] Kelvin at(const geometry::Hit& hit) const;
  /// The temperature of a material that has the same everywhere.
  [[nodiscard]] std::optional<Kelvin> constant(std::size_t material) const noexcept;
  [[nodiscard]] TemperatureRange range(std::size_t material) const noexcept {
    return range_[material];
  }
  /// How warm a material may be expected to be; never below range() but for what is solved.
  [[nodiscard]] Kelvin warmest_expected(std::size_t material) const noexcept;
  /// Where a material's map of temperatures lies; null where it has none.
  [[nodiscard]] const materials::MapFrame* map_frame(std::size_t material) const noexcept;
  /// Whether its temperatures must be solved for.
  [[nodiscard]] bool solved(std::size_t material) const noexcept;
  [[nodiscard]] std::size_t size() const noexcept { return by_material_.size(); }

 private:
  std::vector<TemperatureSource> by_material_;
  std::vector<TemperatureRange> range_;
};

}  // namespace nadir::thermal
