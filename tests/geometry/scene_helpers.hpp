#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include "core/frame.hpp"
#include "core/random.hpp"
#include "geometry/scene.hpp"
#include "geometry/scene_builder.hpp"

namespace nadir::geometry::test {

inline Vec3 random_direction(Rng& rng) {
  const double z = 2.0 * rng.next() - 1.0, azimuth = 2.0 * std::numbers::pi * rng.next();
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}
inline Vec3 random_point(Rng& rng, Vec3 lo, Vec3 hi) {
  const double x = rng.next(), y = rng.next(), z = rng.next();
  return {lo.x + x * (hi.x - lo.x), lo.y + y * (hi.y - lo.y), lo.z + z * (hi.z - lo.z)};
}

/// From anywhere at a distance of `from` to anywhere within `spread` of `target`.
inline Ray random_ray(Rng& rng, Vec3 target, double from, double spread) {
  const Vec3 aim = target + spread * rng.next() * random_direction(rng);
  const Vec3 origin = target + from * random_direction(rng);
  return {origin, normalised(aim - origin)};
}

inline Surface surface(TriangleMesh mesh, std::uint32_t material = 0) {
  std::uint32_t parts = 1;
  for (const std::uint32_t part : mesh.parts) parts = std::max(parts, part + 1);
  return {std::move(mesh), std::vector<std::uint32_t>(parts, material)};
}
inline Surface surface(Shape shape, std::uint32_t material = 0) { return {shape, {material}}; }

inline Scene scene_of(const Surface& s, const Affine& placement = {}) {
  SceneBuilder builder;
  builder.add(s, placement, 0);
  return builder.build();
}

/// (n + 1)^2 vertices at heights z(x, y) over the square of the given half size, normals up.
inline TriangleMesh grid_mesh(int n, double half, const std::function<double(double, double)>& z) {
  TriangleMesh mesh;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double x = half * (2.0 * i / n - 1.0), y = half * (2.0 * j / n - 1.0);
      mesh.positions.push_back({x, y, z(x, y)});
    }
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// A closed box of 12 triangles, normals outward.
inline TriangleMesh box_mesh(Vec3 lo, Vec3 hi) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.push_back({i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z});
  }
  const std::array<std::array<std::uint32_t, 4>, 6> faces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& f : faces) {
    mesh.triangles.push_back({f[0], f[1], f[2]});
    mesh.triangles.push_back({f[0], f[2], f[3]});
  }
  return mesh;
}

inline TriangleMesh one_triangle(Vec3 a, Vec3 b, Vec3 c) {
  return {{a, b, c}, {{0, 1, 2}}, {}, {}, {}};
}

/// The vertices as Embree stores them when the scene's bounds are those of the mesh.
inline TriangleMesh rounded(TriangleMesh mesh) {
  Vec3 lo = mesh.positions.front(), hi = lo;
  for (const Vec3& p : mesh.positions) {
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
  }
  const Vec3 c = 0.5 * (lo + hi);
  const auto f = [](double v) { return static_cast<double>(static_cast<float>(v)); };
  for (Vec3& p : mesh.positions) p = Vec3{f(p.x - c.x), f(p.y - c.y), f(p.z - c.z)} + c;
  return mesh;
}

struct BruteHit {
  double distance = std::numeric_limits<double>::infinity();
  std::uint32_t primitive = 0;
  double edge = 0.0;  ///< smallest barycentric coordinate of the hit
};

/// Every triangle in turn, in double: Moeller & Trumbore (1997), written for the tests alone.
inline std::optional<BruteHit> brute_force(const TriangleMesh& mesh, const Ray& ray) {
  BruteHit best;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    const Vec3 a = mesh.positions[t[0]], e1 = mesh.positions[t[1]] - a,
               e2 = mesh.positions[t[2]] - a;
    const Vec3 p = cross(ray.direction, e2);
    const double det = dot(e1, p);
    if (det == 0.0) continue;
    const Vec3 s = ray.origin - a, q = cross(s, e1);
    const double u = dot(s, p) / det, v = dot(ray.direction, q) / det, d = dot(e2, q) / det;
    if (u < 0.0 || v < 0.0 || u + v > 1.0 || d <= 0.0 || d > ray.max_distance) continue;
    if (d < best.distance) {
      best = {d, static_cast<std::uint32_t>(i), std::min({u, v, 1.0 - u - v})};
    }
  }
  if (std::isinf(best.distance)) return std::nullopt;
  return best;
}

}  // namespace nadir::geometry::test
