#include "radiometry/lamps/light_tree_builder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/transform.hpp"
#include "geometry/bounds.hpp"

namespace nadir::radiometry {
namespace {

constexpr double pi = std::numbers::pi;

double angle_between(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

/// The least cone about both cones of axes, as in the source's appendix.
void join_cones(LightTreeItem& a, const LightTreeItem& b) {
  const LightTreeItem& wide = a.spread_rad >= b.spread_rad ? a : b;
  const LightTreeItem& narrow = &wide == &a ? b : a;
  const double between = angle_between(wide.axis, narrow.axis);
  Vec3 axis = wide.axis;
  double spread = wide.spread_rad;
  if (between + narrow.spread_rad > wide.spread_rad) {
    spread = 0.5 * (wide.spread_rad + between + narrow.spread_rad);
    const Vec3 about = cross(wide.axis, narrow.axis);
    if (spread >= pi || length(about) == 0.0) {
      spread = pi;
    } else {
      axis = normalised(rotation(normalised(about), spread - wide.spread_rad) * axis);
    }
  }
  a.axis = axis;
  a.spread_rad = spread;
}

LightTreeItem joined(LightTreeItem a, const LightTreeItem& b) {
  join_cones(a, b);
  a.box = geometry::merged(a.box, b.box);
  a.fade_rad = std::max(a.fade_rad, b.fade_rad);
  a.weight += b.weight;
  return a;
}

/// Surface-area orientation heuristic of the source: weight x size^2 x solid angle lit. The size is
/// that of the sphere that bounds, since that is what importance is computed from.
double cost(const LightTreeItem& set) {
  const double s = set.spread_rad, w = std::min(s + set.fade_rad, pi);
  const double lit =
      2.0 * pi * (1.0 - std::cos(s)) +
      0.5 * pi *
          (2.0 * w * std::sin(s) - std::cos(s - 2.0 * w) - 2.0 * s * std::sin(s) + std::cos(s));
  const Vec3 size = set.box.hi - set.box.lo;
  return set.weight * dot(size, size) * lit;
}

double coordinate(Vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

}  // namespace

LightTreeBuilder::LightTreeBuilder(const std::vector<LightTreeItem>& items) : items_{items} {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    heaviest_ = std::max(heaviest_, items_[i].weight);
    if (items_[i].weight > 0.0) order_.push_back(static_cast<std::uint32_t>(i));
  }
}

LightTree LightTreeBuilder::build() {
  tree_.place_of_.resize(items_.size());
  tree_.is_in_.resize(items_.size());
  if (!order_.empty()) add_node(part(0, order_.size()), {});
  return std::move(tree_);
}

LightTreeBuilder::Part LightTreeBuilder::part(std::size_t begin, std::size_t end) const {
  Part whole{begin, end, items_[order_[begin]]};
  for (std::size_t i = begin + 1; i < end; ++i) {
    whole.bound = joined(whole.bound, items_[order_[i]]);
  }
  return whole;
}

/// Lamps by where they lie along an axis, and what bounds those of each bin.
struct LightTreeBuilder::Bins {
  static constexpr std::size_t count = 16;
  std::array<std::optional<LightTreeItem>, count> sets;

  void add(std::size_t bin, const LightTreeItem& item) {
    sets[bin] = sets[bin] ? joined(*sets[bin], item) : item;
  }
  /// Cost of all bins up to each one, from the first or from the last; negative for no lamps.
  [[nodiscard]] std::array<double, count> costs(bool from_last) const {
    std::array<double, count> all{};
    std::optional<LightTreeItem> sum;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t bin = from_last ? count - 1 - k : k;
      if (sets[bin]) sum = sum ? joined(*sum, *sets[bin]) : *sets[bin];
      all[bin] = sum ? cost(*sum) : -1.0;
    }
    return all;
  }
};

void LightTreeBuilder::try_axis(const Part& whole, int axis, Split& best) const {
  const double lo = coordinate(whole.bound.box.lo, axis), hi = coordinate(whole.bound.box.hi, axis);
  if (!(hi > lo)) return;
  constexpr auto n = static_cast<double>(Bins::count);
  Bins bins;
  for (std::size_t i = whole.begin; i < whole.end; ++i) {
    const LightTreeItem& item = items_[order_[i]];
    const double place = coordinate(geometry::centre_of(item.box), axis);
    const auto bin = static_cast<std::size_t>((place - lo) / (hi - lo) * n);
    bins.add(std::min(bin, Bins::count - 1), item);
  }
  const auto below = bins.costs(false), above = bins.costs(true);
  for (std::size_t bin = 1; bin < Bins::count; ++bin) {
    if (below[bin - 1] < 0.0 || above[bin] < 0.0) continue;
    const double both = below[bin - 1] + above[bin];
    if (best.found && both >= best.cost) continue;
    best = {both, axis, lo + (hi - lo) * static_cast<double>(bin) / n, true};
  }
}

LightTreeBuilder::Split LightTreeBuilder::best_split(const Part& whole) const {
  Split best;
  for (int axis = 0; axis < 3; ++axis) try_axis(whole, axis, best);
  return best;
}

std::vector<LightTreeBuilder::Part> LightTreeBuilder::halved(const Part& whole) {
  const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(whole.begin);
  const auto end = order_.begin() + static_cast<std::ptrdiff_t>(whole.end);
  auto middle = begin;
  if (const Split split = best_split(whole); split.found) {
    middle = std::partition(begin, end, [&](std::uint32_t item) {
      return coordinate(geometry::centre_of(items_[item].box), split.axis) < split.place;
    });
  }
  // Lamps in one place, or parted by rounding alone: any halves do.
  if (middle == begin || middle == end) middle = begin + (end - begin) / 2;
  const auto cut = static_cast<std::size_t>(middle - order_.begin());
  return {part(whole.begin, cut), part(cut, whole.end)};
}

/// Halves the costliest part until there are as many as a node has places.
std::vector<LightTreeBuilder::Part> LightTreeBuilder::cut_up(const Part& whole) {
  std::vector<Part> parts{whole};
  while (parts.size() < LightTree::width) {
    const auto worth = [](const Part& p) { return p.size() > 1 ? cost(p.bound) : -1.0; };
    const auto costliest =
        std::max_element(parts.begin(), parts.end(),
                         [&](const Part& a, const Part& b) { return worth(a) < worth(b); });
    if (costliest->size() == 1) break;
    const std::vector<Part> halves = halved(*costliest);
    *costliest = halves[0];
    parts.push_back(halves[1]);
  }
  return parts;
}

void LightTreeBuilder::add_node(const Part& whole, LightTree::Link parent) {
  const auto index = static_cast<std::uint32_t>(tree_.nodes_.size());
  tree_.nodes_.emplace_back();
  tree_.nodes_[index].parent = parent;
  const std::vector<Part> parts = cut_up(whole);
  for (std::size_t slot = 0; slot < parts.size(); ++slot) {
    const Part& child = parts[slot];
    const LightTree::Link here{index, static_cast<std::uint8_t>(slot)};
    fill(tree_.nodes_[index], slot, child.bound);
    if (child.size() == 1) {
      const std::uint32_t item = order_[child.begin];
      tree_.nodes_[index].child[slot] = item;
      tree_.nodes_[index].is_item[slot] = true;
      tree_.place_of_[item] = here;
      tree_.is_in_[item] = true;
    } else {
      tree_.nodes_[index].child[slot] = static_cast<std::uint32_t>(tree_.nodes_.size());
      add_node(child, here);
    }
  }
}

void LightTreeBuilder::fill(LightTree::Node& node, std::size_t slot,
                            const LightTreeItem& bound) const {
  // A lamp 1e18 times weaker than the brightest would leave float; to draw it too often does no
  // harm.
  constexpr double least_weight = 1e-18;
  const auto set = [slot](auto& row, double value) { row[slot] = static_cast<float>(value); };
  const Vec3 centre = geometry::centre_of(bound.box);
  node.x[slot] = centre.x;
  node.y[slot] = centre.y;
  node.z[slot] = centre.z;
  set(node.radius, 0.5 * length(bound.box.hi - bound.box.lo) * (1.0 + 1e-6));
  set(node.axis_x, bound.axis.x);
  set(node.axis_y, bound.axis.y);
  set(node.axis_z, bound.axis.z);
  set(node.cos_spread, std::cos(bound.spread_rad));
  set(node.sin_spread, std::sin(bound.spread_rad));
  set(node.cos_fade, std::cos(bound.fade_rad) - 1e-6);
  set(node.weight, std::max(bound.weight / heaviest_, least_weight));
}

}  // namespace nadir::radiometry
