#pragma once

#include <optional>

#include "materials/scattering/bind_context.hpp"
#include "materials/scattering/lobe_mixture.hpp"
#include "materials/scattering/models.hpp"
#include "materials/scattering/sample.hpp"
#include "materials/scattering/smooth_albedo.hpp"

namespace nadir::materials {

/// Chandrasekhar's H function of isotropic scatterers, in Hapke's closed form:
///     1 / H = 1 - w x (r0 + (1 - 2 r0 x) / 2 ln((1 + x) / x)),  r0 = (1 - g) / (1 + g),
///     g = sqrt(1 - w)
/// w in [0, 1], x in [0, 1]. Error below 1 % (test against the exact solution).
/// Source: Hapke, Icarus 157, 523 (2002), doi:10.1006/icar.2002.6853, eq. 13.
[[nodiscard]] double hapke_h(double w, double x) noexcept;

/// Reflectance of particulate surfaces (regolith, sand, soil, snow), isotropic multiple-scattering
/// approximation:
///
///     f = w / (4 pi) / (mu_ie + mu_oe) ((1 + B(g)) p(g) + H(mu_ie) H(mu_oe) - 1) R      [sr^-1]
///     p(g) = (1 + c)/2 (1 - b^2) / (1 - 2 b cos(g) + b^2)^(3/2)
///          + (1 - c)/2 (1 - b^2) / (1 + 2 b cos(g) + b^2)^(3/2)
///     B(g) = B0 / (1 + tan(g/2) / h)
///
/// with the phase angle g, 0 in back scatter: c = 1 is all backward, c = -1 all forward. For a
/// smooth surface mu_ie = mu_i, mu_oe = mu_o, R = 1. Slopes of mean angle theta-bar turn the
/// cosines into effective ones and cast shadows, R = (mu_ie / mu_i) S; f stays reciprocal. Domain:
/// w in [0, 1], b in [0, 1), c in [-1, 1], B0 in [0, 1], h > 0, theta-bar in [0, 60 deg]. `bind`
/// refuses parameters that reflect more than they receive: near w = 1 the error of H, or an
/// opposition effect that is not taken from elsewhere, can do that.
/// Deviations: none for a smooth surface. H of both papers as in 2002, without the anisotropic
/// multiple scattering and the coherent backscatter of that paper.
/// Source: Hapke, JGR 86, 3039 (1981), doi:10.1029/JB086iB04p03039; Icarus 59, 41 (1984),
/// doi:10.1016/0019-1035(84)90054-X (slopes); Icarus 67, 264 (1986) (B); Theory of Reflectance and
/// Emittance Spectroscopy, 2nd ed. (2012), ch. 6, 9, 12.
class BoundHapke {
 public:
  /// @throws InputError for parameters that gain energy; their domain is checked before
  BoundHapke(const Hapke& model, const BindContext& context);

  [[nodiscard]] spectral::Spectrum eval(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample(Vec3 wo,
                                                       const ScatteringDraw& u) const noexcept;
  [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept;
  [[nodiscard]] ScatteringTraits traits() const noexcept { return {}; }

 private:
  /// Effective cosines of a rough surface, and what the slopes' shadows leave of f.
  struct Relief {
    double mu_i, mu_o, factor;
  };
  [[nodiscard]] Relief relief(Vec3 wi, Vec3 wo) const noexcept;
  /// (1 + B) p.
  [[nodiscard]] double single_scattering(Vec3 wi, Vec3 wo) const noexcept;

  Hapke model_;
  spectral::Spectrum w_, w_r0_;  // w, and w r0 of the H function
  double tan_slope_ = 0.0, chi_ = 1.0;
  LobeMixture mixture_;
  SmoothAlbedo albedo_;
};

}  // namespace nadir::materials
