#include "sim/plan/array_plan.hpp"

namespace nadir::sim {

ArrayPlan plan_array(const sensor::DetectorArray& array, const BandNodes& nodes,
                     std::size_t number) {
  ArrayPlan plan;
  for (std::size_t band = 0; band < array.bands.size(); ++band) {
    plan.quadratures.push_back(
        spectral::gauss_quadrature(array.bands[band].response, nodes.of(number, band)));
  }
  plan.lanes = spectral::plan_lanes(plan.quadratures);
  return plan;
}

}  // namespace nadir::sim
