#pragma once

#include "sim/files/spectrum_file.hpp"
#include "sim/run/input_files.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// The curve that a scenario's spectral quantity means: a constant, or a column of a file.
/// @throws InputError from the file's reader
[[nodiscard]] spectral::Curve curve_of(const SpectralInput& input, SpectrumQuantity quantity,
                                       spectral::Outside outside, InputFiles& files);

}  // namespace nadir::sim
