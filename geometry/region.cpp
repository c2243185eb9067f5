#include "geometry/region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "geometry/bounds.hpp"

namespace nadir::geometry {
namespace {

void require(bool good, const char* message) {
  if (!good) throw InputError{message};
}

/// A unit vector at right angles to a unit vector.
Vec3 perpendicular(Vec3 axis) {
  const Vec3 other = std::abs(axis.x) < 0.6 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
  return normalised(cross(axis, other));
}

Affine from_unit(const Box& box) {
  require(is_finite(box.lo) && is_finite(box.hi), "box: the corners must be finite");
  require(box.lo.x < box.hi.x && box.lo.y < box.hi.y && box.lo.z < box.hi.z,
          "box: every coordinate of the low corner must be below that of the high corner");
  return {scaling(box.hi - box.lo), box.lo};
}
Affine from_unit(const Sphere& sphere) {
  require(is_finite(sphere.centre), "sphere: the centre must be finite");
  require(std::isfinite(sphere.radius) && sphere.radius > 0.0,
          "sphere: the radius must be a positive number of metres");
  return {scaling({sphere.radius, sphere.radius, sphere.radius}), sphere.centre};
}
Affine from_unit(const Cylinder& cylinder) {
  require(is_finite(cylinder.base) && is_finite(cylinder.top),
          "cylinder: base and top must be finite");
  const Vec3 along = cylinder.top - cylinder.base;
  require(length(along) > 0.0, "cylinder: base and top must differ");
  require(std::isfinite(cylinder.radius) && cylinder.radius > 0.0,
          "cylinder: the radius must be a positive number of metres");
  const Vec3 axis = normalised(along), side = perpendicular(axis);
  return {{cylinder.radius * side, cylinder.radius * cross(axis, side), along}, cylinder.base};
}

bool is_regular(const Affine& map) {
  const Mat3& m = map.linear;
  const double size = length(m.x) * length(m.y) * length(m.z);
  // Below this share of the volume of three perpendicular axes the inverse has lost its digits.
  return is_finite(map.origin) && std::isfinite(size) && size > 0.0 &&
         std::abs(m.determinant()) > 1e-12 * size;
}

constexpr Interval nothing{std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()};
constexpr Interval everywhere{nothing.end, nothing.begin};

Interval common(Interval a, Interval b) {
  return {std::max(a.begin, b.begin), std::min(a.end, b.end)};
}

/// Where 0 <= origin + t direction <= 1.
Interval slab(double origin, double direction) {
  if (direction == 0.0) {
    return origin >= 0.0 && origin <= 1.0 ? everywhere : nothing;
  }
  const double a = -origin / direction, b = (1.0 - origin) / direction;
  return {std::min(a, b), std::max(a, b)};
}

/// Where |origin + t direction| <= 1. Counted from the point next to the centre, so that nothing
/// cancels for an origin far away.
Interval ball(Vec3 origin, Vec3 direction) {
  const double a = dot(direction, direction);
  if (a == 0.0) return dot(origin, origin) <= 1.0 ? everywhere : nothing;
  const double nearest = -dot(origin, direction) / a;
  const Vec3 off = origin + nearest * direction;
  const double left = 1.0 - dot(off, off);
  if (!(left > 0.0)) return nothing;
  const double half = std::sqrt(left / a);
  return {nearest - half, nearest + half};
}

Interval inside(const Box& /*unit*/, Vec3 o, Vec3 d) {
  return common(common(slab(o.x, d.x), slab(o.y, d.y)), slab(o.z, d.z));
}
Interval inside(const Sphere& /*unit*/, Vec3 o, Vec3 d) { return ball(o, d); }
Interval inside(const Cylinder& /*unit*/, Vec3 o, Vec3 d) {
  return common(slab(o.z, d.z), ball({o.x, o.y, 0.0}, {d.x, d.y, 0.0}));
}

bool in_unit(double x) { return x >= 0.0 && x <= 1.0; }
bool holds(const Box& /*unit*/, Vec3 p) { return in_unit(p.x) && in_unit(p.y) && in_unit(p.z); }
bool holds(const Sphere& /*unit*/, Vec3 p) { return dot(p, p) <= 1.0; }
bool holds(const Cylinder& /*unit*/, Vec3 p) {
  return in_unit(p.z) && p.x * p.x + p.y * p.y <= 1.0;
}

Bounds unit_bounds(const Box& /*unit*/) { return {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}; }
Bounds unit_bounds(const Sphere& /*unit*/) { return {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}}; }
Bounds unit_bounds(const Cylinder& /*unit*/) { return {{-1.0, -1.0, 0.0}, {1.0, 1.0, 1.0}}; }

}  // namespace

Region::Region(const RegionShape& shape, const Affine& placement) : shape_{shape} {
  to_scene_ = placement * std::visit([](const auto& s) { return from_unit(s); }, shape);
  require(is_regular(placement) && is_regular(to_scene_),
          "the placement must be finite and must not flatten the shape");
  from_scene_ = to_scene_.inverse();
}

std::optional<Interval> Region::crossing(const Ray& ray) const noexcept {
  const Vec3 o = from_scene_.point(ray.origin), d = from_scene_.vector(ray.direction);
  const Interval whole = std::visit([&](const auto& s) { return inside(s, o, d); }, shape_);
  const Interval part = common(whole, {0.0, ray.max_distance});
  if (!(part.begin < part.end)) return std::nullopt;
  return part;
}

bool Region::contains(Vec3 point) const noexcept {
  const Vec3 p = from_scene_.point(point);
  return std::visit([&](const auto& s) { return holds(s, p); }, shape_);
}

Bounds Region::bounds() const noexcept {
  return transformed(std::visit([](const auto& s) { return unit_bounds(s); }, shape_), to_scene_);
}

}  // namespace nadir::geometry
