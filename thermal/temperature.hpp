#pragma once

#include <variant>
#include <vector>

#include "core/quantity.hpp"
#include "geometry/scene.hpp"

namespace nadir::thermal {

/// The same temperature everywhere on the material.
struct ConstantTemperature {
  Kelvin value;  ///< >= 0; 0 K: the surface does not emit
};

/// Where a surface's temperature comes from. Maps, tables and the heat balance will be further
/// alternatives.
using TemperatureSource = std::variant<ConstantTemperature>;

/// Surface temperatures of a scene.
class TemperatureField {
 public:
  /// @param by_material  a source for each material index that hits can carry
  /// @throws InputError  for a negative or non-finite temperature
  explicit TemperatureField(std::vector<TemperatureSource> by_material);

  /// Kinetic temperature of the surface at a hit.
  [[nodiscard]] Kelvin at(const geometry::Hit& hit) const noexcept;
  [[nodiscard]] const TemperatureSource& source(std::size_t material) const {
    return by_material_[material];
  }
  [[nodiscard]] std::size_t size() const noexcept { return by_material_.size(); }

 private:
  std::vector<TemperatureSource> by_material_;
};

}  // namespace nadir::thermal
