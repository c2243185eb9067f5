#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spectral/curve.hpp"

namespace nadir::sim {

/// What a spectrum file tabulates; it fixes the unit and the range of the values.
enum class SpectrumQuantity {
  reflectance,             ///< directional-hemispherical, 1, in [0, 1]
  emissivity,              ///< 1, in [0, 1]
  transmittance,           ///< 1, in [0, 1]
  response,                ///< relative, 1, >= 0
  irradiance,              ///< W m^-2 um^-1, >= 0
  radiance,                ///< W m^-2 sr^-1 um^-1, >= 0
  refractive_index,        ///< real part n, 1, >= 0; the column `k` of such a file is the one below
  extinction_coefficient,  ///< imaginary part k of the refractive index, 1, >= 0
  attenuation,             ///< absorption or scattering coefficient of a volume, 1/m, >= 0
  parameter,               ///< of a scattering model, 1, any
  flux,                    ///< of a lamp in all directions together, W um^-1, >= 0
};

/// The quantity's name in files, such as "reflectance".
[[nodiscard]] std::string_view name_of(SpectrumQuantity quantity) noexcept;
/// The unit that a file of this quantity must state.
[[nodiscard]] std::string_view unit_of(SpectrumQuantity quantity) noexcept;

/// One named column, at its own wavelengths: rows whose cell is empty are not in it.
struct SpectrumColumn {
  std::string name;
  std::vector<double> wavelength_um;  ///< vacuum, positive, strictly ascending, at least two
  std::vector<double> value;          ///< as many, finite
};

/// A spectrum file as docs/formats.md, section Spectra, describes it. Lines of a key that may
/// repeat are joined by "; ".
struct SpectrumFile {
  std::string path;  ///< as it stands in messages
  std::string title;
  std::optional<SpectrumQuantity> quantity;  ///< empty for a plain table, which does not say
  std::string unit;
  std::string source;
  std::string licence;
  std::string made_by;
  std::vector<std::string> notes;  ///< `extended`, `thinned` and `note`, as "key: value"
  std::vector<SpectrumColumn> columns;

  [[nodiscard]] std::vector<std::string> column_names() const;
  /// The column of that name, or the only one for an empty name.
  /// @throws InputError naming the file, with the nearest or all column names as the hint
  [[nodiscard]] const SpectrumColumn& column(const std::string& name) const;
};

/// Reads the text of a spectrum file; `path` only stands in messages.
/// @param plain_as  the quantity that a plain table is checked as; none: any finite number
/// @throws InputError with every mistake found, each with file, line and column
[[nodiscard]] SpectrumFile parse_spectrum(std::string_view text, const std::string& path,
                                          std::optional<SpectrumQuantity> plain_as = std::nullopt);

/// Reads a file. @throws InputError if it cannot be opened or has mistakes
[[nodiscard]] SpectrumFile read_spectrum_file(
    const std::filesystem::path& path, std::optional<SpectrumQuantity> plain_as = std::nullopt);

/// One column of a file as a curve. In a file of refractive_index the column `k` holds the
/// extinction coefficient, all others the real part: `gold.csv#n`, `gold.csv#k`.
/// @param column   its name; empty if the file has only one
/// @param expected what the caller needs: a file or column that holds something else is an error
/// @throws InputError
[[nodiscard]] spectral::Curve read_curve(const std::filesystem::path& path,
                                         const std::string& column, SpectrumQuantity expected,
                                         spectral::Outside outside);

/// The same from a file that was read.
[[nodiscard]] spectral::Curve curve_in(const SpectrumFile& file, const std::string& column,
                                       SpectrumQuantity expected, spectral::Outside outside);

/// `file.csv#column`, as attributes name a column; the column is empty without a `#`.
struct SpectrumReference {
  std::filesystem::path path;
  std::string column;
};
[[nodiscard]] SpectrumReference parse_spectrum_reference(const std::string& text);

}  // namespace nadir::sim
