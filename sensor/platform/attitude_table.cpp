#include "sensor/platform/attitude_table.hpp"

#include <algorithm>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::sensor {

AttitudeTable::AttitudeTable(const Law& law, const std::vector<double>& borders_s) {
  if (borders_s.size() == 1) add({borders_s.front(), law(borders_s.front(), Side::after)});
  // A law over a long span in one piece might agree with the first guess by chance.
  const int least_steps = borders_s.size() > 16 ? 1 : 4;
  for (std::size_t i = 0; i + 1 < borders_s.size(); ++i) {
    const double start_s = borders_s[i], end_s = borders_s[i + 1];
    Node from{start_s, law(start_s, Side::after)};
    add(from);
    for (int k = 1; k <= least_steps; ++k) {
      const double time_s =
          k == least_steps ? end_s : start_s + (end_s - start_s) * k / least_steps;
      const Node to{time_s, law(time_s, Side::before)};
      add_until(law, from, to);
      from = to;
    }
  }
  prepare_guide();
}

/// Adds a node with the sign that is nearest to the one before. Of two at one moment both stay
/// where the law jumps.
void AttitudeTable::add(Node node) {
  if (!times_s_.empty()) {
    const Quaternion before = orientations_.back();
    if (dot(before, node.orientation) < 0.0) node.orientation = -node.orientation;
    const bool same_moment = times_s_.back() == node.time_s;
    // A tenth of the tolerance: what smooth tracks jump by, and rounding, needs no second node.
    if (same_moment && angle_between(before, node.orientation) < 0.1 * tolerance_rad) return;
  }
  if (times_s_.size() >= most_nodes) {
    throw InputError{"the platform turns too restlessly: by " + number_text(node.time_s) + " s " +
                     std::to_string(most_nodes) + " attitudes are not enough"};
  }
  times_s_.push_back(node.time_s);
  orientations_.push_back(node.orientation);
}

/// Adds nodes up to `to`; those up to `from` are there. From left to right, so that recursion is no
/// deeper than the number of halvings.
void AttitudeTable::add_until(const Law& law, const Node& from, const Node& to) {
  const double step_s = to.time_s - from.time_s;
  const Node middle{from.time_s + 0.5 * step_s, law(from.time_s + 0.5 * step_s, Side::after)};
  const bool flip = dot(from.orientation, to.orientation) < 0.0;
  const Quaternion end = flip ? -to.orientation : to.orientation;
  const auto agrees = [&](double share, const Quaternion& exact) {
    return angle_between(slerp(from.orientation, end, share), exact) < tolerance_rad;
  };
  // Uneven places: what repeats itself in the step cannot agree with all of them.
  const auto exact = [&](double share) { return law(from.time_s + share * step_s, Side::after); };
  if (step_s <= shortest_step_s ||
      (agrees(0.5, middle.orientation) && agrees(0.21, exact(0.21)) && agrees(0.83, exact(0.83)))) {
    add(to);
    return;
  }
  add_until(law, from, middle);
  add_until(law, middle, to);
}

void AttitudeTable::prepare_guide() {
  if (times_s_.size() < 2) return;
  const std::size_t parts = times_s_.size();
  parts_per_s_ = static_cast<double>(parts) / (times_s_.back() - times_s_.front());
  std::uint32_t node = 0;
  for (std::size_t part = 0; part <= parts; ++part) {
    const double time_s = times_s_.front() + static_cast<double>(part) / parts_per_s_;
    while (node + 2 < times_s_.size() && times_s_[node + 1] <= time_s) ++node;
    guide_.push_back(node);
  }
}

Quaternion AttitudeTable::at(double time_s) const noexcept {
  if (guide_.empty()) return orientations_.front();
  const double parts = (time_s - times_s_.front()) * parts_per_s_;
  const std::size_t part =
      parts > 0.0 ? std::min(guide_.size() - 2, static_cast<std::size_t>(parts)) : 0;
  // A moment that rounding puts into the next part is a rounding away from that part's nodes.
  std::size_t low = guide_[part], high = std::size_t{guide_[part + 1]} + 1;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (times_s_[middle] <= time_s ? low : high) = middle;
  }
  const double share = (time_s - times_s_[low]) / (times_s_[low + 1] - times_s_[low]);
  return slerp(orientations_[low], orientations_[low + 1], share);
}

}  // namespace nadir::sensor
