#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/scenario/attribute_type.hpp"
#include "sim/scenario/schema.hpp"
#include "sim/scenario/xml_document.hpp"

namespace nadir::sim {

/// An element whose form has been checked against the table. After mistakes it is incomplete: the
/// accessors then give what they can, so that the checks of meaning can go on and find more.
struct CheckedElement {
  const ElementType* type = nullptr;
  std::size_t offset = 0;
  std::map<std::string, AttributeValue> values;         ///< valid ones, and defaults
  std::map<std::string, std::size_t> attribute_offset;  ///< of those that the file gives
  std::vector<CheckedElement> children;

  /// Where a mistake of this attribute's value is to be shown.
  [[nodiscard]] std::size_t where(const std::string& attribute) const {
    const auto found = attribute_offset.find(attribute);
    return found == attribute_offset.end() ? offset : found->second;
  }
  /// Whether the file gives the attribute, be it valid or not.
  [[nodiscard]] bool gives(const std::string& attribute) const {
    return attribute_offset.contains(attribute);
  }
  /// The file's value or the default; nothing where it is missing or was refused.
  template <class T>
  [[nodiscard]] std::optional<T> find(const std::string& attribute) const {
    const auto found = values.find(attribute);
    if (found == values.end()) return std::nullopt;
    return std::get<T>(found->second);
  }
  /// As `find`; an empty T after a mistake.
  template <class T>
  [[nodiscard]] T value(const std::string& attribute) const {
    return find<T>(attribute).value_or(T{});
  }
  [[nodiscard]] double number(const std::string& attribute) const {
    return value<double>(attribute);
  }
  [[nodiscard]] bool flag(const std::string& attribute) const {
    return value<std::string>(attribute) == "true";
  }
  /// The first child of that element name, or null.
  [[nodiscard]] const CheckedElement* child(const std::string& name) const {
    for (const CheckedElement& element : children) {
      if (element.type->name == name) return &element;
    }
    return nullptr;
  }
};

}  // namespace nadir::sim
