#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/diagnostics.hpp"
#include "sim/scenario/checked_element.hpp"
#include "sim/scenario/issues.hpp"
#include "sim/scenario/material_library.hpp"
#include "sim/scenario/scenario.hpp"
#include "sim/scenario/source_text.hpp"

// Turns checked elements into the scenario's data and checks what the table cannot say: names that
// must be declared, numbers that must go together. One file for each family of elements.

namespace nadir::sim {

/// What every builder needs at hand.
struct BuildContext {
  const SourceText& source;
  Issues& issues;
  Diagnostics& diagnostics;

  void mistake(std::size_t offset, std::string message, std::string hint = {}) const {
    issues.add(source.issue(offset, std::move(message), std::move(hint)));
  }
  void warn(std::size_t offset, const std::string& message) const;
  /// Tells of every name (attribute "name") that an earlier element of the list has as well.
  void check_unique(const std::vector<const CheckedElement*>& elements,
                    const std::string& what) const;
};

/// The scenario's materials by name, and which of them are used.
class MaterialNames {
 public:
  /// @param name  empty where it was refused
  void add(const std::string& name, std::size_t offset);
  /// Index of the material that the element's attribute names. An unknown name is a mistake.
  [[nodiscard]] int resolve(const BuildContext& context, const CheckedElement& element,
                            const std::string& attribute = "material");
  /// Names in the libraries, for the hint where a material was not declared.
  void set_library_names(std::vector<std::string> names) { library_names_ = std::move(names); }
  void warn_of_unused(const BuildContext& context) const;

 private:
  struct Entry {
    std::string name;
    std::size_t offset = 0;
    bool used = false;
  };
  std::vector<Entry> entries_;
  std::map<std::string, int> index_;
  std::vector<std::string> library_names_;
  bool complete_ = true;
};

[[nodiscard]] geometry::Geodetic build_geodetic(const CheckedElement& element);

void build_time(const BuildContext& context, const CheckedElement& root, Scenario& scenario);
[[nodiscard]] IlluminationInput build_illumination(const BuildContext& context,
                                                   const CheckedElement& element);
[[nodiscard]] AirInput build_air(const CheckedElement& element);
/// @param base  what holds for settings that the element does not give
[[nodiscard]] materials::SolverSettings build_solver(const CheckedElement& element,
                                                     const materials::SolverSettings& base);
[[nodiscard]] MaterialNames build_materials(const BuildContext& context,
                                            const CheckedElement& element, Scenario& scenario);
void build_geometry(const BuildContext& context, const CheckedElement& element,
                    MaterialNames& materials, Scenario& scenario);
void build_platform(const BuildContext& context, const CheckedElement& element, Scenario& scenario);
void build_camera(const BuildContext& context, const CheckedElement& element, Scenario& scenario);
void build_results(const BuildContext& context, const CheckedElement& root, Scenario& scenario);

}  // namespace nadir::sim
