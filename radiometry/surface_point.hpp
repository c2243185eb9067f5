#pragma once

#include <cmath>

#include "core/frame.hpp"
#include "geometry/scene.hpp"
#include "materials/bound_material.hpp"
#include "radiometry/lit_scene.hpp"

namespace nadir::radiometry {

/// A hit that is being solved: its material and the local frame in which that scatters.
///
/// z is the outward normal, bumped where the material has a relief. x is, for isotropic materials,
/// the direction of the view along the surface; for the others the growing texture coordinate u,
/// or without texture coordinates the scene's east along the surface (north where that vanishes).
class SurfacePoint {
 public:
  SurfacePoint(const LitScene& scene, const geometry::Ray& ray, const geometry::Hit& hit) noexcept;

  [[nodiscard]] const geometry::Hit& hit() const noexcept { return *hit_; }
  [[nodiscard]] const materials::BoundMaterial& material() const noexcept { return *material_; }
  [[nodiscard]] Vec3 wo() const noexcept { return wo_; }  ///< towards the ray's origin, local
  /// The direction (scene axes) of a local one. Where a bump holds it on the wrong side of the
  /// real surface it is folded back, mirrored at that surface: no light is lost, so that emission
  /// and reflection still add up to Kirchhoff's law.
  [[nodiscard]] Vec3 outgoing(Vec3 wi) const noexcept;
  /// f |cos| per lane for light from a direction (scene axes), what is folded onto it included.
  /// False where no light can come from there.
  [[nodiscard]] bool scattered(Vec3 towards, spectral::Spectrum& f_cos) const noexcept;
  /// Density with which a drawn direction, folded, is this one, sr^-1.
  [[nodiscard]] double pdf(Vec3 towards) const noexcept;
  /// Whether directions may be folded, so that `pdf` is not that of the model.
  [[nodiscard]] bool folds() const noexcept { return bumped_; }
  [[nodiscard]] double cosine(Vec3 towards) const noexcept {
    return std::abs(dot(towards, frame_.z));
  }
  /// The side that light can come from, for lamps; 0: both.
  [[nodiscard]] Vec3 lit_normal() const noexcept {
    return material_->traits.transmits ? Vec3{} : hit_->normal;
  }
  [[nodiscard]] geometry::Ray leaving(Vec3 direction) const noexcept {
    return {geometry::leaving_origin(*hit_, direction), direction};
  }

 private:
  /// Both sides of the surface agree whether a direction is on the side of the view.
  [[nodiscard]] bool agrees(Vec3 towards, Vec3 wi) const noexcept {
    return dot(towards, hit_->normal) * wi.z * wo_.z > 0.0;
  }
  [[nodiscard]] Vec3 mirrored(Vec3 towards) const noexcept {
    return towards - 2.0 * dot(towards, hit_->normal) * hit_->normal;
  }

  const geometry::Hit* hit_;
  const materials::BoundMaterial* material_;
  Frame frame_;
  Vec3 wo_;
  bool bumped_ = false;
};

/// What the surface emits towards the ray's origin, W m^-2 sr^-1 um^-1.
[[nodiscard]] spectral::Spectrum emission(const LitScene& scene, const SurfacePoint& point);

}  // namespace nadir::radiometry
