#pragma once

#include <variant>

#include "core/vec.hpp"
#include "materials/volume/henyey_greenstein.hpp"
#include "materials/volume/medium.hpp"
#include "materials/volume/rayleigh_phase.hpp"
#include "materials/volume/tabulated_phase.hpp"
#include "spectral/lanes.hpp"

namespace nadir::materials {

/// A direction drawn by a phase function.
struct PhaseSample {
  Vec3 direction;             ///< unit, where the light comes from, pointing away from the point
  double pdf = 0.0;           ///< sr^-1
  spectral::Spectrum weight;  ///< phase / pdf per lane
};

/// A phase function at the lanes: p(cos) integrates to 1 over the sphere at every lane. Directions
/// are drawn from the mean of the lanes' functions, so that no weight exceeds the number of lanes.
/// Both directions point away from the point, so that the cosine of the scattering angle is
/// -dot(wi, wo).
class BoundPhase {
 public:
  /// @throws InputError for what the phase functions refuse; see their headers
  BoundPhase(const PhaseFunction& phase, const spectral::Lanes& lanes);

  [[nodiscard]] spectral::Spectrum eval(Vec3 wi, Vec3 wo) const noexcept;  ///< sr^-1
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  /// @param choice  which lane's function, where they differ; with `u` uniform in [0, 1)
  [[nodiscard]] PhaseSample sample(Vec3 wo, double choice, Vec2 u) const noexcept;

 private:
  [[nodiscard]] spectral::Spectrum eval_at(double x) const noexcept;

  std::variant<BoundHenyeyGreenstein, BoundRayleigh, BoundTabulatedPhase> model_;
};

}  // namespace nadir::materials
