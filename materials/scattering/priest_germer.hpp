#pragma once

#include <memory>
#include <optional>

#include "materials/scattering/albedo_table.hpp"
#include "materials/scattering/bind_context.hpp"
#include "materials/scattering/coated_base.hpp"
#include "materials/scattering/models.hpp"
#include "materials/scattering/optical_constants.hpp"
#include "materials/scattering/sample.hpp"

namespace nadir::materials {

/// Facets with Gaussian slopes over a diffuse base, the unpolarised element m_00 of Priest and
/// Germer's Mueller matrix:
///
///     f_s = F(beta) exp(-tan^2 theta / (2 sigma^2)) G / (8 pi sigma^2 cos^4 theta |i.z| |o.z|)
///
/// in sr^-1, with theta the tilt of the facet half-way between i and o, beta the angle of incidence
/// on it, and F Fresnel's reflectance with n and k of each lane. The original has no G, and
/// so reflects more than it receives towards grazing; here G is the masking and shadowing of
/// Torrance and Sparrow's V-shaped grooves, as in later polarimetric models,
///
///     G = min(1, 2 h.z i.z / cos beta, 2 h.z o.z / cos beta)
///
/// which never gains energy with any distribution of slopes, and at normal view changes nothing for
/// light within 60 degrees of the zenith. The diffuse base has the material's reflectance, dimmed
/// by what the facets reflect as CoatedBase says: the albedo is A_s + rho (1 - A_s). Reciprocal.
/// Domain: sigma (standard deviation of the slope along an axis) from 1e-4 to 1, n > 0, k >= 0.
///
/// Drawn: facet or base by their lane-averaged albedos; facets by the normals that are visible
/// between grooves (Heitz & d'Eon, Computer Graphics Forum 33(4), 2014, section 4: a normal or its
/// mirror image by the areas seen), the base by the cosine.
///
/// Sources: Priest & Germer, "Polarimetric BRDF in the microfacet model: theory and measurements",
/// Proc. 2000 Meeting of the Military Sensing Symposia Specialty Group on Passive Sensors;
/// Torrance & Sparrow, J. Opt. Soc. Am. 57, 1105 (1967); Hyde, Schmidt & Havrilla, Opt. Express 17,
/// 22138 (2009), which adds G and the diffuse part.
class BoundPriestGermer {
 public:
  BoundPriestGermer(const PriestGermer& model, const BindContext& context);

  [[nodiscard]] spectral::Spectrum eval(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample(Vec3 wo,
                                                       const ScatteringDraw& u) const noexcept;
  [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept;
  [[nodiscard]] ScatteringTraits traits() const noexcept { return {}; }

 private:
  // Of the facets, for directions above the surface.
  [[nodiscard]] double density(Vec3 h) const noexcept;
  [[nodiscard]] spectral::Spectrum facets(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double facets_pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] Vec3 draw_facet(Vec3 wo, const ScatteringDraw& u) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample_facets(
      Vec3 wo, const ScatteringDraw& u) const noexcept;

  OpticalConstants index_;
  double sigma_;
  CoatedBase base_;
};

}  // namespace nadir::materials
