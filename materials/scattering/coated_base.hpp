#pragma once

#include <memory>

#include "materials/scattering/albedo_table.hpp"

namespace nadir::materials {

/// Diffuse matter under a coat of facets: it gets what the coat lets through, and the coat lets
/// through of its light what it would let in. With A(w) the coat's directional-hemispherical
/// reflectance and <A> its mean over the hemisphere, weighted with the cosine,
///
///     f = rho / pi (1 - A(i)) (1 - A(o)) / (1 - <A>)                              [sr^-1]
///
/// Reciprocal; with the coat the albedo is A(o) + rho (1 - A(o)): never above 1, and exactly 1
/// for a white base under a coat that absorbs nothing.
/// Source: Kelemen & Szirmay-Kalos, "A microfacet based coupled specular-matte BRDF model with
/// importance sampling", Eurographics 2001 short presentations, doi:10.2312/egs.20011036.
class CoatedBase {
 public:
  CoatedBase() = default;
  /// @param reflectance  rho per lane, in [0, 1]
  CoatedBase(std::shared_ptr<const AlbedoTable> coat, const spectral::Spectrum& reflectance);

  /// What the coat lets through in a direction, 1 - A(w): looked up once, used several times.
  [[nodiscard]] spectral::Spectrum through(Vec3 w) const noexcept;

  // Of the light seen from the direction that `through_o` belongs to:
  [[nodiscard]] spectral::Spectrum eval(Vec3 wi,
                                        const spectral::Spectrum& through_o) const noexcept;
  /// Albedo of coat and base together.
  [[nodiscard]] spectral::Spectrum albedo(const spectral::Spectrum& through_o) const noexcept;
  /// Share of the coat in the lane-averaged albedo: how often to draw from it.
  [[nodiscard]] double coat_share(const spectral::Spectrum& through_o) const noexcept;

 private:
  std::shared_ptr<const AlbedoTable> coat_;
  spectral::Spectrum reflectance_;
  spectral::Spectrum scale_;  ///< rho / (pi (1 - <A>)), 0 under a coat that lets nothing through
  bool black_ = true;
};

}  // namespace nadir::materials
