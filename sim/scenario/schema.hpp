#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/scenario/attribute_type.hpp"

// The format of scenario files and material libraries as one table. The reader's checks, the XML
// schema (scenes/schema/nadir.xsd) and the reference page (docs/scenario-reference.md) come from
// it, so they cannot differ. Only rules that XML Schema 1.0 can say belong here.

namespace nadir::sim {

enum class Presence { required, optional, defaulted };

struct Attribute {
  std::string name;
  AttributeType type = TextType{};
  std::string unit;  ///< empty: none
  Presence presence = Presence::required;
  std::string fallback;  ///< defaulted: the default's text; optional: what happens without it
  std::string doc;
};

/// What may stand inside an element.
enum class Content {
  nothing,
  record,  ///< each child at most once, in any order; some must be there
  list,    ///< any children any number of times, at least `at_least` in all; where some are
           ///< required, so many of those (any of them)
  one_of   ///< exactly one of the children
};

struct Child {
  std::string type;  ///< id of its ElementType
  bool required = false;
};

struct ElementType {
  std::string id{};    ///< unique: the same element name may mean different things in two places
  std::string name{};  ///< as written in the file
  std::string doc{};
  std::vector<Attribute> attributes{};
  Content content = Content::nothing;
  std::vector<Child> children{};
  int at_least = 0;
};

class Schema {
 public:
  explicit Schema(std::vector<ElementType> types);

  /// @throws std::out_of_range for an id that the table lacks: a fault of the table
  [[nodiscard]] const ElementType& type(const std::string& id) const {
    return types_[index_.at(id)];
  }
  /// In the order of the reference page.
  [[nodiscard]] const std::vector<ElementType>& types() const noexcept { return types_; }

 private:
  std::vector<ElementType> types_;
  std::map<std::string, std::size_t> index_;
};

/// The table. Its roots are the types `scenario`, `library_materials` and `sensor_file`.
[[nodiscard]] const Schema& schema();

inline constexpr const char* scenario_root = "scenario";
inline constexpr const char* library_root = "library_materials";
inline constexpr const char* sensor_root = "sensor_file";

}  // namespace nadir::sim
