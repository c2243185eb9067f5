#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "atmosphere/particles/particle_tables.hpp"

namespace nadir::sim {

/// The figures of haze and clouds. The first line is `# nadir-particles: 1`; other lines that start
/// with # and blank ones are passed over. Four sections, each begun by its name in brackets; in
/// each the first row holds what the columns stand for, every other row its labels and one number a
/// column, separated by commas:
///
///     [optics]           kind,quantity,WAVELENGTH_UM...   quantity: extinction, absorption,
///                                                         asymmetry, each once for every kind
///     [haze]             profile,HEIGHT_KM...             km^-1 at 0.55 um
///     [phase_functions]  number,ANGLE_DEG...              0 to 180, > 0; any numbers, each once
///     [phase_choice]     kind,WAVELENGTH_UM...            the number of a phase function
///
/// @throws InputError with every mistake of the file (20 in full), each with line and column
[[nodiscard]] atmosphere::ParticleTables read_particle_tables(const std::filesystem::path& file);

/// The same from text; `name` stands in messages.
[[nodiscard]] atmosphere::ParticleTables parse_particle_tables(std::string_view text,
                                                               const std::string& name);

}  // namespace nadir::sim
