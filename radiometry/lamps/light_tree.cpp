#include "radiometry/lamps/light_tree.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "radiometry/lamps/light_tree_builder.hpp"

namespace nadir::radiometry {
namespace {

/// Cosines in float are off by some 3e-7; tests for darkness leave room for that.
constexpr float slack = 1e-6F;

// A node's children are treated four at a time, without branches. Vectors of g++ and clang: neither
// makes them of the plain loop, for its selections and the errno of sqrt.
using Four [[gnu::vector_size(16)]] = float;
using FourBits [[gnu::vector_size(16)]] = std::int32_t;

Four load(const float* from) {
  Four four;
  std::memcpy(&four, from, sizeof four);
  return four;
}
Four all(float x) { return Four{x, x, x, x}; }
Four larger(Four a, Four b) { return a > b ? a : b; }

/// 1 / sqrt(x) for x > 0, relative error below 3e-7; large and finite at 0. Three Newton steps from
/// a guess by the exponent. Source of the guess: Lomont, "Fast Inverse Square Root", Purdue (2003).
Four inverse_root(Four x) {
  FourBits bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits = 0x5F375A86 - (bits >> 1);
  Four y;
  std::memcpy(&y, &bits, sizeof y);
  const Four half = 0.5F * x;
  for (int i = 0; i < 3; ++i) y *= 1.5F - half * y * y;
  return y;
}
Four root(Four x) {
  const Four positive = larger(x, Four{});
  return positive * inverse_root(positive);
}

/// cos(max(0, a - b)) from the cosines and sines of a and b, both in [0, pi].
Four cos_beyond(Four cos_a, Four cos_b, Four sin_b) {
  const Four beyond = cos_a * cos_b + root(1.0F - cos_a * cos_a) * sin_b;
  return cos_a >= cos_b - slack ? all(1.0F) : beyond;
}

/// The child whose share of the sum holds `place`, which becomes the place within the share. The
/// last one with a share where rounding leads past the end.
template <class Importances>
std::size_t child_at(const Importances& importance, double& place) {
  std::size_t last = 0;
  for (std::size_t slot = 0; slot < importance.size(); ++slot) {
    if (importance[slot] <= 0.0F) continue;
    last = slot;
    const auto share = static_cast<double>(importance[slot]);
    if (place < share) break;
    place -= share;
  }
  return last;
}

}  // namespace

LightTree::LightTree(const std::vector<LightTreeItem>& items) {
  *this = LightTreeBuilder{items}.build();
}

/// Returns their sum.
float LightTree::importances(const Node& node, Vec3 position, Vec3 normal,
                             Importances& of_children) noexcept {
  Row<float> from_x, from_y, from_z;
  for (std::size_t i = 0; i < width; ++i) {
    from_x[i] = static_cast<float>(position.x - node.x[i]);
    from_y[i] = static_cast<float>(position.y - node.y[i]);
    from_z[i] = static_cast<float>(position.z - node.z[i]);
  }
  const auto nx = static_cast<float>(normal.x), ny = static_cast<float>(normal.y),
             nz = static_cast<float>(normal.z);
  const float all_sides = normal == Vec3{} ? 1.0F : 0.0F;
  Four sum{};
  for (std::size_t i = 0; i < width; i += 4) {
    const auto of = [i](const Row<float>& row) { return load(&row[i]); };
    const Four vx = of(from_x), vy = of(from_y), vz = of(from_z), radius = of(node.radius);
    const Four d2 = larger(vx * vx + vy * vy + vz * vz, all(1e-30F)), inverse = inverse_root(d2);
    // The sphere spans the angle u; from inside it spans all directions (u = pi).
    const Four ratio = radius * inverse;
    const Four sin_u = ratio < 1.0F ? ratio : Four{};
    const Four cos_u = ratio < 1.0F ? root(1.0F - ratio * ratio) : all(-1.0F);
    // Emission: the angle to the axis, less spread and u.
    const Four cos_s = of(node.cos_spread), sin_s = of(node.sin_spread);
    const Four cos_su = cos_s * cos_u - sin_s * sin_u, sin_su = sin_s * cos_u + cos_s * sin_u;
    const Four cos_a =
        (vx * of(node.axis_x) + vy * of(node.axis_y) + vz * of(node.axis_z)) * inverse;
    const Four beyond = cos_beyond(cos_a, cos_su, sin_su);
    const Four emitted = sin_su < 0.0F ? all(1.0F) : beyond;  // spread + u beyond pi
    const Four shines = emitted >= of(node.cos_fade) ? larger(emitted, all(slack)) : Four{};
    // Incidence: the angle to the normal, less u.
    const Four cos_i = -(vx * nx + vy * ny + vz * nz) * inverse;
    const Four received = cos_beyond(cos_i, cos_u, sin_u) + slack;
    const Four meets = larger(received, all(all_sides));
    const Four importance = of(node.weight) * shines * meets / larger(d2, radius * radius);
    std::memcpy(&of_children[i], &importance, sizeof importance);
    sum += importance;
  }
  return sum[0] + sum[1] + sum[2] + sum[3];
}

std::optional<LightTree::Draw> LightTree::draw(Vec3 position, Vec3 normal,
                                               double choice) const noexcept {
  if (nodes_.empty()) return std::nullopt;
  const Node* node = nodes_.data();
  double probability = 1.0;
  while (true) {
    Importances importance;
    const float sum = importances(*node, position, normal, importance);
    if (!(sum > 0.0F)) return std::nullopt;
    double left = choice * static_cast<double>(sum);
    const std::size_t slot = child_at(importance, left);
    const auto chosen = static_cast<double>(importance[slot]);
    probability *= chosen / static_cast<double>(sum);
    if (node->is_item[slot]) return Draw{node->child[slot], probability};
    // What is left of the random number is uniform again.
    choice = std::clamp(left / chosen, 0.0, 1.0 - std::numeric_limits<double>::epsilon());
    node = &nodes_[node->child[slot]];
  }
}

double LightTree::probability(std::uint32_t item, Vec3 position, Vec3 normal) const noexcept {
  if (!is_in_[item]) return 0.0;
  double probability = 1.0;
  for (Link link = place_of_[item];; link = nodes_[link.node].parent) {
    Importances importance;
    const float sum = importances(nodes_[link.node], position, normal, importance);
    if (!(importance[link.slot] > 0.0F)) return 0.0;
    probability *= static_cast<double>(importance[link.slot]) / static_cast<double>(sum);
    if (link.node == 0) return probability;
  }
}

}  // namespace nadir::radiometry
