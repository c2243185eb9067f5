#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace nadir::sim {

/// What identifies a file's content.
struct FileDigest {
  std::string sha256;       ///< 64 lower-case hexadecimal digits
  std::uint64_t bytes = 0;  ///< length
};

/// SHA-256 (FIPS 180-4) of a file's content, read in blocks.
/// @throws std::runtime_error when the file cannot be read.
[[nodiscard]] FileDigest digest_file(const std::filesystem::path& file);

/// The same of bytes in memory.
[[nodiscard]] FileDigest digest_bytes(std::string_view bytes);

}  // namespace nadir::sim
