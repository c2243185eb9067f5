#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sim/scenario/source_text.hpp"

namespace nadir::sim {

/// Where an element and its attributes stand in the text: what tinyxml2 does not keep.
struct ScannedAttribute {
  std::string name;
  std::size_t offset = 0;  ///< of the name's first byte
};
struct ScannedElement {
  std::string name;
  std::size_t offset = 0;  ///< of its '<'
  std::vector<ScannedAttribute> attributes;
  std::optional<std::size_t> stray_text;  ///< of the first text other than blanks directly inside
};

/// Elements nested deeper than this are refused; real scenarios need about ten.
inline constexpr std::size_t deepest_element = 64;

/// The elements of an XML text in document order. Checks that the text is well-formed: tinyxml2
/// lets several mistakes pass (a second root, unknown entities, bytes that are not UTF-8) and says
/// no column for the others.
/// @throws InputError at the first mistake: what follows it can no longer be trusted
[[nodiscard]] std::vector<ScannedElement> scan_xml(const SourceText& source);

}  // namespace nadir::sim
