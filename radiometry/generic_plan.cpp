#include "radiometry/generic_plan.hpp"

namespace nadir::radiometry {

GenericPlan::GenericPlan(const materials::BoundMaterial& material,
                         const materials::SolverSettings& settings)
    : settings_{settings}, quads_{settings.mu_samples, settings.phi_samples} {
  if (material.traits.has_delta) return;
  if (ImportanceTable::plainly_narrow(material, quads_)) return;
  ImportanceTable table{material, quads_};
  if (table.peakedness() <= lobe_is_narrow) importance_ = std::move(table);
}

}  // namespace nadir::radiometry
