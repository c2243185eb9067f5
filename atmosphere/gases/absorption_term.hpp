#pragma once

#include <vector>

namespace nadir::atmosphere {

/// One term of a sum of exponentials: with optical depths t_k along any path,
/// transmittance = sum over terms of weight * exp(-sum_k t_k). The weights sum to 1.
struct AbsorptionTerm {
  double weight = 1.0;
  std::vector<double> depth;  ///< vertical optical depth of all gases by layer, from the top down
};

}  // namespace nadir::atmosphere
