#pragma once

#include "core/vec.hpp"
#include "materials/scattering/models.hpp"

namespace nadir::materials {

/// Below this cosine a surface is seen and lit by nobody (0.2 microarcseconds above the horizon):
/// every quantity of the facet models stays far inside the range of float above it.
inline constexpr double grazing_cosine = 1e-12;

/// How the slopes of a rough surface's facets are distributed, which of them are seen, and how to
/// draw one that is seen. Directions are in the surface's frame with z > 0, and the normals h too.
/// With the slopes p = h_x / h_z, q = h_y / h_z along the axes and t = (p/alpha_x)^2 +
/// (q/alpha_y)^2:
///
///     GGX       D(h) = 1 / (pi alpha_x alpha_y h_z^4 (1 + t)^2)
///     Beckmann  D(h) = exp(-t) / (pi alpha_x alpha_y h_z^4): Gaussian slopes, alpha^2 = 2 sigma^2
///
/// in facet area per solid angle of normals [sr^-1], normalised so that D h_z integrates to 1.
/// Slopes are ratios of components, never of angles, so that roughness 1e-4 keeps its digits
/// (relative error about 1e-11 there).
///
/// Masking is Smith's, Lambda(w) the ratio of masked to visible projected area:
///
///     GGX       Lambda = (sqrt(1 + 1/a^2) - 1) / 2
///     Beckmann  Lambda = exp(-a^2) / (2 a sqrt(pi)) - erfc(a) / 2
///
/// with 1/a the slope of the direction times the roughness along it. It fulfils
/// the identity that makes a facet model conserve energy: visible facets fill the projected area.
///
/// Sources: Walter et al., EGSR 2007, doi:10.2312/EGWR/EGSR07/195-206 (both distributions);
/// Heitz, "Understanding the masking-shadowing function in microfacet-based BRDFs", JCGT 3(2)
/// (2014) (anisotropic forms, height-correlated masking and shadowing, visible normals).
class FacetSlopes {
 public:
  /// Along the two axes, each from 1e-4 to 1.
  struct Roughness {
    double x = 0.1, y = 0.1;
  };
  /// @param azimuth_rad  of the first axis, anticlockwise from the frame's x
  FacetSlopes(SlopeDistribution kind, Roughness alpha, double azimuth_rad);

  [[nodiscard]] double density(Vec3 h) const noexcept;  ///< D [sr^-1]
  [[nodiscard]] double lambda(Vec3 w) const noexcept;   ///< Smith's Lambda, >= 0
  /// Share of the facets facing w that w sees: G1 = 1 / (1 + Lambda).
  [[nodiscard]] double visible(Vec3 w) const noexcept { return 1.0 / (1.0 + lambda(w)); }
  /// Share seen from both of two directions on the same side, heights correlated.
  [[nodiscard]] double visible(Vec3 a, Vec3 b) const noexcept {
    return 1.0 / (1.0 + lambda(a) + lambda(b));
  }
  /// Density of the normals of the facets that wo sees, D G1(wo) max(0, wo.h) / wo.z [sr^-1]:
  /// that of `draw`.
  [[nodiscard]] double visible_density(Vec3 h, Vec3 wo) const noexcept;
  /// A normal from that density; a unit vector, z > 0.
  [[nodiscard]] Vec3 draw(Vec3 wo, Vec2 u) const noexcept;

  [[nodiscard]] bool anisotropic() const noexcept { return alpha_.x != alpha_.y; }

 private:
  [[nodiscard]] Vec3 to_axes(Vec3 w) const noexcept {
    return {cos_ * w.x + sin_ * w.y, cos_ * w.y - sin_ * w.x, w.z};
  }
  [[nodiscard]] Vec3 from_axes(Vec3 w) const noexcept {
    return {cos_ * w.x - sin_ * w.y, cos_ * w.y + sin_ * w.x, w.z};
  }

  SlopeDistribution kind_;
  Roughness alpha_;
  double cos_, sin_;
};

/// What a reflecting facet model needs of a pair of directions above the surface.
struct Facet {
  Vec3 h;               ///< half-way between them
  double cosine = 0.0;  ///< between either of them and h
};
[[nodiscard]] inline Facet facet_between(Vec3 a, Vec3 b) noexcept {
  const Vec3 h = normalised(a + b);
  return {h, dot(a, h)};
}
/// The direction into which a facet of normal h mirrors wo.
[[nodiscard]] inline Vec3 mirrored_at(Vec3 h, Vec3 wo) noexcept {
  return normalised(h * (2.0 * dot(wo, h)) - wo);
}

/// A direction turned above the surface: opaque models treat both sides alike.
[[nodiscard]] inline Vec3 upward(Vec3 w) noexcept { return {w.x, w.y, w.z < 0.0 ? -w.z : w.z}; }
/// Not within grazing_cosine of the horizon.
[[nodiscard]] inline bool clear_of_horizon(Vec3 w) noexcept { return upward(w).z > grazing_cosine; }
/// Both of them so, and on the same side: where opaque facets scatter.
[[nodiscard]] inline bool both_seen(Vec3 wi, Vec3 wo) noexcept {
  return wi.z * wo.z > 0.0 && clear_of_horizon(wi) && clear_of_horizon(wo);
}

}  // namespace nadir::materials
