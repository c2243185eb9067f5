#pragma once

#include "sim/run/load_materials.hpp"

namespace nadir::sim {

/// A scattering model with its spectra, tables and parts read. @throws InputError
[[nodiscard]] materials::Scattering read_scattering(const ScatteringInput& input,
                                                    MaterialReader& materials);

}  // namespace nadir::sim
