#include "geometry/scene.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/frame.hpp"
#include "geometry/bounds.hpp"
#include "geometry/ray_query.hpp"

namespace nadir::geometry {
namespace {

// In units of float_step times the size of the coordinates. The set-back lets Embree see surfaces
// that the rounding of the origin would put behind it; it is less than half the lift, so that the
// set-back origin of a leaving ray is still off its surface.
constexpr double set_back_steps = 2.0;
constexpr double lift_steps = 6.0;

/// Cuts [enter, exit] to where lo <= origin + t direction <= hi.
void clip(double origin, double direction, double lo, double hi, double& enter, double& exit) {
  if (direction == 0.0) {
    if (origin < lo || origin > hi) exit = -1.0;
    return;
  }
  const double a = (lo - origin) / direction, b = (hi - origin) / direction;
  enter = std::max(enter, std::min(a, b));
  exit = std::min(exit, std::max(a, b));
}

/// False if the ray does not touch the scene's bounds.
bool start(const Scene::Data& data, const Ray& ray, RayQuery& query) {
  if (data.stored == 0) return false;
  assert(is_finite(ray.origin) && std::abs(length(ray.direction) - 1.0) < 1e-6);
  const Vec3 o = ray.origin - data.centre, d = ray.direction;
  const Bounds& box = data.padded;
  double enter = 0.0, exit = ray.max_distance;
  clip(o.x, d.x, box.lo.x, box.hi.x, enter, exit);
  clip(o.y, d.y, box.lo.y, box.hi.y, enter, exit);
  clip(o.z, d.z, box.lo.z, box.hi.z, enter, exit);
  if (!(enter <= exit)) return false;
  embree::initialise(query);
  query.data = &data;
  query.origin = o + enter * d;
  query.direction = d;
  query.entered = enter;
  query.t_max = ray.max_distance - enter;
  query.t_exit = exit - enter;
  query.set_back = set_back_steps * rounding_at(data, query.origin);
  query.epochs = ray.epochs;
  return true;
}

/// The ray as Embree gets it, displaced sideways by `shift`.
RTCRay embree_ray(const RayQuery& query, Vec3 shift) {
  const Vec3 o = query.origin - query.set_back * query.direction + shift;
  RTCRay ray{};
  ray.org_x = static_cast<float>(o.x);
  ray.org_y = static_cast<float>(o.y);
  ray.org_z = static_cast<float>(o.z);
  ray.dir_x = static_cast<float>(query.direction.x);
  ray.dir_y = static_cast<float>(query.direction.y);
  ray.dir_z = static_cast<float>(query.direction.z);
  // Room for rounding at the far end: the double test decides.
  const double slack = 16.0 * float_step * (query.t_exit + query.data->extent);
  ray.tfar = static_cast<float>(query.t_exit + slack);
  ray.mask = query.epochs;
  return ray;
}

/// Refuses what the double ray does not meet.
void refuse_inexact(const RTCFilterFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) return;
  const auto& query = *static_cast<const RayQuery*>(arguments->context);
  const auto& hit = *reinterpret_cast<const RTCHit*>(arguments->hit);  // one ray a call: N is 1
  if (!exact_hit(query, {hit.geomID, hit.instID[0], hit.primID, hit.u, hit.v})) {
    arguments->valid[0] = 0;
  }
}

/// Displacements of the first try and of the retries.
struct Tries {
  Frame across;
  double step;
  int count;

  explicit Tries(const RayQuery& query)
      : across{frame_about(query.direction)},
        step{float_step * query.data->extent},
        // Only rays that go down can have slipped through the ground: those to the sky cost once.
        count{query.direction.z <= 0.0 ? 4 : 1} {}

  [[nodiscard]] Vec3 shift(int number) const {
    static constexpr Vec2 ways[4]{{0.0, 0.0}, {2.0, 0.7}, {-2.6, 3.1}, {-3.9, -7.0}};
    return step * (ways[number].x * across.x + ways[number].y * across.y);
  }
};

std::optional<ExactHit> trace(RayQuery& query, Vec3 shift, RTCFilterFunctionN filter) {
  RTCRayHit rayhit{};
  rayhit.ray = embree_ray(query, shift);
  rayhit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rayhit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  embree::intersect(query.data->top.get(), query, rayhit, filter);
  const RTCHit& hit = rayhit.hit;
  if (hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const auto exact = exact_hit(query, {hit.geomID, hit.instID[0], hit.primID, hit.u, hit.v});
  // Testing every candidate in double would cost all rays a third: only those that need it pay.
  return exact || filter ? exact : trace(query, shift, refuse_inexact);
}

std::uint64_t facet_number(const Scene::Data& data, const ExactHit& exact) {
  const Item& item = *exact.item;
  const std::uint64_t number = item.first_facet + (item.shape ? exact.face : exact.primitive);
  if (!exact.instance) return number;
  const Prototype& prototype = data.prototypes[exact.instance->prototype];
  return prototype.first_facet + exact.instance->number * prototype.facets + number;
}

}  // namespace

Hit finished(const Scene::Data& data, const ExactHit& exact, Vec3 direction) {
  Hit hit;
  hit.position = exact.position + data.centre;
  hit.normal = normalised(exact.normal);
  hit.back_face = dot(hit.normal, direction) > 0.0;
  if (hit.back_face) hit.normal = -hit.normal;
  hit.uv = exact.uv;
  hit.material = exact.item->material_of(exact.primitive);
  hit.object = exact.instance ? exact.instance->object : exact.item->object;
  hit.instance = exact.instance ? exact.instance->number : 0;
  hit.primitive = exact.primitive;
  hit.facet = facet_number(data, exact);
  // The second term matters only for a tiny scene far from the origin of its axes.
  hit.lift =
      std::max(lift_steps * rounding_at(data, exact.position), 0x1.0p-48 * largest(hit.position));
  const double to_middle = length(exact.inward);
  if (to_middle > 0.0) hit.inset = std::min(hit.lift / to_middle, 0.25) * exact.inward;
  if (!exact.item->texture.empty()) add_texture(data, exact, hit);
  return hit;
}

Scene::Scene(std::shared_ptr<const Data> data) : data_{std::move(data)} {}

std::optional<Hit> Scene::intersect(const Ray& ray) const {
  RayQuery query;
  if (!start(*data_, ray, query)) return std::nullopt;
  const Tries tries{query};
  for (int i = 0; i < tries.count; ++i) {
    if (const auto exact = trace(query, tries.shift(i), nullptr)) {
      Hit hit = finished(*data_, *exact, query.direction);
      hit.distance = query.entered + exact->t;
      return hit;
    }
  }
  return std::nullopt;
}

bool Scene::occluded(const Ray& ray) const {
  RayQuery query;
  if (!start(*data_, ray, query)) return false;
  const Tries tries{query};
  for (int i = 0; i < tries.count; ++i) {
    RTCRay shadow = embree_ray(query, tries.shift(i));
    embree::occluded(data_->top.get(), query, shadow, refuse_inexact);
    if (shadow.tfar < 0.0F) return true;
  }
  return false;
}

Bounds Scene::bounds() const { return data_->bounds; }
std::uint64_t Scene::stored_primitives() const { return data_->stored; }
std::uint64_t Scene::represented_primitives() const { return data_->represented; }

Vec3 leaving_origin(const Hit& hit, Vec3 direction) {
  const double lift = std::copysign(hit.lift, dot(direction, hit.normal));
  return hit.position + hit.inset + lift * hit.normal;
}

}  // namespace nadir::geometry
