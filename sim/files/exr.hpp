#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace nadir::sim {

/// One plane of a multi-channel EXR: floats, or unsigned ids.
struct ExrChannel {
  std::string name;  ///< dots make layers: `radiance.B4`
  std::variant<std::span<const float>, std::span<const std::uint32_t>> values;  ///< row-major
};

/// What stands in the header beside the channels.
using ExrAttribute = std::variant<std::string, std::vector<std::string>, std::vector<float>, int>;

struct ExrImage {
  int samples = 0, lines = 0;
  std::vector<ExrChannel> channels;
  std::map<std::string, ExrAttribute> attributes;
};

/// Writes the image with lossless ZIP compression, 32 bits a value. The name appears only with the
/// whole file.
/// @throws std::runtime_error when the file cannot be written, std::invalid_argument when sizes
///         do not agree or two channels share a name.
void write_exr(const std::filesystem::path& file, const ExrImage& image);

/// A file read back, each channel with values of its own.
struct ExrContents {
  int samples = 0, lines = 0;
  std::map<std::string, std::variant<std::vector<float>, std::vector<std::uint32_t>>> channels;
  std::map<std::string, ExrAttribute> attributes;  ///< those of the kinds of ExrAttribute
};

/// Reads all channels of a single-part scan-line EXR; half-precision channels become floats.
/// @throws std::runtime_error when the file cannot be read.
[[nodiscard]] ExrContents read_exr(const std::filesystem::path& file);

}  // namespace nadir::sim
