#include "sim/scenario/write_reference.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/scenario/schema.hpp"

namespace nadir::sim {
namespace {

/// Heading, unique where two types share an element's name.
std::string heading(const Schema& table, const ElementType& type) {
  int namesakes = 0;
  for (const ElementType& other : table.types()) namesakes += other.name == type.name ? 1 : 0;
  if (namesakes == 1) return type.name;
  std::vector<std::string> parents;
  for (const ElementType& other : table.types()) {
    for (const Child& child : other.children) {
      if (child.type == type.id) parents.push_back(other.name);
    }
  }
  if (parents.empty()) {
    return type.name + (type.id == library_root ? " (root of a library)" : " (root of a file)");
  }
  const bool prototype = type.id.starts_with("prototype_");
  if (type.id == "library_material") return "material (of a library)";
  return fmt::format("{} (in {})", type.name, prototype ? "instances" : parents.front());
}

/// As the usual Markdown renderers make it: lower case, blanks to -, marks left out.
std::string anchor(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == ' ')
      out += '-';
    else if (c != '(' && c != ')')
      out += c;
  }
  return out;
}

std::string link(const Schema& table, const std::string& id) {
  const ElementType& type = table.type(id);
  return fmt::format("[`<{}>`](#{})", type.name, anchor(heading(table, type)));
}

std::string children_text(const Schema& table, const ElementType& type) {
  std::vector<std::string> needed, others;
  for (const Child& child : type.children) {
    (child.required ? needed : others).push_back(link(table, child.type));
  }
  switch (type.content) {
    case Content::nothing:
      return "Holds nothing.";
    case Content::record:
      return (needed.empty() ? ""
                             : fmt::format("Holds, in any order: {}. ", fmt::join(needed, ", "))) +
             (others.empty() ? "" : fmt::format("May hold: {}.", fmt::join(others, ", ")));
    case Content::one_of:
      return fmt::format("Holds exactly one of: {}.", fmt::join(others, ", "));
    case Content::list:
      return needed.empty()
                 ? fmt::format("Holds any number {}of: {}.",
                               type.at_least > 0 ? "(at least one) " : "", fmt::join(others, ", "))
                 : fmt::format("Holds any number (at least one) of: {}. May hold: {}.",
                               fmt::join(needed, ", "), fmt::join(others, ", "));
  }
  return {};
}

std::string fallback_text(const Attribute& attribute) {
  if (attribute.presence == Presence::required) return "**required**";
  if (attribute.presence == Presence::defaulted) return "`" + attribute.fallback + "`";
  return attribute.fallback;
}

/// `*` would begin italics.
std::string stars_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '*' ? std::string{"\\*"} : std::string{c};
  return out;
}

std::string type_text(const Schema& table, const ElementType& type) {
  std::string text = fmt::format("\n## {}\n\n{}\n\n{}\n", heading(table, type), type.doc,
                                 children_text(table, type));
  if (type.attributes.empty()) return text;
  text += "\n| attribute | value | unit | without it | meaning |\n|---|---|---|---|---|\n";
  for (const Attribute& a : type.attributes) {
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", a.name,
                        stars_escaped(expectation(a.type)), a.unit, fallback_text(a), a.doc);
  }
  return text;
}

constexpr const char* reference_head = R"(# Scenario files: every element and attribute

Written by `nadir schema --reference` from the table that the reader itself follows; do not edit.

A scenario is an XML file with the root `<scenario>`. All values are attributes. Numbers are plain
decimals (`1.5`, `2e-3`); names of attributes end in their units. A path counts from the folder of
the file that holds it; one that begins with `library:` lies in Nadir's own library. A spectrum file
may be followed by `#` and the name of one of its columns. Editors complete scenarios when the root
carries `xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"` and
`xsi:noNamespaceSchemaLocation="path/to/nadir.xsd"`. `nadir validate FILE` lists all mistakes.
)";

}  // namespace

std::string write_reference() {
  std::string text = reference_head;
  for (const ElementType& type : schema().types()) text += type_text(schema(), type);
  return text;
}

}  // namespace nadir::sim
