#pragma once

#include <optional>

#include "materials/scattering/bind_context.hpp"
#include "materials/scattering/lobe_mixture.hpp"
#include "materials/scattering/models.hpp"
#include "materials/scattering/sample.hpp"
#include "materials/scattering/smooth_albedo.hpp"

namespace nadir::materials {

/// Semi-empirical reflectance of vegetation and soil:
///
///     f = (rho0 / pi) M(k) F(Theta) H(rho_c)                                             [sr^-1]
///     M = (mu_i mu_o (mu_i + mu_o))^(k - 1)              bowl (k < 1) or bell (k > 1)
///     F = (1 - Theta^2) / (1 + Theta^2 + 2 Theta cos(g))^(3/2)
///     H = 1 + (1 - rho_c) / (1 + G),  G = sqrt(tan_i^2 + tan_o^2 - 2 tan_i tan_o cos(phi))
///
/// with the phase angle g and the relative azimuth phi, both 0 in back scatter: the hot spot is at
/// G = 0, and Theta < 0 scatters backward. Lambertian for k = 1, Theta = 0, rho_c = 1. Reciprocal.
/// Domain: rho0 >= 0, k in [0, 2], Theta in (-1, 1), rho_c in [0, 1]. The three-parameter model
/// has rho_c = rho0.
/// Beyond 80 degrees from the zenith both angles are held: there M grows without bound for k < 1.
/// `bind` refuses parameters that reflect more than they receive from any direction.
/// Source: Rahman, Pinty & Verstraete, JGR 98, 20791 (1993), doi:10.1029/93JD02072, eqs. 2 to 6;
/// rho_c apart from rho0: Widlowski et al., JGR 111, D02116 (2006).
class BoundRahmanPintyVerstraete {
 public:
  /// @throws InputError for parameters that gain energy; their domain is checked before
  BoundRahmanPintyVerstraete(const RahmanPintyVerstraete& model, const BindContext& context);

  [[nodiscard]] spectral::Spectrum eval(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample(Vec3 wo,
                                                       const ScatteringDraw& u) const noexcept;
  [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept;
  [[nodiscard]] ScatteringTraits traits() const noexcept { return {}; }

 private:
  /// The parameters as the lanes need them.
  struct Terms {
    spectral::Spectrum amplitude;        ///< rho0 (1 - Theta^2) / pi
    spectral::Spectrum exponent;         ///< k - 1
    spectral::Spectrum lobe_base;        ///< (1 - |Theta|)^2
    spectral::Spectrum forward;          ///< 2 Theta where that is positive, else 0
    spectral::Spectrum backward;         ///< -2 Theta where that is positive, else 0
    spectral::Spectrum hot_spot;         ///< 1 - rho_c
    bool same_exponent, same_asymmetry;  ///< at all lanes: one power does
    double mean_asymmetry;
  };
  [[nodiscard]] static Terms terms_at(const RahmanPintyVerstraete& model,
                                      const spectral::Lanes& lanes);
  void multiply_bowl(spectral::Spectrum& f, float log_cosines) const noexcept;
  void multiply_lobe(spectral::Spectrum& f, double cos_phase) const noexcept;

  Terms terms_;
  LobeMixture mixture_;
  SmoothAlbedo albedo_;
};

}  // namespace nadir::materials
