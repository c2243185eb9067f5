#include <algorithm>
#include <cmath>

#include "geometry/ray_query.hpp"
#include "geometry/shape_hit.hpp"

namespace nadir::geometry {
namespace {

/// Barycentric coordinates below this count as on the edge. Float rounding puts a ray in a million
/// exactly there; what happens elsewhere must not depend on it.
constexpr double on_edge = 1e-6;

struct Triangle {
  Vec3 a, b, c;
};

Vec3 vertex(const Item& item, std::uint32_t index) {
  const float* v = item.vertices + 3 * std::size_t{index};
  return {v[0], v[1], v[2]};
}

Triangle triangle(const Item& item, const std::optional<Affine>& placement,
                  std::uint32_t primitive) {
  const std::uint32_t* i = item.triangles + 3 * std::size_t{primitive};
  Triangle t{vertex(item, i[0]), vertex(item, i[1]), vertex(item, i[2])};
  if (placement) t = {placement->point(t.a), placement->point(t.b), placement->point(t.c)};
  return t;
}

/// Barycentric coordinates inside the triangle: those of the double ray, or where that passes just
/// outside (by float rounding it belongs to the neighbour) Embree's own, which are good to a few
/// units of float resolution even at grazing incidence.
Vec2 inside(Vec2 exact, const Found& found) {
  if (exact.x >= 0.0 && exact.y >= 0.0 && exact.x + exact.y <= 1.0) return exact;
  const double u = std::clamp(found.u, 0.0, 1.0);
  return {u, std::clamp(found.v, 0.0, 1.0 - u)};
}

/// Moeller & Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", J. Graphics Tools 2(1),
/// 1997.
std::optional<ExactHit> hit_triangle(const RayQuery& query, const Triangle& tri,
                                     const Found& found) {
  const Vec3 e1 = tri.b - tri.a, e2 = tri.c - tri.a, from_a = query.origin - tri.a;
  const Vec3 p = cross(query.direction, e2), q = cross(from_a, e1);
  const double determinant = dot(e1, p);
  if (determinant == 0.0) return std::nullopt;  // without area, or seen exactly from the side
  if (!(dot(e2, q) / determinant > 0.0)) return std::nullopt;  // the plane lies behind the origin
  const Vec2 uv =
      inside({dot(from_a, p) / determinant, dot(query.direction, q) / determinant}, found);
  ExactHit hit;
  hit.position = tri.a + uv.x * e1 + uv.y * e2;
  hit.t = dot(hit.position - query.origin, query.direction);
  hit.normal = cross(e1, e2);
  hit.uv = uv;
  if (std::min({uv.x, uv.y, 1.0 - uv.x - uv.y}) < on_edge) {
    hit.inward = (e1 + e2) / 3.0 - uv.x * e1 - uv.y * e2;
  }
  if (!(hit.t > 0.0 && hit.t <= query.t_max)) return std::nullopt;
  return hit;
}

std::optional<ExactHit> hit_shape(const RayQuery& query, const PlacedShape& placed,
                                  const std::optional<Affine>& placement) {
  Affine to_scene = placed.to_scene, from_scene = placed.from_scene;
  if (placement) {
    to_scene = *placement * to_scene;
    from_scene = from_scene * placement->inverse();
  }
  const auto local = first_hit(placed.shape, from_scene.point(query.origin),
                               from_scene.vector(query.direction), query.t_max);
  if (!local) return std::nullopt;
  ExactHit hit;
  hit.t = local->t;
  hit.position = to_scene.point(local->position);
  hit.normal = from_scene.linear.transposed() * local->normal;
  hit.uv = local->uv;
  return hit;
}

}  // namespace

std::optional<ExactHit> exact_hit(const RayQuery& query, const Found& found) {
  const Scene::Data& data = *query.data;
  const Instance* instance = nullptr;
  if (found.instance != RTC_INVALID_GEOMETRY_ID) {
    instance = &data.instances[found.instance - data.items.size()];
  }
  const Item& item = instance ? data.prototypes[instance->prototype].items[found.geometry]
                              : data.items[found.geometry];
  std::optional<Affine> placement;
  if (instance) placement = data.placement(*instance);
  auto hit = item.shape ? hit_shape(query, *item.shape, placement)
                        : hit_triangle(query, triangle(item, placement, found.primitive), found);
  if (!hit) return hit;
  hit->primitive = found.primitive;
  hit->item = &item;
  hit->instance = instance;
  if (!item.shape) {
    const bool turned = instance && instance->mirrored;
    if (turned != item.mirrored) hit->normal = -hit->normal;
  }
  return hit;
}

}  // namespace nadir::geometry
