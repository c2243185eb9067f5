#pragma once

#include <memory>
#include <optional>

#include "materials/scattering/albedo_table.hpp"
#include "materials/scattering/bind_context.hpp"
#include "materials/scattering/facet_slopes.hpp"
#include "materials/scattering/models.hpp"
#include "materials/scattering/optical_constants.hpp"
#include "materials/scattering/sample.hpp"

namespace nadir::materials {

/// A rough interface: facets that reflect by Fresnel's equations with n and k of each lane,
///
///     f_r = F(o.h) D(h) G2(i, o) / (4 |i.z| |o.z|),      h half-way between i and o       [sr^-1]
///
/// with the distributions D and the height-correlated masking and shadowing G2 of FacetSlopes.
/// Opaque ones (metals, black dielectrics) absorb what the facets do not reflect.
///
/// One that transmits is the face of a solid of index n (k = 0) below the surface. Its facets
/// refract what they do not reflect: with n_o, n_i the indices on the sides of o and i and
/// h along -(n_i i + n_o o),
///
///     f_t = (1 - F) D(h) G1(i) G1(o) |i.h| |o.h| / (|i.z| |o.z|) n_i^2 / (n_i i.h + n_o o.h)^2
///           * (n_o / n_i)^2                                                              [sr^-1]
///
/// The last factor is that of radiance, which refraction compresses: L / n^2 is what is conserved,
/// and f_t(i, o) / n_o^2 is what is reciprocal. `albedo` counts energy and leaves the factor out.
/// The geometry, and with it the factor of radiance, takes one index for all lanes, their mean; F
/// takes each lane's own, at the angle outside of the solid, so that reflection and transmission of
/// a facet add up to 1, and are reciprocal, in every lane. Left out: the spread of refracted
/// directions by dispersion (0.4 degrees for crown glass from 0.4 to 0.7 um at 60 degrees).
///
/// Each path meets one facet; what a facet sends to another one is lost. Loss at normal view (and
/// at most at any angle, where that is more) for facets that reflect everything:
///
///     alpha      0.1            0.25           0.5            0.75    1
///     GGX        0.012 (0.117)  0.084 (0.162)  0.312 (0.318)  0.536   0.693 = ln 2
///     Beckmann   0.000 (0.087)  0.000 (0.092)  0.057 (0.132)  0.305   0.538
///
/// Sources: Walter et al., EGSR 2007, doi:10.2312/EGWR/EGSR07/195-206 (refraction: eq. 21, with
/// separable masking); Heitz, JCGT 3(2) (2014) (height-correlated masking); visible normals: see
/// FacetSlopes. Domain: roughness alpha from 1e-4 to 1, n > 0, k >= 0.
class BoundMicrofacet {
 public:
  BoundMicrofacet(const Microfacet& model, const BindContext& context);

  [[nodiscard]] spectral::Spectrum eval(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample(Vec3 wo,
                                                       const ScatteringDraw& u) const noexcept;
  [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept;
  [[nodiscard]] ScatteringTraits traits() const noexcept {
    return {.transmits = transmits_, .anisotropic = slopes_.anisotropic(), .has_delta = false};
  }

 private:
  /// Two directions turned so that wo is above the surface, and the indices on their sides.
  struct Pair {
    Vec3 wi, wo;
    double n_i = 1.0, n_o = 1.0;
  };
  [[nodiscard]] Pair pair(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] static double radiance_factor(const Pair& p) noexcept;  ///< (n_o / n_i)^2
  /// Reflectance of a facet per lane, for light at this cosine in the medium of that index.
  [[nodiscard]] spectral::Spectrum fresnel(double cosine, double n_o) const noexcept;
  [[nodiscard]] double reflection_pdf(const Pair& p) const noexcept;
  [[nodiscard]] double refraction_pdf(const Pair& p) const noexcept;
  /// `sample` with the weights of energy: without the factor of radiance.
  /// @param chance  of reflection; negative: by the lane-mean Fresnel reflectance, as `pdf` says
  [[nodiscard]] std::optional<ScatteringSample> draw(Vec3 wo, const ScatteringDraw& u,
                                                     double chance) const noexcept;

  FacetSlopes slopes_;
  OpticalConstants index_;
  bool transmits_;
  double mean_n_;
  std::shared_ptr<const AlbedoTable> reflected_, transmitted_;
};

}  // namespace nadir::materials
