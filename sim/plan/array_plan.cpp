#include "sim/plan/array_plan.hpp"

namespace nadir::sim {

ArrayPlan plan_array(const sensor::DetectorArray& array, int wavelengths_per_band) {
  ArrayPlan plan;
  for (const sensor::Band& band : array.bands) {
    plan.quadratures.push_back(spectral::gauss_quadrature(band.response, wavelengths_per_band));
  }
  plan.lanes = spectral::plan_lanes(plan.quadratures);
  return plan;
}

}  // namespace nadir::sim
