#pragma once

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
  [[nodiscard]] Vec3 to_local(Vec3 direction) const noexcept { return frame_.to_local(direction); }
  [[nodiscard]] Vec3 to_scene(Vec3 local) const noexcept { return frame_.to_world(local); }
  /// Whether the surface can scatter light from that direction at all: it comes from the side of
  /// the view or the material transmits, and a bump does not hold it above a surface that it is
  /// really below.
  [[nodiscard]] bool admits(Vec3 direction, Vec3 wi) const noexcept {
    if (!material_->traits.transmits && wi.z * wo_.z <= 0.0) return false;
    return !bumped_ || dot(direction, hit_->normal) * wi.z * wo_.z > 0.0;
  }
  /// The side that light can come from, for lamps; 0: both.
  [[nodiscard]] Vec3 lit_normal() const noexcept {
    return material_->traits.transmits ? Vec3{} : hit_->normal;
  }
  [[nodiscard]] geometry::Ray leaving(Vec3 direction) const noexcept {
    return {geometry::leaving_origin(*hit_, direction), direction};
  }

 private:
  const geometry::Hit* hit_;
  const materials::BoundMaterial* material_;
  Frame frame_;
  Vec3 wo_;
  bool bumped_ = false;
};

/// What the surface emits towards the ray's origin, W m^-2 sr^-1 um^-1.
[[nodiscard]] spectral::Spectrum emission(const LitScene& scene,
                                          const SurfacePoint& point) noexcept;

}  // namespace nadir::radiometry
