#pragma once

#include <map>
#include <optional>
#include <tuple>

#include "sim/scenario/build_context.hpp"

namespace nadir::sim {

/// Materials that objects and parts of meshes set apart by a temperature of their own: copies with
/// that source, appended to the scenario's, one for each pair of material and source.
class MaterialVariants {
 public:
  /// Adds all that the geometry asks for. Maps are numbered after materials: only now are their
  /// numbers known.
  MaterialVariants(const BuildContext& context, const CheckedElement& geometry,
                   MaterialNames& names, Scenario& scenario);

  /// Index of the material or map that the element's attribute names, or of its variant.
  [[nodiscard]] int resolve(const CheckedElement& element);

 private:
  /// Number of another material whose source to take, or else a temperature.
  struct Source {
    std::optional<int> of;
    double kelvin = 0.0;
    auto operator<=>(const Source&) const = default;
  };
  void add_below(const CheckedElement& element, const CheckedElement* mesh);
  void add(const CheckedElement& element, const CheckedElement& said);
  [[nodiscard]] std::optional<Source> source_of(const CheckedElement& element);
  [[nodiscard]] int variant(int material, const Source& source);

  const BuildContext& context_;
  MaterialNames& names_;
  Scenario& scenario_;
  std::map<const CheckedElement*, std::optional<Source>> sources_;  // by who states them
  std::map<std::pair<int, Source>, int> variants_;
  std::map<const CheckedElement*, int> index_;  // of the variant, by who is made of it
};

}  // namespace nadir::sim
