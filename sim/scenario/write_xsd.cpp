#include "sim/scenario/write_xsd.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/scenario/schema.hpp"

namespace nadir::sim {
namespace {

std::string xml_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string facet(const char* name, const std::string& value) {
  return fmt::format("<xs:{} value=\"{}\"/>", name, xml_escaped(value));
}

std::string restriction(const std::string& base, const std::string& facets) {
  return fmt::format("<xs:restriction base=\"{}\">{}</xs:restriction>", base, facets);
}
std::string simple(const std::string& content) {
  return "<xs:simpleType>" + content + "</xs:simpleType>";
}

std::string number(const NumberType& t) {
  return restriction("number",
                     facet(t.above ? "minExclusive" : "minInclusive", number_text(t.min)) +
                         facet(t.below ? "maxExclusive" : "maxInclusive", number_text(t.max)));
}

/// `.obj` as the pattern `\.[oO][bB][jJ]`: suffixes count without regard to case.
std::string suffix_pattern(const std::string& suffix) {
  std::string pattern;
  for (const char c : suffix) {
    if (c >= 'a' && c <= 'z') {
      pattern += fmt::format("[{}{}]", c, static_cast<char>(c - 'a' + 'A'));
    } else {
      pattern += fmt::format("\\{}", c);
    }
  }
  return pattern;
}

/// The restriction, list or union that an attribute's simple type consists of.
struct TypeWriter {
  std::string operator()(const NumberType& t) const { return number(t); }
  std::string operator()(const IntegerType& t) const {
    return restriction("xs:integer", facet("minInclusive", std::to_string(t.min)) +
                                         facet("maxInclusive", std::to_string(t.max)));
  }
  std::string operator()(const VectorType& t) const {
    const std::string item = simple(number(t.component));
    const std::string three = "<xs:restriction>" + simple("<xs:list>" + item + "</xs:list>") +
                              facet("length", "3") + "</xs:restriction>";
    return t.one_for_all ? "<xs:union>" + item + simple(three) + "</xs:union>" : three;
  }
  std::string operator()(const TextType& /*t*/) const {
    return restriction("xs:token", facet("minLength", "1"));
  }
  std::string operator()(const NameType& /*t*/) const { return restriction("name", ""); }
  std::string operator()(const NamesType& t) const {
    return "<xs:restriction>" + simple("<xs:list itemType=\"name\"/>") + facet("minLength", "1") +
           facet("maxLength", std::to_string(t.most)) + "</xs:restriction>";
  }
  std::string operator()(const EnumerationType& t) const {
    std::string facets;
    for (const std::string& value : t.values) facets += facet("enumeration", value);
    return restriction("xs:token", facets);
  }
  std::string operator()(const PathType& t) const {
    std::string facets;
    for (const std::string& s : t.suffixes) facets += facet("pattern", ".+" + suffix_pattern(s));
    return restriction("xs:token", t.suffixes.empty() ? facet("minLength", "1") : facets);
  }
  std::string operator()(const SpectralType& t) const {
    return "<xs:union>" + simple(number(t.number)) + simple((*this)(ColumnType{})) + "</xs:union>";
  }
  std::string operator()(const ColumnType& /*t*/) const {
    return restriction("xs:token",
                       facet("pattern", "[^#]+" + suffix_pattern(".csv") + "(#[^#]+)?"));
  }
  std::string operator()(const InstantType& /*t*/) const {
    return restriction("xs:token", facet("pattern",
                                         "[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}"
                                         "(\\.[0-9]{1,9})?Z"));
  }
};

std::string documentation(const std::string& text) {
  return "<xs:annotation><xs:documentation>" + xml_escaped(text) +
         "</xs:documentation></xs:annotation>";
}

std::string attribute_text(const Attribute& attribute) {
  std::string use;
  std::string doc = attribute.doc;
  if (!attribute.unit.empty()) doc += " [" + attribute.unit + "]";
  if (attribute.presence == Presence::required) use = " use=\"required\"";
  if (attribute.presence == Presence::defaulted) {
    use = " default=\"" + xml_escaped(attribute.fallback) + "\"";
  }
  if (attribute.presence == Presence::optional) doc += " Without it: " + attribute.fallback + ".";
  return fmt::format("    <xs:attribute name=\"{}\"{}>\n      {}\n      {}\n    </xs:attribute>\n",
                     attribute.name, use, documentation(doc),
                     simple(std::visit(TypeWriter{}, attribute.type)));
}

std::string element_text(const Schema& table, const Child& child, const char* occurs) {
  const ElementType& type = table.type(child.type);
  return fmt::format("      <xs:element name=\"{}\" type=\"{}\"{}/>\n", type.name, type.id, occurs);
}

bool has_required(const ElementType& type) {
  return std::any_of(type.children.begin(), type.children.end(),
                     [](const Child& child) { return child.required; });
}

/// A list in which some of the required children must be: others, the first of those, then any.
std::string partly_required_xsd(const Schema& table, const ElementType& type) {
  std::string needed, others, all;
  for (const Child& child : type.children) {
    const std::string text = element_text(table, child, "");
    (child.required ? needed : others) += text;
    all += text;
  }
  const auto choice = [](const std::string& occurs, const std::string& elements) {
    return "    <xs:choice" + occurs + ">\n" + elements + "    </xs:choice>\n";
  };
  const std::string any = " minOccurs=\"0\" maxOccurs=\"unbounded\"";
  return "    <xs:sequence>\n" + choice(any, others) + choice("", needed) + choice(any, all) +
         "    </xs:sequence>\n";
}

std::string children_xsd(const Schema& table, const ElementType& type) {
  if (type.content == Content::nothing) return {};
  const bool record = type.content == Content::record;
  std::string open = record ? "xs:all" : "xs:choice";
  if (type.content == Content::list && has_required(type)) return partly_required_xsd(table, type);
  if (type.content == Content::list) {
    open += fmt::format(" minOccurs=\"{}\" maxOccurs=\"unbounded\"", type.at_least);
  }
  std::string text = "    <" + open + ">\n";
  for (const Child& child : type.children) {
    text += element_text(table, child, record && !child.required ? " minOccurs=\"0\"" : "");
  }
  return text + (record ? "    </xs:all>\n" : "    </xs:choice>\n");
}

std::string type_xsd(const Schema& table, const ElementType& type) {
  std::string text =
      fmt::format("\n  <xs:complexType name=\"{}\">\n    {}\n", type.id, documentation(type.doc));
  text += children_xsd(table, type);
  for (const Attribute& attribute : type.attributes) text += attribute_text(attribute);
  return text + "  </xs:complexType>\n";
}

constexpr const char* xsd_head = R"(<?xml version="1.0" encoding="UTF-8"?>
<!-- Scenarios, material libraries and sensor files of Nadir. Written by `nadir schema` from the table that the
     reader itself follows; do not edit. -->
<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema">

  <xs:simpleType name="number">
    <xs:restriction base="xs:double">
      <xs:pattern value="[+\-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+\-]?[0-9]+)?"/>
    </xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="name">
    <xs:restriction base="xs:token">
      <xs:pattern value="[A-Za-z0-9_][A-Za-z0-9_.\-]*"/>
    </xs:restriction>
  </xs:simpleType>

)";

}  // namespace

std::string write_xsd() {
  const Schema& table = schema();
  std::string text = xsd_head;
  for (const char* root : {scenario_root, library_root, sensor_root}) {
    const ElementType& type = table.type(root);
    text += fmt::format("  <xs:element name=\"{}\" type=\"{}\"/>\n", type.name, type.id);
  }
  for (const ElementType& type : table.types()) text += type_xsd(table, type);
  return text + "</xs:schema>\n";
}

}  // namespace nadir::sim
