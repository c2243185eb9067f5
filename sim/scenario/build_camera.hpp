#pragma once

#include <string>
#include <vector>

#include "sim/scenario/build_context.hpp"

// The parts of a camera, shared by scenarios and sensor files.

namespace nadir::sim {

/// The arrays inside <perspective>, <orthographic> or <lines_of_sight>, checked one by one and
/// against each other.
[[nodiscard]] CameraInput build_projection(const BuildContext& context,
                                           const CheckedElement& projection);

[[nodiscard]] BandInput build_band(const BuildContext& context, const CheckedElement& element);
/// The timing in an array; a global shutter where there is none.
[[nodiscard]] TimingInput build_timing(const BuildContext& context, const CheckedElement& array);
/// The modules in an array, ascending.
[[nodiscard]] std::vector<ModuleInput> build_modules(const BuildContext& context,
                                                     const CheckedElement& array);
/// Optics, blur and detector in an array, whose bands, pitch and timing are there already.
void build_detection(const BuildContext& context, const CheckedElement& element, ArrayInput& array);

/// Tells of arrays, and modules of one array, that lie at the same place of the focal plane.
/// @param elements  of the arrays
void check_focal_plane(const BuildContext& context,
                       const std::vector<const CheckedElement*>& elements,
                       const CameraInput& camera);

/// The part of a preset's arrays that <sensor> asks for.
void cut_preset(const BuildContext& context, const CheckedElement& element, CameraInput& camera);

/// The child with one of the names; a second one is a mistake.
/// @param what  these are, for messages
[[nodiscard]] const CheckedElement* single_child(const BuildContext& context,
                                                 const CheckedElement& element,
                                                 const std::vector<std::string>& names,
                                                 const std::string& what);

}  // namespace nadir::sim
