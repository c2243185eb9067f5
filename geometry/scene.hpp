#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "core/vec.hpp"

namespace nadir::geometry {

/// A half line in scene axes (local east-north-up, metres, double). `direction` is a unit vector.
struct Ray {
  Vec3 origin;
  Vec3 direction;
  double max_distance = std::numeric_limits<double>::infinity();
};

/// Where a ray first meets a surface.
struct Hit {
  double distance = 0.0;    ///< from the ray's origin, m, double precision
  Vec3 position;            ///< on the surface, scene axes, m
  Vec3 normal;              ///< geometric unit normal, turned towards the side the ray came from
  Vec2 uv;                  ///< barycentric or parametric coordinates on the primitive
  std::uint32_t material = 0;  ///< index into the scenario's list of materials
  std::uint32_t object = 0;    ///< which object of the scenario, in the order of the file
  std::uint32_t instance = 0;  ///< number within an instance list, 0 where there is none
  std::uint32_t primitive = 0; ///< triangle or shape within its mesh
  bool back_face = false;      ///< the ray came from the side that the normal pointed away from
};

struct Bounds {
  Vec3 lo, hi;
};

/// All that rays can hit, ready to be traced from many threads. Cheap to copy (shared, immutable).
class Scene {
 public:
  struct Data;
  explicit Scene(std::shared_ptr<const Data> data);

  /// The first surface along the ray, or none.
  [[nodiscard]] std::optional<Hit> intersect(const Ray& ray) const;
  /// Whether any surface lies on the ray before its max_distance.
  [[nodiscard]] bool occluded(const Ray& ray) const;
  [[nodiscard]] Bounds bounds() const;
  /// Triangles and shapes stored, and those that instances stand for.
  [[nodiscard]] std::uint64_t stored_primitives() const;
  [[nodiscard]] std::uint64_t represented_primitives() const;

 private:
  std::shared_ptr<const Data> data_;
};

/// Origin for a ray that leaves `hit` towards `direction`: lifted off the surface on that side by a
/// few units of float resolution at that place, so that it neither meets the surface that it leaves
/// nor skips one a millimetre away.
[[nodiscard]] Vec3 leaving_origin(const Hit& hit, Vec3 direction);

}  // namespace nadir::geometry
