#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/files/substance_table.hpp"
#include "thermal/conduction/layers.hpp"

namespace nadir::sim {

inline constexpr double joule_per_calorie = 4.184;  ///< thermochemical, exact (NIST SP 811, B.8)

/// What was done with a line of the file.
struct ThermNote {
  int line = 0;
  std::string text;
  bool warning = false;  ///< the value may not be what it is taken for
};

/// A material's thermal values in SI units.
struct ThermMaterial {
  std::string name;   ///< fit for a table of substances: letters, digits, underscores
  std::string given;  ///< as the file has it
  int line = 0;
  thermal::Substance substance;
  std::optional<double> thickness_m;
  std::optional<double> solar_absorptance, emissivity;
  std::vector<ThermNote> notes;
};

struct ThermValues {
  std::string file;
  std::vector<ThermMaterial> materials;
  std::vector<ThermNote> notes;  ///< of lines that belong to no material
};

/// Thermal values in calorie units, as material files for the THERM temperature model have them:
/// KEY = VALUE, one a line, in blocks MATERIAL_ENTRY { ... TEMP_SOLVER { ... } } or bare; # and //
/// begin comments. Other blocks are passed over, and a note says so.
///
///     SPECIFIC_HEAT         cal g^-1 C^-1        x 4184        J kg^-1 K^-1
///     THERMAL_CONDUCTIVITY  cal cm^-1 h^-1 C^-1  x 418.4/3600  W m^-1 K^-1
///     MASS_DENSITY          g cm^-3              x 1000        kg m^-3
///     THICKNESS             cm                   x 0.01        m
///     SOLAR_ABSORPTION or VISIBLE_EMISSIVITY, THERMAL_EMISSIVITY   0 to 1, as they are
///
/// The calorie is the thermochemical one, 4.184 J; a langley is a calorie per cm^2, so that
/// conductivities in langley cm h^-1 C^-1 are the same numbers. EXPOSED_AREA, SKY_EXPOSURE and
/// SPECULARITY have no counterpart; notes say what takes their place.
/// @throws InputError with every mistake of the text: unknown keys with the nearest known one,
///         values that are no numbers or out of range, keys given twice, keys that are missing
[[nodiscard]] ThermValues parse_therm(std::string_view text, const std::string& name);

/// Reads a file. @throws InputError as above, or if it cannot be read
[[nodiscard]] ThermValues read_therm(const std::filesystem::path& file);

/// All that was done, line by line, and the <heat_balance> of each material.
[[nodiscard]] std::string therm_report(const ThermValues& values);

/// The material as <heat_balance>, its layer with figures of its own, rounded to 6 digits.
[[nodiscard]] std::string heat_balance_xml(const ThermMaterial& material);

/// The materials as a table of substances (substance_table.hpp), rounded likewise.
[[nodiscard]] std::string therm_csv(const ThermValues& values);

}  // namespace nadir::sim
