#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "thermal/conduction/layers.hpp"

namespace nadir::sim {

/// A row of a table of substances.
struct ListedSubstance {
  thermal::Substance substance;
  std::optional<double> solar_absorptance;  ///< typical, for information: materials have spectra
  std::optional<double> emissivity;         ///< likewise, long-wave
  std::string checked;                      ///< yes, partly, no or derived
  std::string source;
};
using SubstanceTable = std::map<std::string, ListedSubstance, std::less<>>;

/// Substances by name: a CSV with the columns substance, conductivity_w_m_k, density_kg_m3,
/// specific_heat_j_kg_k, and if wanted solar_absorptance, emissivity (cells may be empty), checked
/// and source, in any order; lines that start with # and blank ones are passed over; cells with
/// commas stand in double quotes. Format: docs/thermal-database.md.
/// @throws InputError with every mistake of the text, each with line and column
[[nodiscard]] SubstanceTable parse_substances(std::string_view text, const std::string& name);

/// Reads a file. @throws InputError as above, or if it cannot be read
[[nodiscard]] SubstanceTable read_substances(const std::filesystem::path& file);

/// The substance of that name.
/// @param where  what asks for it; stands in the message
/// @throws InputError with the nearest name, or with all
[[nodiscard]] const ListedSubstance& find_substance(const SubstanceTable& table,
                                                    const std::string& substance,
                                                    const SourceLocation& where = {});

/// A table that parse_substances reads back, in the order of the names.
/// @param comments  lines for the top, without #
[[nodiscard]] std::string substances_text(const SubstanceTable& table,
                                          const std::vector<std::string>& comments);

}  // namespace nadir::sim
