#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sim/scenario/source_text.hpp"

namespace nadir::sim {

struct XmlAttribute {
  std::string name;
  std::string value;  ///< entities replaced
  std::size_t offset = 0;
};

/// An element as plain data. Offsets are into the document's source text.
struct XmlElement {
  std::string name;
  std::size_t offset = 0;
  std::vector<XmlAttribute> attributes;
  std::vector<XmlElement> children;
  std::optional<std::size_t> stray_text;  ///< of text other than blanks directly inside

  [[nodiscard]] const XmlAttribute* attribute(const std::string& name) const;
};

/// Parses XML. The only place that knows tinyxml2.
/// @throws InputError with line and column for text that is not well-formed
[[nodiscard]] XmlElement parse_xml(const SourceText& source);

}  // namespace nadir::sim
