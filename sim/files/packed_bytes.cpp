#include "sim/files/packed_bytes.hpp"

#include <zlib.h>

namespace nadir::sim {
namespace {

const Bytef* input_of(std::string_view bytes) {
  return reinterpret_cast<const Bytef*>(bytes.data());
}

}  // namespace

std::optional<std::string> pack_bytes(std::string_view bytes) {
  uLongf length = compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(length, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(packed.data()), &length, input_of(bytes),
                               static_cast<uLong>(bytes.size()), Z_BEST_SPEED);
  if (status != Z_OK || length >= bytes.size()) return std::nullopt;
  packed.resize(length);
  return packed;
}

std::optional<std::string> unpack_bytes(std::string_view packed, std::size_t length) {
  std::string bytes(length, '\0');
  uLongf found = static_cast<uLongf>(length);
  const int status = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &found, input_of(packed),
                                static_cast<uLong>(packed.size()));
  if (status != Z_OK || found != length) return std::nullopt;
  return bytes;
}

std::uint32_t checksum(std::string_view bytes, std::uint32_t before) {
  if (bytes.empty()) return before;  // zlib takes a null pointer for a new sum
  return static_cast<std::uint32_t>(crc32_z(before, input_of(bytes), bytes.size()));
}

}  // namespace nadir::sim
