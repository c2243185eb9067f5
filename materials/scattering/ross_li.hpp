#pragma once

#include <optional>

#include "materials/scattering/bind_context.hpp"
#include "materials/scattering/held_angles.hpp"
#include "materials/scattering/lobe_mixture.hpp"
#include "materials/scattering/models.hpp"
#include "materials/scattering/sample.hpp"
#include "materials/scattering/smooth_albedo.hpp"

namespace nadir::materials {

/// RossThick kernel of a dense leaf canopy, without hot spot:
///     K_vol = ((pi/2 - xi) cos(xi) + sin(xi)) / (mu_i + mu_o) - pi/4
/// with the phase angle xi. 0 where both directions are vertical.
[[nodiscard]] double ross_thick(const HeldAngles& angles) noexcept;

/// LiSparse-Reciprocal kernel of spheroid crowns and their shadows, h/b = 2 and b/r = 1:
///     K_geo = O - sec_i - sec_o + (1 + cos(xi)) sec_i sec_o / 2
///     O = (t - sin(t) cos(t)) (sec_i + sec_o) / pi
///     cos(t) = 2 sqrt(D^2 + (tan_i tan_o sin(phi))^2) / (sec_i + sec_o), at most 1
/// with the shadows' distance D. 0 where both directions are vertical.
[[nodiscard]] double li_sparse_reciprocal(const HeldAngles& angles) noexcept;

/// Land surface as in the MODIS BRDF and albedo products (MCD43):
///
///     f = (f_iso + f_vol K_vol + f_geo K_geo) / pi                                       [sr^-1]
///
/// Reciprocal. Domain: weights >= 0. Beyond 80 degrees from the zenith both angles are held: the
/// kernels grow without bound there and f would turn negative. Against the published integrals,
/// which run to the horizon, that raises the black-sky albedo by up to 0.09 f_geo. Where the
/// sum still falls below 0, f is 0: K_geo reaches -3.4 for a vertical view, so with f_vol = 0 that
/// takes f_geo > 0.3 f_iso, and no usual weights of the MODIS products come near it (test). `bind`
/// refuses weights that reflect more than they receive from any direction. The RossThick kernel is
/// brightest in back scatter but has no hot-spot factor of its own (Maignan et al. 2004): the
/// weights of MCD43 were fitted without one, and would be too bright with it. Source: Wanner, Li &
/// Strahler, JGR 100, 21077 (1995), doi:10.1029/95JD02371; Lucht, Schaaf & Strahler, IEEE TGRS 38,
/// 977 (2000), doi:10.1109/36.841980, eqs. 37 to 44.
class BoundRossLi {
 public:
  /// @throws InputError for weights that gain energy; their domain is checked before
  BoundRossLi(const RossLi& model, const BindContext& context);

  [[nodiscard]] spectral::Spectrum eval(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample(Vec3 wo,
                                                       const ScatteringDraw& u) const noexcept;
  [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept;
  [[nodiscard]] ScatteringTraits traits() const noexcept { return {}; }

 private:
  spectral::Spectrum isotropic_, volumetric_, geometric_;  // divided by pi
  LobeMixture mixture_;
  SmoothAlbedo albedo_;
};

}  // namespace nadir::materials
