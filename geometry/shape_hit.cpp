#include "geometry/shape_hit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/frame.hpp"
#include "geometry/bounds.hpp"

namespace nadir::geometry {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Line {
  Vec3 origin, direction;
  [[nodiscard]] Vec3 at(double t) const { return origin + t * direction; }
};

/// Where a line is inside a convex body; `face` names the face at either end.
struct Inside {
  double enter = -infinity, leave = infinity;
  int enter_face = 0, leave_face = 0;

  [[nodiscard]] bool empty() const { return !(enter <= leave); }
  void cut(const Inside& other) {
    if (other.enter > enter) {
      enter = other.enter;
      enter_face = other.enter_face;
    }
    if (other.leave < leave) {
      leave = other.leave;
      leave_face = other.leave_face;
    }
  }
};

constexpr Inside nowhere{infinity, -infinity, 0, 0};

/// lo <= origin + t direction <= hi; the faces are named `lo_face` and `lo_face` + 1.
Inside slab(double origin, double direction, double lo, double hi, int lo_face) {
  if (direction == 0.0) return lo <= origin && origin <= hi ? Inside{} : nowhere;
  Inside inside{(lo - origin) / direction, (hi - origin) / direction, lo_face, lo_face + 1};
  if (direction < 0.0) {
    std::swap(inside.enter, inside.leave);
    std::swap(inside.enter_face, inside.leave_face);
  }
  return inside;
}

/// |offset + t direction| <= radius, for a sphere or for the components across a cylinder's axis.
Inside ball(Vec3 offset, Vec3 direction, double radius, int face) {
  const double a = dot(direction, direction);
  const double distance = length(offset);
  if (a == 0.0) return distance <= radius ? Inside{} : nowhere;
  const double b = -dot(offset, direction);
  const double nearest = length(offset + (b / a) * direction);
  const double discriminant = a * (radius - nearest) * (radius + nearest);
  if (discriminant < 0.0) return nowhere;
  const double q = b + std::copysign(std::sqrt(discriminant), b);
  if (q == 0.0) return {0.0, 0.0, face, face};  // the line touches at its origin
  const auto [first, second] = std::minmax({(distance - radius) * (distance + radius) / q, q / a});
  return {first, second, face, face};
}

bool on_line(double t, double t_max) { return t > 0.0 && t <= t_max; }

double azimuth_fraction(double x, double y) {
  const double turn = std::atan2(y, x) / (2.0 * std::numbers::pi);
  return turn < 0.0 ? turn + 1.0 : turn;
}

std::optional<ShapeHit> hit(const Sphere& s, const Line& line, double t_max) {
  const Inside inside = ball(line.origin - s.centre, line.direction, s.radius, 0);
  if (inside.empty()) return std::nullopt;
  for (const double t : {inside.enter, inside.leave}) {
    if (!on_line(t, t_max)) continue;
    const Vec3 normal = normalised(line.at(t) - s.centre);
    return ShapeHit{t,
                    s.centre + s.radius * normal,
                    normal,
                    {azimuth_fraction(normal.x, normal.y),
                     std::atan2(std::hypot(normal.x, normal.y), normal.z) / std::numbers::pi}};
  }
  return std::nullopt;
}

ShapeHit on_disc(double t, Vec3 point, Vec3 centre, Vec3 normal, double radius) {
  const Frame frame = frame_about(normal);
  const Vec3 local = frame.to_local(point - centre);
  return {
      t,
      centre + local.x * frame.x + local.y * frame.y,
      normal,
      {std::min(1.0, std::hypot(local.x, local.y) / radius), azimuth_fraction(local.x, local.y)}};
}

std::optional<ShapeHit> hit(const Disc& disc, const Line& line, double t_max) {
  const Vec3 normal = normalised(disc.normal);
  const double approach = dot(line.direction, normal);
  if (approach == 0.0) return std::nullopt;
  const double t = dot(disc.centre - line.origin, normal) / approach;
  if (!on_line(t, t_max)) return std::nullopt;
  const Vec3 point = line.at(t);
  if (!(length(point - disc.centre) <= disc.radius)) return std::nullopt;
  return on_disc(t, point, disc.centre, normal, disc.radius);
}

/// Faces are numbered -x, +x, -y, +y, -z, +z.
ShapeHit on_box_face(const Box& box, double t, Vec3 p, int face) {
  const Vec3 size = box.hi - box.lo;
  p = {std::clamp(p.x, box.lo.x, box.hi.x), std::clamp(p.y, box.lo.y, box.hi.y),
       std::clamp(p.z, box.lo.z, box.hi.z)};
  const Vec3 f{(p.x - box.lo.x) / size.x, (p.y - box.lo.y) / size.y, (p.z - box.lo.z) / size.z};
  const double side = face % 2 == 0 ? -1.0 : 1.0;
  const Vec3& face_plane = side < 0.0 ? box.lo : box.hi;
  const auto number = static_cast<std::uint32_t>(face);
  switch (face / 2) {
    case 0:
      return {t, {face_plane.x, p.y, p.z}, {side, 0.0, 0.0}, {f.y, f.z}, number};
    case 1:
      return {t, {p.x, face_plane.y, p.z}, {0.0, side, 0.0}, {f.x, f.z}, number};
    default:
      return {t, {p.x, p.y, face_plane.z}, {0.0, 0.0, side}, {f.x, f.y}, number};
  }
}

std::optional<ShapeHit> hit(const Box& box, const Line& line, double t_max) {
  const Vec3 &o = line.origin, &d = line.direction;
  Inside inside = slab(o.x, d.x, box.lo.x, box.hi.x, 0);
  inside.cut(slab(o.y, d.y, box.lo.y, box.hi.y, 2));
  inside.cut(slab(o.z, d.z, box.lo.z, box.hi.z, 4));
  if (inside.empty()) return std::nullopt;
  if (on_line(inside.enter, t_max)) {
    return on_box_face(box, inside.enter, line.at(inside.enter), inside.enter_face);
  }
  if (on_line(inside.leave, t_max)) {
    return on_box_face(box, inside.leave, line.at(inside.leave), inside.leave_face);
  }
  return std::nullopt;
}

std::optional<ShapeHit> hit(const Plane& plane, const Line& line, double t_max) {
  if (line.direction.z == 0.0) return std::nullopt;
  const double t = (plane.centre.z - line.origin.z) / line.direction.z;
  if (!on_line(t, t_max)) return std::nullopt;
  const Vec3 point = line.at(t);
  const Vec2 uv{(point.x - plane.centre.x) / plane.size_x + 0.5,
                (point.y - plane.centre.y) / plane.size_y + 0.5};
  if (uv.x < 0.0 || uv.x > 1.0 || uv.y < 0.0 || uv.y > 1.0) return std::nullopt;
  return ShapeHit{t, {point.x, point.y, plane.centre.z}, {0.0, 0.0, 1.0}, uv};
}

enum CylinderFace { side_face = 0, base_face = 1, top_face = 2 };

struct Axis {
  Vec3 direction;
  double height;
};

ShapeHit on_cylinder(const Cylinder& c, const Axis& axis, double t, Vec3 point, int face) {
  if (face != side_face) {
    const double outward = face == base_face ? -1.0 : 1.0;
    ShapeHit cap =
        on_disc(t, point, face == base_face ? c.base : c.top, outward * axis.direction, c.radius);
    cap.face = static_cast<std::uint32_t>(face);
    return cap;
  }
  const double along = dot(point - c.base, axis.direction);
  const Vec3 normal = normalised(point - c.base - along * axis.direction);
  const Frame frame = frame_about(axis.direction);
  return {t,
          c.base + along * axis.direction + c.radius * normal,
          normal,
          {azimuth_fraction(dot(normal, frame.x), dot(normal, frame.y)), along / axis.height}};
}

std::optional<ShapeHit> hit(const Cylinder& c, const Line& line, double t_max) {
  const double height = length(c.top - c.base);
  const Axis axis{(c.top - c.base) / height, height};
  const Vec3 offset = line.origin - c.base;
  const double along = dot(offset, axis.direction), climb = dot(line.direction, axis.direction);
  Inside inside = ball(offset - along * axis.direction, line.direction - climb * axis.direction,
                       c.radius, side_face);
  inside.cut(slab(along, climb, 0.0, axis.height, base_face));
  if (inside.empty()) return std::nullopt;
  const auto counts = [&](double t, int face) {
    return on_line(t, t_max) && (c.capped || face == side_face);
  };
  if (counts(inside.enter, inside.enter_face)) {
    return on_cylinder(c, axis, inside.enter, line.at(inside.enter), inside.enter_face);
  }
  if (counts(inside.leave, inside.leave_face)) {
    return on_cylinder(c, axis, inside.leave, line.at(inside.leave), inside.leave_face);
  }
  return std::nullopt;
}

/// Bounds of centre + sum of s_k span_k over the unit ball of s.
template <std::size_t n>
Bounds round_bounds(const Affine& placement, Vec3 centre, const std::array<Vec3, n>& spans) {
  Vec3 squares;
  for (const Vec3& span : spans) {
    const Vec3 v = placement.vector(span);
    squares += {v.x * v.x, v.y * v.y, v.z * v.z};
  }
  const Vec3 half{std::sqrt(squares.x), std::sqrt(squares.y), std::sqrt(squares.z)};
  const Vec3 middle = placement.point(centre);
  return {middle - half, middle + half};
}

Bounds disc_bounds(const Affine& placement, Vec3 centre, Vec3 unit_normal, double radius) {
  const Frame frame = frame_about(unit_normal);
  return round_bounds<2>(placement, centre, {radius * frame.x, radius * frame.y});
}

Bounds bounds(const Sphere& s, const Affine& placement) {
  return round_bounds<3>(placement, s.centre,
                         {Vec3{s.radius, 0, 0}, Vec3{0, s.radius, 0}, Vec3{0, 0, s.radius}});
}
Bounds bounds(const Disc& d, const Affine& placement) {
  return disc_bounds(placement, d.centre, normalised(d.normal), d.radius);
}
Bounds bounds(const Box& b, const Affine& placement) {
  return transformed(Bounds{b.lo, b.hi}, placement);
}
Bounds bounds(const Plane& p, const Affine& placement) {
  const Vec3 half{0.5 * p.size_x, 0.5 * p.size_y, 0.0};
  return transformed(Bounds{p.centre - half, p.centre + half}, placement);
}
Bounds bounds(const Cylinder& c, const Affine& placement) {
  const Vec3 axis = normalised(c.top - c.base);
  return merged(disc_bounds(placement, c.base, axis, c.radius),
                disc_bounds(placement, c.top, axis, c.radius));
}

}  // namespace

std::optional<ShapeHit> first_hit(const Shape& shape, Vec3 origin, Vec3 direction, double t_max) {
  return std::visit([&](const auto& s) { return hit(s, Line{origin, direction}, t_max); }, shape);
}

Bounds bounds_of(const Shape& shape, const Affine& placement) {
  return std::visit([&](const auto& s) { return bounds(s, placement); }, shape);
}

}  // namespace nadir::geometry
