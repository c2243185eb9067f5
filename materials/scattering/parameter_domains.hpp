#pragma once

#include "materials/scattering/bind_context.hpp"
#include "materials/scattering/models.hpp"

namespace nadir::materials {

/// Checks what a scattering model states by itself against the domains in models.hpp, at the lanes.
/// Curves that are held beyond their table are reported to `context.diagnostics`.
/// @throws InputError without location, with every parameter that is out of its domain, not a
///         number, or not tabulated at the lanes
void check_parameters(const Scattering& model, const BindContext& context);

}  // namespace nadir::materials
