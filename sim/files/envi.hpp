#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

// ENVI raster files: planes of numbers one after the other (BSQ, little endian) in `name.img`, and
// a text header beside it in `name.hdr`. Keywords: ENVI header file format, L3Harris Geospatial,
// "ENVI Header Files"; `data units` is ours.

namespace nadir::sim {

/// What the header says about the planes.
struct EnviHeader {
  int samples = 0, lines = 0;
  std::string description;
  std::string sensor_type;
  std::string acquisition_time;          ///< ISO 8601, UTC
  std::string data_units;                ///< of all planes, or empty where they differ
  std::vector<std::string> band_names;   ///< one a plane; names also go without comma and brace
  std::vector<double> wavelength_um;     ///< one a plane, or none
  std::vector<double> fwhm_um;           ///< one a plane, or none
  std::vector<std::string> class_names;  ///< of the ids 0, 1, ..., or none
  bool nan_is_no_data = false;           ///< whether readers may treat NaN as "nothing there"
};

/// Writes `image` (by habit `name.img`) and its header. Each name appears only with its whole
/// content, and a new header never stands beside an old image. A comma, brace or line break in a
/// list's name would break the header's syntax and is written as an underscore.
/// @throws std::runtime_error when a file cannot be written, std::invalid_argument when sizes
///         do not agree.
void write_envi(const std::filesystem::path& image, const EnviHeader& header,
                const std::vector<std::span<const float>>& planes);
void write_envi(const std::filesystem::path& image, const EnviHeader& header,
                const std::vector<std::span<const std::uint32_t>>& planes);

/// What `write_envi` wrote.
struct EnviImage {
  EnviHeader header;
  std::variant<std::vector<std::vector<float>>, std::vector<std::vector<std::uint32_t>>> planes;
};

/// Reads an image of the kind that `write_envi` writes: BSQ, little endian, float32 or uint32.
/// @throws InputError naming what is missing or not of that kind.
[[nodiscard]] EnviImage read_envi(const std::filesystem::path& image);

/// Where the header of an image lies: the same name with the extension `.hdr`.
[[nodiscard]] std::filesystem::path envi_header_of(const std::filesystem::path& image);

}  // namespace nadir::sim
