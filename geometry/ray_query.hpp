#pragma once
// Private to this folder: one ray on its way through Embree, kept in double beside it.

#include <limits>

#include "geometry/scene_data.hpp"

namespace nadir::geometry {

/// Embree hands the context back to callbacks, so it carries the ray in double.
struct RayQuery : embree::Context {
  const Scene::Data* data = nullptr;
  Vec3 origin;           ///< about the scene's centre, where the ray enters the bounds, m
  Vec3 direction;        ///< unit
  double entered = 0.0;  ///< distance from the ray's own origin to `origin`, m
  double t_max = std::numeric_limits<double>::infinity();  ///< from `origin`, m
  double t_exit = 0.0;    ///< where the ray leaves the bounds, from `origin`, m
  double set_back = 0.0;  ///< how far before `origin` Embree starts, m
};

/// Which primitive Embree found, and its float barycentric coordinates.
struct Found {
  std::uint32_t geometry = 0, instance = 0, primitive = 0;
  double u = 0.0, v = 0.0;
};

/// The same place in double.
struct ExactHit {
  double t = 0.0;  ///< from RayQuery::origin, m
  Vec3 position;   ///< about the scene's centre, m
  Vec3 normal;     ///< outward or by winding, not normalised
  Vec2 uv;
  Vec3 inward{};  ///< from an edge or vertex of a triangle to its centroid, m; elsewhere 0
  std::uint32_t primitive = 0;
  const Item* item = nullptr;
  const Instance* instance = nullptr;
};

/// What Embree found, computed in double. None if the double ray does not meet it with
/// 0 < t <= t_max.
[[nodiscard]] std::optional<ExactHit> exact_hit(const RayQuery& query, const Found& found);

/// Fills in the texture coordinates and the tangent of a hit on a mesh that has them.
void add_texture(const Scene::Data& data, const ExactHit& exact, Hit& hit);

}  // namespace nadir::geometry
