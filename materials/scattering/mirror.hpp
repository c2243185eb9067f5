#pragma once

#include <optional>

#include "materials/scattering/bind_context.hpp"
#include "materials/scattering/models.hpp"
#include "materials/scattering/sample.hpp"

namespace nadir::materials {

/// Ideal mirror: all reflected light leaves in the one direction of the law of reflection. Its
/// share is the material's reflectance at all angles or, where a refractive index n + i k is given,
/// Fresnel's unpolarised reflectance (fresnel.hpp); what is not reflected is absorbed.
///
/// Domain: n in [0.01, 100], k in [0, 100] (k without n is refused). eval and pdf are 0: a delta.
class BoundMirror {
 public:
  BoundMirror(const Mirror& model, const BindContext& context);

  [[nodiscard]] spectral::Spectrum eval(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample(Vec3 wo,
                                                       const ScatteringDraw& u) const noexcept;
  [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept;
  [[nodiscard]] ScatteringTraits traits() const noexcept {
    return {.has_delta = true, .only_delta = true};
  }

 private:
  [[nodiscard]] spectral::Spectrum reflectance(double mu) const noexcept;

  spectral::Spectrum reflectance_;  // of the material, where there is no index
  spectral::Spectrum n_, k_;
  bool fresnel_ = false;
};

}  // namespace nadir::materials
