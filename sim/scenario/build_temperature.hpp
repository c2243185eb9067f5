#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/scenario/build_context.hpp"

// Sources of temperature, as materials have them.

namespace nadir::sim {

/// A temperature that the file gives in K or in deg C, as `name`_k or `name`_c. Both are a mistake.
[[nodiscard]] std::optional<double> build_kelvin(const BuildContext& context,
                                                 const CheckedElement& element,
                                                 const std::string& name);
/// Whether the file gives it in either unit, be it valid or not.
[[nodiscard]] bool gives_kelvin(const CheckedElement& element, const std::string& name);
/// The attribute that the file gives, for the place of a mistake.
[[nodiscard]] std::size_t where_kelvin(const CheckedElement& element, const std::string& name);

/// Tells of each of these attributes that the file gives, though they are for `purpose` alone.
void keep_for(const BuildContext& context, const CheckedElement& element,
              const std::vector<std::string>& attributes, const std::string& purpose);

[[nodiscard]] HeatBalanceInput build_heat_balance(const BuildContext& context,
                                                  const CheckedElement& element);
[[nodiscard]] TemperatureRasterInput build_temperature_raster(const BuildContext& context,
                                                              const CheckedElement& element);

/// Where a material's spectra come from.
enum class MadeFrom {
  itself,
  library,
  unknown  ///< its library or name is missing, which was told
};

/// The sources of temperature of a scenario's materials, one material after the other.
class MaterialTemperatures {
 public:
  /// @param materials  the list, whose default holds for what has no source of its own
  /// @param has_heat   whether the scenario has <heat>
  MaterialTemperatures(const BuildContext& context, const CheckedElement& materials, bool has_heat);

  /// Sets the material's source. With solve="true" that is the heat balance that it brings from its
  /// library.
  void add(const CheckedElement& element, MadeFrom made_from, MaterialInput& material);
  /// Tells of materials that have no source at all, and of weather that nobody needs.
  void finish(const CheckedElement* heat) const;

 private:
  [[nodiscard]] TemperatureInput solved(const CheckedElement& element, MadeFrom made_from,
                                        const MaterialInput& material) const;
  void check_weather(std::size_t where, const MaterialInput& material);

  const BuildContext& context_;
  const CheckedElement& list_;
  bool has_heat_;
  bool needs_heat_ = false;
  std::optional<double> default_k_;
  std::vector<std::string> without_;  // names of materials that have no temperature
};

/// Tells of a material that takes its temperatures from vertices on a surface that has none.
/// @param element   whose attribute names the material
/// @param material  its index or, beyond the materials, that of a map
void refuse_vertices(const BuildContext& context, const CheckedElement& element, int material,
                     const Scenario& scenario);

}  // namespace nadir::sim
