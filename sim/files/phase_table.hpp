#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "materials/volume/medium.hpp"

namespace nadir::sim {

/// A phase function as a CSV table: the first row is `angle_deg` and the wavelengths in um, every
/// other row a scattering angle and the function at each wavelength, on any scale. Angles ascend
/// from 0 to 180. Blank lines and lines that start with # are passed over.
/// @throws InputError with every mistake of the file (20 in full), each with line and column
[[nodiscard]] materials::TabulatedPhase read_phase_table(const std::filesystem::path& file);

/// The same from text; `name` stands in messages.
[[nodiscard]] materials::TabulatedPhase parse_phase_table(std::string_view text,
                                                          const std::string& name);

}  // namespace nadir::sim
