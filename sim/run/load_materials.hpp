#pragma once

#include <vector>

#include "materials/material.hpp"
#include "sim/run/input_files.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// A material with its spectra read. @throws InputError
[[nodiscard]] materials::Material load_material(const MaterialInput& input, InputFiles& files);

/// All materials of a scenario, in its order. @throws InputError with the mistakes of all files
[[nodiscard]] std::vector<materials::Material> load_materials(const Scenario& scenario,
                                                              InputFiles& files);

}  // namespace nadir::sim
