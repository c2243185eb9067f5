#pragma once
// What the parts of the spectrum reader share; not for others.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "sim/files/spectrum_file.hpp"

namespace nadir::sim::spectrum_format {

/// One entry for each SpectrumQuantity, in its order.
struct QuantityEntry {
  SpectrumQuantity quantity;
  std::string_view name;
  std::string_view unit;
  bool at_most_one;
};
inline constexpr std::array<QuantityEntry, 11> quantity_table{{
    {SpectrumQuantity::reflectance, "reflectance", "1", true},
    {SpectrumQuantity::emissivity, "emissivity", "1", true},
    {SpectrumQuantity::transmittance, "transmittance", "1", true},
    {SpectrumQuantity::response, "response", "1", false},
    {SpectrumQuantity::irradiance, "irradiance", "W m^-2 um^-1", false},
    {SpectrumQuantity::radiance, "radiance", "W m^-2 sr^-1 um^-1", false},
    {SpectrumQuantity::refractive_index, "refractive_index", "1", false},
    {SpectrumQuantity::extinction_coefficient, "extinction_coefficient", "1", false},
    {SpectrumQuantity::attenuation, "attenuation", "m^-1", false},
    {SpectrumQuantity::parameter, "parameter", "1", false},
    {SpectrumQuantity::flux, "flux", "W um^-1", false},
}};

inline const QuantityEntry& entry_of(SpectrumQuantity quantity) noexcept {
  return quantity_table[static_cast<std::size_t>(quantity)];
}

inline std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

inline std::string did_you_mean(const std::string& name, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(name, known);
  return nearest.empty() ? "known are: " + joined(known)
                         : "did you mean " + in_quotes(nearest) + "?";
}

}  // namespace nadir::sim::spectrum_format
