#pragma once

#include <optional>

#include "materials/scattering/bind_context.hpp"
#include "materials/scattering/coated_base.hpp"
#include "materials/scattering/facet_slopes.hpp"
#include "materials/scattering/models.hpp"
#include "materials/scattering/optical_constants.hpp"
#include "materials/scattering/sample.hpp"

namespace nadir::materials {

/// Sea or lake in the wind: glitter of facets with Gaussian slopes, water that scatters beneath
/// them, and foam.
///
///     f = (1 - w) (f_g + f_b) + w rho_f / pi                                            [sr^-1]
///     f_g = F(omega) p(z_u, z_c) G2 / (4 |i.z| |o.z| cos^4 beta)
///
/// beta is the tilt of the facet half-way between i and o, omega the angle of incidence on it, F
/// Fresnel's reflectance with n and k of each lane, p the density of the slopes z_u along and z_c
/// across the wind: Gaussian with the variances of Cox and Munk for a clean surface,
///
///     upwind 0.00316 W (standard error 0.004),  crosswind 0.003 + 0.00192 W (0.002)
///
/// W in m/s, 41 ft (12.5 m) above the sea. The upwind one, 0 without wind, is held at 1e-4 or
/// more (reached at 0.03 m/s; a fortieth of its error). G2 is Smith's masking and shadowing, see
/// FacetSlopes, which Cox and Munk leave out: their glitter grows without bound at the
/// horizon. Left out are the skewness and peakedness of their Gram-Charlier series: at
/// 10 m/s they change the density by 10 to 20 % within two standard deviations, and make it
/// negative further out; and Smith's masking, without which energy is gained, takes slopes that are
/// alike up and down the wind.
///
/// f_b is diffuse with the reflectance of the water body: of the light that has come through the
/// surface, the share that leaves it again; CoatedBase dims it by what the surface reflects.
/// White caps cover w = 2.95e-6 W^3.52 (W 10 m above the sea; the 2 % to 12.5 m are neglected);
/// their reflectance rho_f is 0.22 to 0.5 um, falling to 0.132 at 0.85, 0.11 at 1.02, 0.033 at 1.65
/// and 0 from 2 um. Light that a facet sends down to another one counts as let through.
///
/// Reciprocal; albedo (1 - w) (A_g + rho_b (1 - A_g)) + w rho_f. The frame's x axis is east and
/// its y axis north. Domain: W from 0 to 20 m/s (Cox and Munk measured to 14).
///
/// Sources: Cox & Munk, J. Opt. Soc. Am. 44, 838 (1954), doi:10.1364/JOSA.44.000838; white caps:
/// Monahan & O'Muircheartaigh, J. Phys. Oceanogr. 10, 2094 (1980); Koepke, Appl. Opt. 23, 1816
/// (1984), doi:10.1364/AO.23.001816 (0.22); Frouin, Schwindling & Deschamps, J. Geophys. Res. 101,
/// 14361 (1996), doi:10.1029/96JC00629 (the fall: 40 % at 0.85, 50 % at 1.02, 85 % at 1.65 um).
class BoundCoxMunk {
 public:
  BoundCoxMunk(const CoxMunk& model, const BindContext& context);

  [[nodiscard]] spectral::Spectrum eval(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample(Vec3 wo,
                                                       const ScatteringDraw& u) const noexcept;
  [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept;
  [[nodiscard]] ScatteringTraits traits() const noexcept {
    return {.transmits = false, .anisotropic = slopes_.anisotropic(), .has_delta = false};
  }

 private:
  // Of directions above the surface; `through_o` is what it lets through to wo.
  [[nodiscard]] spectral::Spectrum all(Vec3 wi, Vec3 wo,
                                       const spectral::Spectrum& through_o) const noexcept;
  [[nodiscard]] spectral::Spectrum glitter(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double glitter_pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample_glitter(Vec3 wo, Vec2 u) const noexcept;
  /// How often to draw from the glitter: its share of the lane-averaged albedo.
  [[nodiscard]] double glitter_chance(const spectral::Spectrum& through_o) const noexcept;

  FacetSlopes slopes_;
  OpticalConstants index_;
  double foam_cover_;
  spectral::Spectrum foam_;  ///< cover times reflectance
  CoatedBase water_;
};

}  // namespace nadir::materials
