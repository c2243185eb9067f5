#include "sim/files/packed_bytes.hpp"

#include <zlib.h>

namespace nadir::sim {
namespace {

const Bytef* input_of(std::string_view bytes) {
  return reinterpret_cast<const Bytef*>(bytes.data());
}

}  // namespace

std::optional<std::string> pack_bytes(std::string_view bytes) {
  z_stream stream{};
  // Runs of one byte alone: on planes of numbers a quarter less time than the full search, 4 % more
  // bytes.
  if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, MAX_WBITS, 8, Z_RLE) != Z_OK) {
    return std::nullopt;
  }
  std::string packed(bytes.size(), '\0');  // no room for more than that: it would not pay
  stream.next_in = const_cast<Bytef*>(input_of(bytes));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int status = deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END || packed.size() >= bytes.size()) return std::nullopt;
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
