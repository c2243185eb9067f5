#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "sim/scenario/build_context.hpp"

// What the materials of a scenario and those of a library are built from.

namespace nadir::sim {

/// The scattering model that the element holds, if any; parts of a mixture are left out. More
/// than one is a mistake.
[[nodiscard]] std::optional<ScatteringInput> build_scattering(const BuildContext& context,
                                                              const CheckedElement& material);

/// Name, spectra, scattering model and relief; checks that they go together.
[[nodiscard]] MaterialInput build_material_data(const BuildContext& context,
                                                const CheckedElement& element);

/// Tells of a transmittance that the material's model has no use for.
void check_transmittance(const BuildContext& context, const CheckedElement& element,
                         const MaterialInput& material);

/// The element of the scattering model, or null.
[[nodiscard]] const CheckedElement* scattering_element(const CheckedElement& material);

/// Finds the material that a part of a mixture names: its number in the list, or nothing after a
/// mistake.
using FindPart = std::function<std::optional<std::size_t>(const CheckedElement& part)>;

/// Fills in the parts of all mixtures. One that contains itself is a mistake.
/// @param elements  of the materials, in the same order
void resolve_mixtures(const BuildContext& context,
                      const std::vector<const CheckedElement*>& elements, const FindPart& find,
                      std::vector<MaterialInput>& materials);

/// Where a map lies: attributes of <relief>, <material_map> and <contrast_map>.
[[nodiscard]] MapPlaceInput build_map_place(const BuildContext& context,
                                            const CheckedElement& element);

/// The maps of materials, and the materials that contrast maps add.
void build_maps(const BuildContext& context, const CheckedElement& element, MaterialNames& names,
                Scenario& scenario);

}  // namespace nadir::sim
