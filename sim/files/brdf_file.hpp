#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "materials/scattering/brdf_table.hpp"

namespace nadir::sim {

/// A file of measured reflectance: the table, in sr^-1 and radians, and where it comes from.
struct BrdfFile {
  std::string title, source, licence;
  materials::BrdfTable table;
};

/// Reads a table of measured reflectance as docs/formats.md describes it.
/// @throws InputError with every mistake of the file (20 in full), each with line and column:
/// holes,
///         rows twice or out of order, negative and non-finite values among them
[[nodiscard]] BrdfFile read_brdf_file(const std::filesystem::path& file);

/// The same from text; `name` stands in messages.
[[nodiscard]] BrdfFile parse_brdf_file(std::string_view text, const std::string& name);

}  // namespace nadir::sim
