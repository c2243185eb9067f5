#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "radiometry/lamps/lamp.hpp"

namespace nadir::sim {

/// What a photometric file says of a luminaire.
struct IesFile {
  /// cd, ballast factors and multiplier included. Horizontal angles from 90 to 270 degrees have
  /// become a whole turn.
  radiometry::IntensityTable candela;
  double lumens = 0.0;  ///< that leave the luminaire: the integral of its candela
  double lamp_lumens =
      0.0;             ///< of its bare lamps; 0 where the file states none (absolute photometry)
  double watts = 0.0;  ///< electrical
};

/// Reads a file of ANSI/IESNA LM-63 (1986, 1991, 1995, 2002; the layout of 2019 is the same), type
/// C photometry, TILT=NONE. docs/formats.md, section Lamps, says what is accepted.
/// @throws InputError with line and column
[[nodiscard]] IesFile read_ies(const std::filesystem::path& file);
/// The same from text; `name` stands in messages.
[[nodiscard]] IesFile parse_ies(std::string_view text, const std::string& name);

}  // namespace nadir::sim
