#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace nadir::sim {

/// A picture for the eye: sRGB or grey, 8 or 16 bits a value.
struct PngImage {
  int width = 0, height = 0;
  int channels = 3;                   ///< 1: grey, 3: red, green, blue
  int bits = 8;                       ///< 8 or 16
  std::vector<std::uint16_t> values;  ///< 0 .. 2^bits - 1, row-major, channels together
  std::vector<std::pair<std::string, std::string>> text;  ///< title, software, ...
};

/// Writes the picture. The name appears only with the whole file. Loads the image module on first
/// use.
/// @throws std::runtime_error when the module, the encoder or the system fails,
///         std::invalid_argument when the picture's sizes do not agree.
void write_png(const std::filesystem::path& file, const PngImage& image);

/// Reads a PNG of 1 or 3 channels; its text is not read.
/// @throws std::runtime_error when that fails.
[[nodiscard]] PngImage read_png(const std::filesystem::path& file);

}  // namespace nadir::sim
