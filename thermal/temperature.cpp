#include "thermal/temperature.hpp"

#include <cmath>
#include <string>

#include "core/error.hpp"

namespace nadir::thermal {

TemperatureField::TemperatureField(std::vector<TemperatureSource> by_material)
    : by_material_{std::move(by_material)} {
  for (const TemperatureSource& source : by_material_) {
    const double value = std::get<ConstantTemperature>(source).value.value;
    if (!std::isfinite(value) || value < 0.0) {
      throw InputError{"a temperature is " + std::to_string(value) + " K, expected at least 0 K"};
    }
  }
}

Kelvin TemperatureField::at(const geometry::Hit& hit) const noexcept {
  return std::get<ConstantTemperature>(by_material_[hit.material]).value;
}

}  // namespace nadir::thermal
