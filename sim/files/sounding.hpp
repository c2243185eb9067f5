#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "atmosphere/gases/band_tables.hpp"
#include "atmosphere/profile.hpp"
#include "core/diagnostics.hpp"

namespace nadir::sim {

/// Reads a sounding (CSV, docs/air-gases.md): height_m, pressure_hpa, temperature_k or
/// temperature_c, one column of humidity (relative_humidity_percent, dewpoint_c, mixing_ratio_g_kg
/// or h2o_ppmv), optionally o3_ppmv; rows ascend. Above its top the air is that of a standard
/// profile, scaled in pressure to join; the other gases are the standard profile's throughout.
/// @param diagnostics  told where heights and pressures disagree by more than 5 %
/// @throws InputError with file, line and column: columns missing or too many, fewer than two rows,
///         heights that do not ascend, pressures that do not fall, temperatures outside 150 to 340
///         K, humidity above 102 %, heights and pressures that disagree by more than 20 %
[[nodiscard]] atmosphere::Profile read_sounding(const std::filesystem::path& file,
                                                const atmosphere::Profile& standard,
                                                Diagnostics& diagnostics);
/// The same from text; `name` stands in messages and names the profile.
[[nodiscard]] atmosphere::Profile parse_sounding(std::string_view text, const std::string& name,
                                                 const atmosphere::Profile& standard,
                                                 Diagnostics& diagnostics);

}  // namespace nadir::sim
