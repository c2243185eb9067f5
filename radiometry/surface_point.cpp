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
  return own_frame(draped ? Vec3{} : hit.tangent, outward).to_world(relief.normal_at(place));
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

spectral::Spectrum emission(const LitScene& scene, const SurfacePoint& point) noexcept {
  const std::uint32_t material = point.hit().material;
  if (const auto* constant = scene.constant_emission(material)) return *constant;
  return point.material().emissivity(point.wo()) * scene.black_body(material);
}

}  // namespace nadir::radiometry
