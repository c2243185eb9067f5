#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "sim/files/air_runs.hpp"

namespace nadir::sim {

/// Cases of the CSV output of MODTRAN 6 (FILEOPTIONS, CSVPRNT), one or more in a file: whatever
/// lines first, one with the columns' names, then rows of numbers, until one that begins with
/// -9999, that is no number, or the end. Names are those of tape7 or of MODTRAN 6; the first is
/// FREQ, or a wavelength. A line of units below the names may say nm or um.
///
/// Radiances are W cm^-2 sr^-1 per cm^-1 over wavenumber, W cm^-2 sr^-1 um^-1 over wavelength in
/// um, uW cm^-2 sr^-1 nm^-1 over nm (MODTRAN's FLAGS W, M, N). A file says nothing of where it
/// looks: `geometry` does, a case each.
///
/// Layout after programs that read such files: F. Xu and G. Cervone, MODTRANSimulation
/// (github.com/FangcaoXu), whose readers skip six lines, name sixteen columns and drop the last
/// row. The order of columns is taken from the names, not from there.
/// @throws InputError with file and line; another number of cases than of geometries
[[nodiscard]] AirRunSet read_modtran_csv(const std::filesystem::path& file,
                                         std::span<const RunGeometry> geometry,
                                         const AirRunSettings& settings);

/// The same from text; `name` stands in messages.
[[nodiscard]] AirRunSet parse_modtran_csv(std::string_view text, const std::string& name,
                                          std::span<const RunGeometry> geometry,
                                          const AirRunSettings& settings);

}  // namespace nadir::sim
