#pragma once

#include <optional>

#include "materials/scattering/bind_context.hpp"
#include "materials/scattering/models.hpp"
#include "materials/scattering/sample.hpp"

namespace nadir::materials {

/// Rough diffuse surface of long symmetric V-shaped cavities whose facets are Lambertian, with
/// Gaussian tilts of standard deviation sigma: Oren and Nayar's "qualitative" model (their eq. 30),
///
///     f = (rho / pi) (1 + b max(0, cos(phi_i - phi_o)) sin(alpha) tan(beta))
///     alpha = max(theta_i, theta_o), beta = min(theta_i, theta_o)
///     b = B / A,  A = 1 - 0.5 s / (s + 0.33),  B = 0.45 s / (s + 0.09),  s = sigma^2
///
/// Domain: sigma in [0, pi/2) rad (measured surfaces: up to about 0.7); sigma = 0 is Lambertian.
///
/// rho is the material's reflectance and means what a laboratory measures:
/// directional-hemispherical at normal incidence. The paper's rho, the albedo of a facet, is rho /
/// A. Closed form of the albedo, with the lobe's integral g (Fujii, "A tiny improvement of
/// Oren-Nayar reflectance model"; our derivation agrees):
///
///     albedo(theta) = rho (1 + b g(theta))
///     g = (2/pi) (sin(theta) (theta - sin(theta) cos(theta)) / 2
///                 + tan(theta) (1 - sin^3(theta)) / 3)                     0 <= g <= 1/2
///
/// Reciprocal, because alpha and beta are. Deviations from the paper, for energy: (1) it reaches
/// rho (1 + b/2) at grazing, more than 1 for bright surfaces; b is cut per lane to 2 (1 - rho) /
/// rho, above rho = 0.72 at most. That is the right direction: light that is reflected again and
/// again between bright facets washes the shape out, and a white surface must be white from
/// everywhere. (2) The full model (their eq. 26 to 28) is not used: it turns negative for forward
/// scattering at grazing angles. The energy-preserving variant EON (Portsmouth et al., JCGT 14(1),
/// 2025) is not used either, because its roughness is not the slope that field workers measure.
///
/// Sampled exactly: weights are rho (1 + b g) where all lanes share one b.
/// Source: M. Oren, S. K. Nayar, "Generalization of Lambert's reflectance model", SIGGRAPH '94,
/// 239, doi:10.1145/192161.192213.
class BoundOrenNayar {
 public:
  BoundOrenNayar(const OrenNayar& model, const BindContext& context);

  [[nodiscard]] spectral::Spectrum eval(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample(Vec3 wo,
                                                       const ScatteringDraw& u) const noexcept;
  [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept;
  [[nodiscard]] ScatteringTraits traits() const noexcept { return {}; }

 private:
  spectral::Spectrum over_pi_;             // rho / pi
  spectral::Spectrum lobe_over_pi_;        // rho b / pi
  spectral::Spectrum reflectance_, lobe_;  // rho, rho b
  double mean_b_ = 0.0;                    // of the lane-averaged function
};

}  // namespace nadir::materials
