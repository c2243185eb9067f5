#include <algorithm>
#include <cmath>

#include "geometry/ray_query.hpp"
#include "geometry/shape_hit.hpp"

namespace nadir::geometry {
namespace {

/// Barycentric coordinates below this count as on the edge. Float rounding puts a ray in a million
/// exactly there; what happens elsewhere must not depend on it.
constexpr double on_edge = 1e-6;

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

ExactHit on_triangle(const Triangle& tri, Vec2 uv) {
  const Vec3 e1 = tri.b - tri.a, e2 = tri.c - tri.a;
  ExactHit hit;
  hit.position = tri.a + uv.x * e1 + uv.y * e2;
  hit.normal = cross(e1, e2);
  hit.uv = uv;
  if (std::min({uv.x, uv.y, 1.0 - uv.x - uv.y}) < on_edge) {
    hit.inward = (e1 + e2) / 3.0 - uv.x * e1 - uv.y * e2;
  }
  return hit;
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
  ExactHit hit = on_triangle(tri, uv);
  hit.t = dot(hit.position - query.origin, query.direction);
  if (!(hit.t > 0.0 && hit.t <= query.t_max)) return std::nullopt;
  return hit;
}

ExactHit in_scene(const ShapeHit& local, const Affine& to_scene, const Affine& from_scene) {
  ExactHit hit;
  hit.t = local.t;
  hit.position = to_scene.point(local.position);
  hit.normal = from_scene.linear.transposed() * local.normal;
  hit.uv = local.uv;
  hit.face = local.face;
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
  return in_scene(*local, to_scene, from_scene);
}

void turn_outward(ExactHit& hit) {
  if (hit.item->shape) return;
  const bool turned = hit.instance && hit.instance->mirrored;
  if (turned != hit.item->mirrored) hit.normal = -hit.normal;
}

std::optional<Affine> placement_of(const Scene::Data& data, const Instance* instance) {
  if (!instance) return std::nullopt;
  return data.placement(*instance);
}

}  // namespace

Triangle triangle_of(const Scene::Data& data, const FacetPlace& facet) {
  return triangle(*facet.item, placement_of(data, facet.instance), facet.number);
}

Affine shape_to_scene(const Scene::Data& data, const FacetPlace& facet) {
  const Affine& to_scene = facet.item->shape->to_scene;
  return facet.instance ? data.placement(*facet.instance) * to_scene : to_scene;
}

ExactHit exact_place(const Scene::Data& data, const FacetPlace& facet, Vec2 uv) {
  ExactHit hit;
  if (facet.item->shape) {
    const Affine to_scene = shape_to_scene(data, facet);
    const auto& shape = facet.item->shape->shape;
    hit = in_scene(on_face(shape, facet.number, uv), to_scene, to_scene.inverse());
  } else {
    hit = on_triangle(triangle_of(data, facet), uv);
    hit.primitive = facet.number;
  }
  hit.item = facet.item;
  hit.instance = facet.instance;
  turn_outward(hit);
  return hit;
}

std::optional<ExactHit> exact_hit(const RayQuery& query, const Found& found) {
  const Scene::Data& data = *query.data;
  const Instance* instance = nullptr;
  if (found.instance != RTC_INVALID_GEOMETRY_ID) {
    instance = &data.instances[found.instance - data.items.size()];
  }
  const Item& item = instance ? data.prototypes[instance->prototype].items[found.geometry]
                              : data.items[found.geometry];
  const auto placement = placement_of(data, instance);
  auto hit = item.shape ? hit_shape(query, *item.shape, placement)
                        : hit_triangle(query, triangle(item, placement, found.primitive), found);
  if (!hit) return hit;
  hit->primitive = found.primitive;
  hit->item = &item;
  hit->instance = instance;
  turn_outward(*hit);
  return hit;
}

}  // namespace nadir::geometry
