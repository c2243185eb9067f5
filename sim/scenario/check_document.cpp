#include "sim/scenario/check_document.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace nadir::sim {
namespace {

namespace fs = std::filesystem;

// What editors put on the root to find the XML schema.
constexpr const char* namespace_attribute = "xmlns:xsi";
constexpr const char* location_attribute = "xsi:noNamespaceSchemaLocation";
constexpr std::string_view schema_instance = "http://www.w3.org/2001/XMLSchema-instance";

std::string tag(const std::string& name) { return "<" + name + ">"; }

class Checker {
 public:
  Checker(const SourceText& source, const InputPaths& paths, Issues& issues)
      : source_{source}, paths_{paths}, issues_{issues} {}

  CheckedElement check(const XmlElement& xml, const ElementType& type, bool is_root) {
    CheckedElement element;
    element.type = &type;
    element.offset = xml.offset;
    check_attributes(xml, type, is_root, element);
    if (xml.stray_text) {
      mistake(*xml.stray_text, fmt::format("text inside <{}>, which holds no text", type.name),
              "values are given as attributes: name=\"value\"");
    }
    check_children(xml, type, element);
    return element;
  }

 private:
  void mistake(std::size_t offset, std::string message, std::string hint = {}) {
    issues_.add(source_.issue(offset, std::move(message), std::move(hint)));
  }

  // ---- attributes -----------------------------------------------------------------------------

  void check_attributes(const XmlElement& xml, const ElementType& type, bool is_root,
                        CheckedElement& element) {
    for (const XmlAttribute& given : xml.attributes) {
      if (is_root && is_for_editors(given, xml)) continue;
      const Attribute* known = known_attribute(given, xml, type);
      if (known == nullptr || element.gives(known->name)) continue;
      element.attribute_offset[known->name] = given.offset;
      check_value(given, *known, type, element);
    }
    for (const Attribute& attribute : type.attributes) {
      if (element.gives(attribute.name)) continue;
      if (attribute.presence == Presence::required) {
        mistake(xml.offset,
                fmt::format("<{}> lacks its attribute \"{}\"", type.name, attribute.name),
                "it is " + expected(attribute));
      } else if (attribute.presence == Presence::defaulted) {
        element.values.emplace(attribute.name,
                               *parse_attribute(attribute.type, attribute.fallback).value());
      }
    }
  }

  /// The attributes that tell an editor where the schema is; checks that they do.
  bool is_for_editors(const XmlAttribute& given, const XmlElement& root) {
    if (given.name == location_attribute && root.attribute(namespace_attribute) == nullptr) {
      mistake(given.offset, fmt::format("\"{}\" needs {}=\"{}\" beside it", given.name,
                                        namespace_attribute, schema_instance));
    }
    if (given.name == namespace_attribute && given.value != schema_instance) {
      mistake(given.offset, fmt::format("\"{}\" must be \"{}\"", given.name, schema_instance));
    }
    return given.name == namespace_attribute || given.name == location_attribute;
  }

  static std::string expected(const Attribute& attribute) {
    const std::string unit = attribute.unit.empty() ? "" : " [" + attribute.unit + "]";
    return expectation(attribute.type) + unit;
  }

  /// The table's attribute that is meant; null where none is near, or the file gives it as well.
  const Attribute* known_attribute(const XmlAttribute& given, const XmlElement& xml,
                                   const ElementType& type) {
    std::vector<std::string> names;
    for (const Attribute& attribute : type.attributes) {
      if (attribute.name == given.name) return &attribute;
      names.push_back(attribute.name);
    }
    mistake(given.offset, fmt::format("<{}> has no attribute \"{}\"", type.name, given.name),
            names.empty() ? "it has none" : suggestion(given.name, names));
    const std::string meant = nearest_name(given.name, names);
    if (meant.empty() || xml.attribute(meant) != nullptr) return nullptr;
    return &*std::find_if(type.attributes.begin(), type.attributes.end(),
                          [&](const Attribute& a) { return a.name == meant; });
  }

  void check_value(const XmlAttribute& given, const Attribute& attribute, const ElementType& type,
                   CheckedElement& element) {
    ParsedAttribute parsed = parse_attribute(attribute.type, given.value);
    if (const auto* problem = std::get_if<std::string>(&parsed.result)) {
      const std::string unit = attribute.unit.empty() ? "" : " [" + attribute.unit + "]";
      mistake(
          given.offset,
          fmt::format("attribute \"{}\" of <{}>: {}{}", attribute.name, type.name, *problem, unit),
          parsed.hint.empty() ? "" : fmt::format("did you mean \"{}\"?", parsed.hint));
      return;
    }
    AttributeValue value = std::get<AttributeValue>(std::move(parsed.result));
    if (auto* path = std::get_if<fs::path>(&value)) {
      resolve(*path, given.offset, std::get<PathType>(attribute.type).or_shipped);
    }
    if (auto* spectral = std::get_if<SpectralInput>(&value)) {
      if (auto* path = std::get_if<fs::path>(&spectral->source)) {
        resolve(*path, given.offset, false);
      }
    }
    element.values.emplace(attribute.name, std::move(value));
  }

  void resolve(fs::path& path, std::size_t offset, bool or_shipped) {
    try {
      const std::string written = path.string();
      path = or_shipped ? paths_.absolute_or_shipped(path) : paths_.absolute(path);
      std::error_code error;
      if (fs::is_regular_file(path, error)) return;
      const bool other = fs::exists(path, error);
      const std::string near = other ? std::string{} : nearest_file(path);
      mistake(offset,
              fmt::format("file \"{}\" {} (looked at {})", written,
                          other ? "is not a file" : "does not exist", path.string()),
              near.empty() ? "" : fmt::format("that folder holds \"{}\"", near));
    } catch (const InputError& error) {
      mistake(offset, error.issues().front().message);
    }
  }

  // ---- children -------------------------------------------------------------------------------

  void check_children(const XmlElement& xml, const ElementType& type, CheckedElement& element) {
    std::vector<const ElementType*> allowed;
    for (const Child& child : type.children) allowed.push_back(&schema().type(child.type));
    std::set<std::string> present;
    for (const XmlElement& child : xml.children) present.insert(child.name);
    for (const XmlElement& child : xml.children) {
      const ElementType* meant = known_child(child, type, allowed, present);
      if (meant == nullptr) continue;
      if (!may_stand(child, *meant, type, element)) continue;
      element.children.push_back(check(child, *meant, false));
    }
    check_counts(xml, type, allowed, element);
  }

  const ElementType* known_child(const XmlElement& child, const ElementType& type,
                                 const std::vector<const ElementType*>& allowed,
                                 const std::set<std::string>& present) {
    std::vector<std::string> names;
    for (const ElementType* candidate : allowed) {
      if (candidate->name == child.name) return candidate;
      names.push_back(candidate->name);
    }
    mistake(child.offset, fmt::format("<{}> may not hold <{}>", type.name, child.name),
            names.empty() ? "it holds no elements" : suggestion(child.name, names));
    const std::string meant = nearest_name(child.name, names);
    const bool single = type.content != Content::list;
    if (meant.empty() || (single && present.contains(meant))) return nullptr;
    return *std::find_if(allowed.begin(), allowed.end(),
                         [&](const ElementType* t) { return t->name == meant; });
  }

  /// Whether one more child fits; a repeated one is a mistake and is left out.
  bool may_stand(const XmlElement& child, const ElementType& meant, const ElementType& type,
                 const CheckedElement& element) {
    const CheckedElement* other = nullptr;
    if (type.content == Content::record) other = element.child(meant.name);
    if (type.content == Content::one_of && !element.children.empty()) other = &element.children[0];
    if (other == nullptr) return true;
    mistake(child.offset,
            fmt::format("<{}> holds only one {}; <{}> stands in line {} already", type.name,
                        type.content == Content::record ? tag(meant.name) : choices(type),
                        other->type->name, source_.locate(other->offset).line));
    return false;
  }

  /// Whether a list asks for some of its children in particular.
  static bool some_required(const ElementType& type) {
    return type.content == Content::list &&
           std::any_of(type.children.begin(), type.children.end(),
                       [](const Child& child) { return child.required; });
  }

  /// Whether a child may be one of those that must be there.
  static bool may_count(const XmlElement& child, const ElementType& type,
                        const std::vector<const ElementType*>& allowed) {
    if (!some_required(type)) return true;
    for (std::size_t i = 0; i < allowed.size(); ++i) {
      if (allowed[i]->name == child.name) return type.children[i].required;
    }
    return true;
  }

  static std::string choices(const ElementType& type) {
    std::vector<std::string> names;
    const bool some = some_required(type);
    for (const Child& child : type.children) {
      if (!some || child.required) names.push_back(tag(schema().type(child.type).name));
    }
    return fmt::format("{}", fmt::join(names, " or "));
  }

  void check_counts(const XmlElement& xml, const ElementType& type,
                    const std::vector<const ElementType*>& allowed, const CheckedElement& element) {
    if (type.content == Content::record) {
      for (std::size_t i = 0; i < allowed.size(); ++i) {
        if (!type.children[i].required || element.child(allowed[i]->name) != nullptr) continue;
        mistake(xml.offset, fmt::format("<{}> lacks <{}>", type.name, allowed[i]->name),
                allowed[i]->doc);
      }
    }
    const int least = type.content == Content::one_of ? 1 : type.at_least;
    const auto counts = [&](const XmlElement& child) { return may_count(child, type, allowed); };
    // Unknown children count: they were told already, and are probably what was meant to be here.
    if (std::count_if(xml.children.begin(), xml.children.end(), counts) < least) {
      mistake(xml.offset,
              fmt::format("<{}> needs {}{}", type.name,
                          least > 1 ? std::to_string(least) + " of " : "", choices(type)));
    }
  }

  const SourceText& source_;
  const InputPaths& paths_;
  Issues& issues_;
};

}  // namespace

CheckedElement check_document(const XmlElement& document, const std::string& root,
                              const SourceText& source, const InputPaths& paths, Issues& issues) {
  const ElementType& type = schema().type(root);
  if (document.name != type.name) {
    throw InputError{source.issue(document.offset, fmt::format("expected the root <{}>, found <{}>",
                                                               type.name, document.name))};
  }
  return Checker{source, paths, issues}.check(document, type, true);
}

}  // namespace nadir::sim
