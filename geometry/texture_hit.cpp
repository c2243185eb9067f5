#include <cmath>

#include "geometry/ray_query.hpp"

namespace nadir::geometry {
namespace {

/// A corner of a triangle: where it is, and where on the texture.
struct Corner {
  Vec3 position;
  Vec2 texture;
};

Corner corner(const Item& item, std::uint32_t index) {
  const float* v = item.vertices + 3 * std::size_t{index};
  const auto& at = item.texture[index];
  return {{v[0], v[1], v[2]}, {at[0], at[1]}};
}

Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }

}  // namespace

/// With p = a + s e1 + t e2 and (u, v) linear in (s, t), dp/du follows from inverting the 2 x 2
/// matrix of texture differences, here without its determinant's size: only the direction counts.
void add_texture(const Scene::Data& data, const ExactHit& exact, Hit& hit) {
  const Item& item = *exact.item;
  const std::uint32_t* i = item.triangles + 3 * std::size_t{exact.primitive};
  const Corner a = corner(item, i[0]), b = corner(item, i[1]), c = corner(item, i[2]);
  const Vec2 d1 = b.texture - a.texture, d2 = c.texture - a.texture;
  hit.texture = {a.texture.x + exact.uv.x * d1.x + exact.uv.y * d2.x,
                 a.texture.y + exact.uv.x * d1.y + exact.uv.y * d2.y};
  const double determinant = d1.x * d2.y - d2.x * d1.y;
  if (determinant == 0.0) return;
  const double sign = std::copysign(1.0, determinant);
  const Vec3 e1 = b.position - a.position, e2 = c.position - a.position;
  Vec3 along = sign * (d2.y * e1 - d1.y * e2), across = sign * (d1.x * e2 - d2.x * e1);
  if (exact.instance) {
    const Affine placement = data.placement(*exact.instance);
    along = placement.vector(along);
    across = placement.vector(across);
  }
  const double before = length(along);
  along = along - dot(along, hit.normal) * hit.normal;
  const double after = length(along);
  // Along lies in the surface but for rounding; where little is left it was all rounding.
  if (!(after > 1e-6 * before)) return;
  hit.tangent = along / after;
  hit.mirrored_texture = dot(across, cross(hit.normal, hit.tangent)) < 0.0;
}

}  // namespace nadir::geometry
