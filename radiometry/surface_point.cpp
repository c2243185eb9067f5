#include "radiometry/surface_point.hpp"

#include <cmath>

namespace nadir::radiometry {
namespace {

using geometry::Hit;

// Below this a direction has no azimuth worth the name: its sine of the zenith angle.
constexpr double vanishing = 1e-6;

/// Axes about z with x along the part of `along` that lies in the surface; false if there is none.
bool frame_along(Vec3 z, Vec3 along, Frame& frame) {
  const Vec3 x = along - dot(along, z) * z;
  const double size = length(x);
  if (size < vanishing) return false;
  frame.z = z;
  frame.x = x / size;
  frame.y = cross(z, frame.x);
  return true;
}

/// The surface's own axes, which do not depend on the view.
/// @param tangent  its texture's, or 0
Frame own_frame(Vec3 tangent, Vec3 outward) {
  Frame frame;
  if (dot(tangent, tangent) > 0.0 && frame_along(outward, tangent, frame)) return frame;
  if (frame_along(outward, {1.0, 0.0, 0.0}, frame)) return frame;
  frame_along(outward, {0.0, 1.0, 0.0}, frame);
  return frame;
}

/// The normal of a bumped surface. Slopes of a draped relief count along east and north.
Vec3 bumped(const materials::ReliefMap& relief, const Hit& hit, Vec3 outward) {
  const bool draped = relief.frame.by == materials::MapFrame::By::ground;
  const Vec2 place = draped ? Vec2{hit.position.x, hit.position.y} : hit.texture;
  Vec3 normal = relief.normal_at(place);
  // The frame's y runs along the other axis of the map, or against it: under a ceiling, and where
  // texture coordinates are mirrored.
  const bool against = draped ? outward.z < 0.0 : hit.mirrored_texture != hit.back_face;
  if (against) normal.y = -normal.y;
  return own_frame(draped ? Vec3{} : hit.tangent, outward).to_world(normal);
}

}  // namespace

SurfacePoint::SurfacePoint(const LitScene& scene, const geometry::Ray& ray, const Hit& hit) noexcept
    : hit_{&hit}, material_{&scene.material(hit.material)} {
  Vec3 outward = hit.back_face ? -hit.normal : hit.normal;
  const Vec3 view = -ray.direction;
  const materials::ReliefMap* relief = scene.relief(hit.material);
  if (relief != nullptr) {
    const Vec3 normal = bumped(*relief, hit, outward);
    // A bump that is seen from behind would show the inside of the surface: it is flat there.
    if (dot(normal, view) * dot(outward, view) > 0.0) {
      outward = normal;
      bumped_ = true;
    }
  }
  if (material_->traits.anisotropic) {
    frame_ = own_frame(hit.tangent, outward);
  } else if (!frame_along(outward, view, frame_)) {
    frame_ = frame_about(outward);
  }
  wo_ = frame_.to_local(view);
}

Vec3 SurfacePoint::outgoing(Vec3 wi) const noexcept {
  const Vec3 towards = frame_.to_world(wi);
  return !bumped_ || agrees(towards, wi) ? towards : mirrored(towards);
}

bool SurfacePoint::scattered(Vec3 towards, spectral::Spectrum& f_cos) const noexcept {
  const Vec3 wi = frame_.to_local(towards);
  const auto& model = material_->scattering;
  if (!bumped_) {
    if (!material_->traits.transmits && wi.z * wo_.z <= 0.0) return false;
    f_cos = materials::eval(model, wi, wo_);
    f_cos *= static_cast<float>(std::abs(wi.z));
    return true;
  }
  if (!material_->traits.transmits && dot(towards, hit_->normal) <= 0.0) return false;
  f_cos = spectral::Spectrum{material_->own_emissivity.count()};
  if (agrees(towards, wi)) {
    f_cos.add_scaled(materials::eval(model, wi, wo_), static_cast<float>(std::abs(wi.z)));
  }
  const Vec3 twin = mirrored(towards), wi_twin = frame_.to_local(twin);
  if (!agrees(twin, wi_twin)) {
    f_cos.add_scaled(materials::eval(model, wi_twin, wo_), static_cast<float>(std::abs(wi_twin.z)));
  }
  return true;
}

double SurfacePoint::pdf(Vec3 towards) const noexcept {
  const Vec3 wi = frame_.to_local(towards);
  const auto& model = material_->scattering;
  if (!bumped_) return materials::pdf(model, wi, wo_);
  const Vec3 twin = mirrored(towards), wi_twin = frame_.to_local(twin);
  return (agrees(towards, wi) ? materials::pdf(model, wi, wo_) : 0.0) +
         (agrees(twin, wi_twin) ? 0.0 : materials::pdf(model, wi_twin, wo_));
}

spectral::Spectrum emission(const LitScene& scene, const SurfacePoint& point) {
  if (!scene.emits()) return spectral::Spectrum{scene.lanes().count()};
  spectral::Spectrum scratch;
  if (const auto* even = scene.even_emission(point.hit(), scratch)) return *even;
  return scene.emissivity(point.hit().material, point.wo()) * scene.black_body(point.hit());
}

}  // namespace nadir::radiometry
