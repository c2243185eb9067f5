#include "sim/scenario/xml_document.hpp"

#include <tinyxml2.h>

#include <algorithm>

#include "sim/scenario/xml_scanner.hpp"

namespace nadir::sim {
namespace {

/// Walks tinyxml2's tree in document order beside the scanner's list, which has the positions.
class TreeBuilder {
 public:
  TreeBuilder(const SourceText& source, std::vector<ScannedElement> scanned)
      : source_{source}, scanned_{std::move(scanned)} {}

  XmlElement build(const tinyxml2::XMLElement& parsed) {
    if (next_ >= scanned_.size()) mismatch(source_.text().size());
    const ScannedElement& scanned = scanned_[next_++];
    if (scanned.name != parsed.Name()) mismatch(scanned.offset);
    XmlElement element{scanned.name, scanned.offset, {}, {}, scanned.stray_text};
    const tinyxml2::XMLAttribute* attribute = parsed.FirstAttribute();
    for (const ScannedAttribute& place : scanned.attributes) {
      if (attribute == nullptr || place.name != attribute->Name()) mismatch(place.offset);
      element.attributes.push_back({place.name, attribute->Value(), place.offset});
      attribute = attribute->Next();
    }
    for (const auto* child = parsed.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      element.children.push_back(build(*child));
    }
    return element;
  }

 private:
  /// The scanner accepts a little more than tinyxml2 may in another version: refuse, never guess.
  [[noreturn]] void mismatch(std::size_t offset) const {
    throw InputError{source_.issue(offset, "the XML cannot be understood from here on")};
  }

  const SourceText& source_;
  std::vector<ScannedElement> scanned_;
  std::size_t next_ = 0;
};

}  // namespace

const XmlAttribute* XmlElement::attribute(const std::string& wanted) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const XmlAttribute& a) { return a.name == wanted; });
  return found == attributes.end() ? nullptr : &*found;
}

XmlElement parse_xml(const SourceText& source) {
  std::vector<ScannedElement> scanned = scan_xml(source);
  tinyxml2::XMLDocument document;
  if (document.Parse(source.text().data(), source.text().size()) != tinyxml2::XML_SUCCESS) {
    const int line = std::max(1, document.ErrorLineNum());
    throw InputError{InputIssue{{source.file(), line, 1},
                                std::string{"the XML cannot be parsed: "} + document.ErrorName(),
                                {},
                                source.line(line)}};
  }
  return TreeBuilder{source, std::move(scanned)}.build(*document.RootElement());
}

}  // namespace nadir::sim
