#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

/// @param without  empty: the attributes have defaults; otherwise what holds where one is missing
Attribute setting(const std::string& name, AttributeType type, const std::string& value,
                  const std::string& without, const std::string& doc) {
  if (without.empty()) return defaulted(name, std::move(type), "", value, doc);
  return optional(name, std::move(type), "", without, doc);
}

ElementType solver(const std::string& id, const std::string& doc, const std::string& without) {
  return {.id = id,
          .name = "solver",
          .doc = doc,
          .attributes = {
              setting("initial_sample_count", IntegerType{0, 100000}, "8", without,
                      "Full samples at the surface that a pixel sees."),
              setting("sample_decay_rate", from_to(1.0, 1e6), "2", without,
                      "Each bounce has that many times fewer full samples, rounded up."),
              setting("max_bounces", IntegerType{0, 1000}, "3", without,
                      "Surfaces after the first one whose own surroundings are sampled."),
              setting("mu_samples", IntegerType{1, 1000}, "2", without,
                      "Parts of the hemisphere over the cosine of the zenith angle."),
              setting("phi_samples", IntegerType{1, 1000}, "6", without,
                      "Parts of the hemisphere over azimuth."),
              setting("min_quad_samples", IntegerType{0, 1000}, "1", without,
                      "Parts of the hemisphere with fewer full samples are topped up with samples "
                      "that collect emission and sky only.")}};
}

}  // namespace

std::vector<ElementType> schema_of_solver() {
  std::vector<ElementType> all;
  ElementType scenario_solver =
      solver("solver", "How radiance is computed, unless a material says otherwise.", "");
  scenario_solver.attributes.push_back(
      defaulted("method", EnumerationType{{"generic", "path"}}, "", "generic",
                "generic: the generic radiometry solver, which the attributes above set. path: the "
                "unbiased path solver, which ignores them."));
  scenario_solver.attributes.push_back(
      defaulted("path_max_bounces", IntegerType{0, 1000000}, "", "0",
                "Of the path solver: surfaces after the first one that a path may reach. 0: no "
                "limit, and no bias."));
  all.push_back(std::move(scenario_solver));
  all.push_back(solver("material_solver", "How radiance is computed on this material.",
                       "as in the scenario's solver"));
  return all;
}

}  // namespace nadir::sim
