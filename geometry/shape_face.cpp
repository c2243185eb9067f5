#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/frame.hpp"
#include "geometry/shape_hit.hpp"

namespace nadir::geometry {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;

Vec3 on_circle(const Frame& frame, double turn_fraction) {
  const double azimuth = full_turn * turn_fraction;
  return std::cos(azimuth) * frame.x + std::sin(azimuth) * frame.y;
}

ShapeHit disc_place(Vec3 centre, Vec3 normal, double radius, Vec2 uv) {
  return {0.0, centre + uv.x * radius * on_circle(frame_about(normal), uv.y), normal, uv};
}

ShapeHit place(const Sphere& s, std::uint32_t /*face*/, Vec2 uv) {
  const double polar = std::numbers::pi * uv.y;
  const Vec3 normal = std::sin(polar) * on_circle({}, uv.x) + std::cos(polar) * Frame{}.z;
  return {0.0, s.centre + s.radius * normal, normal, uv};
}

ShapeHit place(const Disc& d, std::uint32_t /*face*/, Vec2 uv) {
  return disc_place(d.centre, normalised(d.normal), d.radius, uv);
}

ShapeHit place(const Box& box, std::uint32_t face, Vec2 uv) {
  const Vec3 size = box.hi - box.lo;
  const double side = face % 2 == 0 ? 0.0 : 1.0, outward = 2.0 * side - 1.0;
  // The sides themselves, free of rounding.
  const Vec3& plane = side == 0.0 ? box.lo : box.hi;
  const auto at = [&](Vec3 f) {
    return Vec3{box.lo.x + f.x * size.x, box.lo.y + f.y * size.y, box.lo.z + f.z * size.z};
  };
  ShapeHit hit;
  switch (face / 2) {
    case 0:
      hit = {0.0, at({0.0, uv.x, uv.y}), {outward, 0.0, 0.0}, uv, face};
      hit.position.x = plane.x;
      return hit;
    case 1:
      hit = {0.0, at({uv.x, 0.0, uv.y}), {0.0, outward, 0.0}, uv, face};
      hit.position.y = plane.y;
      return hit;
    default:
      hit = {0.0, at({uv.x, uv.y, 0.0}), {0.0, 0.0, outward}, uv, face};
      hit.position.z = plane.z;
      return hit;
  }
}

ShapeHit place(const Plane& p, std::uint32_t /*face*/, Vec2 uv) {
  const Vec3 offset{(uv.x - 0.5) * p.size_x, (uv.y - 0.5) * p.size_y, 0.0};
  return {0.0, p.centre + offset, {0.0, 0.0, 1.0}, uv};
}

ShapeHit place(const Cylinder& c, std::uint32_t face, Vec2 uv) {
  const Vec3 axis = normalised(c.top - c.base);
  if (face != 0) {
    const bool top = face == 2;
    ShapeHit hit = disc_place(top ? c.top : c.base, top ? axis : -axis, c.radius, uv);
    hit.face = face;
    return hit;
  }
  const Vec3 normal = on_circle(frame_about(axis), uv.x);
  return {0.0, c.base + uv.y * (c.top - c.base) + c.radius * normal, normal, uv};
}

/// The largest eigenvalue of a symmetric matrix.
/// Source: O. K. Smith, "Eigenvalues of a symmetric 3 x 3 matrix", Comm. ACM 4 (1961) 168,
/// doi:10.1145/355578.366316.
double largest_eigenvalue(const Mat3& m) {
  const double mean = (m.x.x + m.y.y + m.z.z) / 3.0;
  const Mat3 rest{m.x - mean * Vec3{1, 0, 0}, m.y - mean * Vec3{0, 1, 0},
                  m.z - mean * Vec3{0, 0, 1}};
  const double p =
      std::sqrt((dot(rest.x, rest.x) + dot(rest.y, rest.y) + dot(rest.z, rest.z)) / 6.0);
  if (p == 0.0) return mean;
  const double r = std::clamp(rest.determinant() / (2.0 * p * p * p), -1.0, 1.0);
  return mean + 2.0 * p * std::cos(std::acos(r) / 3.0);
}

/// The longest image of a unit vector, in space or (below) in the plane of two axes.
double longest(const Mat3& m) { return std::sqrt(largest_eigenvalue(m.transposed() * m)); }
double longest(const Mat3& m, const Frame& frame) {
  const Vec3 x = m * frame.x, y = m * frame.y;
  const double xx = dot(x, x), yy = dot(y, y), xy = dot(x, y);
  return std::sqrt(0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), xy));
}

FacetSize disc_size(Vec3 unit_normal, double radius, const Mat3& m) {
  const double r = radius * longest(m, frame_about(unit_normal));
  return {false, r, full_turn * r};
}

FacetSize size(const Sphere& s, std::uint32_t /*face*/, const Mat3& m) {
  return {false, full_turn * s.radius * longest(m, {}), std::numbers::pi * s.radius * longest(m)};
}
FacetSize size(const Disc& d, std::uint32_t /*face*/, const Mat3& m) {
  return disc_size(normalised(d.normal), d.radius, m);
}
FacetSize size(const Box& b, std::uint32_t face, const Mat3& m) {
  const Vec3 s = b.hi - b.lo;
  const std::array<double, 3> along{s.x * length(m.x), s.y * length(m.y), s.z * length(m.z)};
  const std::uint32_t across = face / 2;
  return {false, along[across == 0 ? 1 : 0], along[across == 2 ? 1 : 2]};
}
FacetSize size(const Plane& p, std::uint32_t /*face*/, const Mat3& m) {
  return {false, p.size_x * length(m.x), p.size_y * length(m.y)};
}
FacetSize size(const Cylinder& c, std::uint32_t face, const Mat3& m) {
  const Vec3 axis = normalised(c.top - c.base);
  if (face != 0) return disc_size(axis, c.radius, m);
  return {false, full_turn * c.radius * longest(m, frame_about(axis)),
          length(m * (c.top - c.base))};
}

}  // namespace

std::uint32_t faces_of(const Shape& shape) {
  if (std::holds_alternative<Box>(shape)) return 6;
  const auto* cylinder = std::get_if<Cylinder>(&shape);
  return cylinder && cylinder->capped ? 3 : 1;
}

ShapeHit on_face(const Shape& shape, std::uint32_t face, Vec2 uv) {
  return std::visit([&](const auto& s) { return place(s, face, uv); }, shape);
}

FacetSize face_size(const Shape& shape, std::uint32_t face, const Mat3& placement) {
  return std::visit([&](const auto& s) { return size(s, face, placement); }, shape);
}

}  // namespace nadir::geometry
