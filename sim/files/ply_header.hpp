#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/files/text_tokens.hpp"

// The header of a PLY file; used by mesh_ply.cpp alone.

namespace nadir::sim::ply {

enum class Format { ascii, little_endian, big_endian };
enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
  std::string name;
  Type type = Type::float32;
  std::optional<Type> list_count;  ///< type of the count, for a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Format format = Format::ascii;
  std::vector<Element> elements;
  std::string_view body;  ///< what follows
  int lines = 0;          ///< of the header
};

[[nodiscard]] std::size_t size_of(Type type);

/// @throws InputError through `issues`
[[nodiscard]] Header parse_header(std::string_view bytes, FileIssues& issues);

}  // namespace nadir::sim::ply
