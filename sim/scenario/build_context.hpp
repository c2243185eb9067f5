#pragma once

#include <map>
#include <optional>
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
  /// Names a map of materials; maps are numbered after all materials, in the order of these calls.
  void add_map(const std::string& name, std::size_t offset);
  /// How many materials there are, those that contrast maps and geometry add included: from then on
  /// maps have numbers.
  void set_material_count(std::size_t count) { material_count_ = static_cast<int>(count); }
  /// The same as `resolve` where a map will not do; nothing after a mistake.
  [[nodiscard]] std::optional<int> resolve_material(const BuildContext& context,
                                                    const CheckedElement& element,
                                                    const std::string& attribute = "material");
  /// Index of the material or map that the element's attribute names. An unknown name is a mistake.
  [[nodiscard]] int resolve(const BuildContext& context, const CheckedElement& element,
                            const std::string& attribute = "material");
  [[nodiscard]] bool is_map(const std::string& name) const;
  /// Number of the material of that name; nothing for maps and unknown names. Does not count as
  /// use.
  [[nodiscard]] std::optional<int> number_of(const std::string& name) const;
  /// Names in the libraries, for the hint where a material was not declared.
  void set_library_names(std::vector<std::string> names) { library_names_ = std::move(names); }
  void warn_of_unused(const BuildContext& context) const;

 private:
  struct Entry {
    std::string name;
    std::size_t offset = 0;
    bool used = false;
    bool is_map = false;
    int number = 0;  // among the materials or among the maps
  };
  void add(const std::string& name, std::size_t offset, bool is_map);
  [[nodiscard]] const Entry* find(const BuildContext& context, const CheckedElement& element,
                                  const std::string& attribute);

  std::vector<Entry> entries_;
  std::map<std::string, int> index_;
  std::vector<std::string> library_names_;
  int materials_ = 0, maps_ = 0, material_count_ = 0;
  bool complete_ = true;
};

[[nodiscard]] geometry::Geodetic build_geodetic(const CheckedElement& element);

void build_time(const BuildContext& context, const CheckedElement& root, Scenario& scenario);
[[nodiscard]] IlluminationInput build_illumination(const BuildContext& context,
                                                   const CheckedElement& element);
[[nodiscard]] AirInput build_air(const BuildContext& context, const CheckedElement& element);
/// @param base  what holds for settings that the element does not give
[[nodiscard]] materials::SolverSettings build_solver(const CheckedElement& element,
                                                     const materials::SolverSettings& base);
/// The weather and how heat balances are solved, where the scenario says it.
[[nodiscard]] std::optional<HeatInput> build_heat(const BuildContext& context,
                                                  const CheckedElement& root);
/// @param root  holds <materials>; after `build_heat`, whose weather materials may need
[[nodiscard]] MaterialNames build_materials(const BuildContext& context, const CheckedElement& root,
                                            Scenario& scenario);
void build_geometry(const BuildContext& context, const CheckedElement& element,
                    MaterialNames& materials, Scenario& scenario);
/// After the geometry, whose terrain lamps may stand on.
void build_lamps(const BuildContext& context, const CheckedElement& root, MaterialNames& materials,
                 Scenario& scenario);
/// What geometry and volumes have in common. on_terrain without a terrain is a mistake.
[[nodiscard]] PlacementInput build_placement(const BuildContext& context,
                                             const CheckedElement& element, bool has_terrain);
[[nodiscard]] bool build_on_terrain(const BuildContext& context, const CheckedElement& element,
                                    bool has_terrain);
[[nodiscard]] geometry::Box build_box(const BuildContext& context, const CheckedElement& element);
/// Open unless the element says capped.
[[nodiscard]] geometry::Cylinder build_cylinder(const BuildContext& context,
                                                const CheckedElement& element);
void build_volumes(const BuildContext& context, const CheckedElement& element, bool has_terrain,
                   Scenario& scenario);
void build_platform(const BuildContext& context, const CheckedElement& element, Scenario& scenario);
void build_camera(const BuildContext& context, const CheckedElement& element, Scenario& scenario);
void build_effects(const BuildContext& context, const CheckedElement& root, Scenario& scenario);
void build_results(const BuildContext& context, const CheckedElement& root, Scenario& scenario);

}  // namespace nadir::sim
