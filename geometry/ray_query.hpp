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
  std::uint32_t epochs = 0;
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
  std::uint32_t face = 0;  ///< of a shape
  const Item* item = nullptr;
  const Instance* instance = nullptr;
};

/// What Embree found, computed in double. None if the double ray does not meet it with
/// 0 < t <= t_max.
[[nodiscard]] std::optional<ExactHit> exact_hit(const RayQuery& query, const Found& found);

/// A triangle or the face of a shape.
struct FacetPlace {
  const Item* item = nullptr;
  const Instance* instance = nullptr;
  std::uint32_t number = 0;  ///< within the item
};

/// The place of a facet at given parameters; its t is 0.
[[nodiscard]] ExactHit exact_place(const Scene::Data& data, const FacetPlace& facet, Vec2 uv);

/// Corners of a triangle about the scene's centre, m.
struct Triangle {
  Vec3 a, b, c;
};
[[nodiscard]] Triangle triangle_of(const Scene::Data& data, const FacetPlace& facet);

/// The way from a shape's own axes to those about the scene's centre.
[[nodiscard]] Affine shape_to_scene(const Scene::Data& data, const FacetPlace& facet);

/// All that a hit tells about its place, for a ray that came along `direction`.
[[nodiscard]] Hit finished(const Scene::Data& data, const ExactHit& exact, Vec3 direction);

/// Fills in the texture coordinates and the tangent of a hit on a mesh that has them.
void add_texture(const Scene::Data& data, const ExactHit& exact, Hit& hit);

}  // namespace nadir::geometry
