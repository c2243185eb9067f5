#pragma once

#include "geometry/scene_builder.hpp"
#include "sim/run/input_files.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// What an object looks like, in its own axes: its mesh read and a material found for every part.
/// @throws InputError from the mesh's reader, for a part that the mesh does not have, and for a
/// part
///         that has no material
[[nodiscard]] geometry::Surface read_surface(const FormInput& form, InputFiles& files);

}  // namespace nadir::sim
