#pragma once

#include <cstddef>

#include "atmosphere/transfer/scaled_column.hpp"
#include "atmosphere/transfer/scattered_source.hpp"

namespace nadir::atmosphere {

enum class Light { beam, thermal, sky, ground };

/// From where, in which direction and of which light a column is looked at.
struct SlabView {
  Light light = Light::beam;
  std::size_t beam = 0;      ///< which, of those of the problem
  std::size_t mu_index = 0;  ///< of the directions of the solution; upward ones are seen from above
                             ///< the column, downward ones from below it
  double azimuth_rad = 0.0;  ///< of the direction looked in from that of the body
  int truncated = 0;         ///< 0: first scattering by the true phase function ("TMS"); else the
                             ///< streams whose truncated one it goes by, as all other scattering
};

/// Diffuse radiance that leaves a plane-parallel column: what is scattered once or emitted exactly,
/// what is scattered more often with J linear in optical depth within each layer. Light of the sky
/// or ground that comes straight through is in it, a beam's own is not.
/// Source for the true phase function: Nakajima & Tanaka, JQSRT 40, 51 (1988), the "TMS method".
[[nodiscard]] double slab_radiance(const ScaledColumn& column, const TransferProblem& problem,
                                   const TransferSolution& solution, const SlabView& view);

}  // namespace nadir::atmosphere
