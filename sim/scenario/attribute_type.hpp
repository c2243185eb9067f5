#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/vec.hpp"
#include "ephemeris/instant.hpp"
#include "sim/scenario/scenario.hpp"

// The kinds of attribute that the scenario's format knows. The reader (parse_attribute), the XML
// schema (write_xsd) and the reference page (expectation) all follow from one description.

namespace nadir::sim {

/// A finite decimal number within bounds; `above` and `below` leave the bound itself out.
struct NumberType {
  double min = 0.0, max = 0.0;
  bool above = false, below = false;
};
struct IntegerType {
  int min = 0, max = 0;
};
/// Three numbers with blanks between them, or one that stands for all three.
struct VectorType {
  NumberType component;
  bool one_for_all = false;
};
/// Any text that is not blank.
struct TextType {};
/// Letters, digits, _ . - of ASCII; does not begin with . or -.
struct NameType {};
/// One name or several, with blanks between them.
struct NamesType {
  int most = 1;
};
struct EnumerationType {
  std::vector<std::string> values;
};
/// A file; without suffixes of any kind.
struct PathType {
  std::vector<std::string> suffixes;
  bool or_shipped = false;  ///< if it is not beside the file that names it, in the shipped data
};
/// A number for all wavelengths or a spectrum file, with its column after #.
struct SpectralType {
  NumberType number;
};
/// A column of a spectrum file only.
struct ColumnType {};
struct InstantType {};

using AttributeType =
    std::variant<NumberType, IntegerType, VectorType, TextType, NameType, NamesType,
                 EnumerationType, PathType, SpectralType, ColumnType, InstantType>;

[[nodiscard]] inline AttributeType boolean() { return EnumerationType{{"true", "false"}}; }

/// What an attribute's text stands for. Paths are as written: not yet made absolute.
using AttributeValue = std::variant<double, int, Vec3, std::string, std::vector<std::string>,
                                    std::filesystem::path, SpectralInput, ephemeris::Instant>;

/// Either a value or what is wrong with the text.
struct ParsedAttribute {
  std::variant<AttributeValue, std::string> result;
  std::string hint;  ///< the nearest valid value, or empty

  [[nodiscard]] const AttributeValue* value() const { return std::get_if<AttributeValue>(&result); }
};

[[nodiscard]] ParsedAttribute parse_attribute(const AttributeType& type, std::string_view text);

/// What a valid text looks like: `a number from 0 to 1`.
[[nodiscard]] std::string expectation(const AttributeType& type);

/// 0.5, 20000, 1e9: the shortest text that gives the number back.
[[nodiscard]] std::string number_text(double value);

}  // namespace nadir::sim
