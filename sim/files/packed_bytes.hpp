#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace nadir::sim {

/// The bytes deflated (RFC 1950), fast rather than small; nothing where that would not make them
/// shorter.
/// @param bytes  less than 4 GB
[[nodiscard]] std::optional<std::string> pack_bytes(std::string_view bytes);

/// Back again. @param length  of the result
/// @return nothing where the bytes are not what `pack_bytes` made of that many
[[nodiscard]] std::optional<std::string> unpack_bytes(std::string_view packed, std::size_t length);

/// CRC-32 (ISO-HDLC) of bytes that follow on those whose sum is `before`.
[[nodiscard]] std::uint32_t checksum(std::string_view bytes, std::uint32_t before = 0);

}  // namespace nadir::sim
