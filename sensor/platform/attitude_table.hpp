#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/quaternion.hpp"

namespace nadir::sensor {

/// An orientation that depends on time, tabulated so finely that turning evenly between the steps
/// is near enough to it, and found in a few steps whatever their spacing.
class AttitudeTable {
 public:
  /// At moments where pieces of a law meet it may jump.
  enum class Side { after, before };
  using Law = std::function<Quaternion(double time_s, Side side)>;

  /// No table holds more, 50 MB.
  static constexpr std::size_t most_nodes = 1'000'000;
  /// Halving ends here: a law that turns by more in a microsecond jumps.
  static constexpr double shortest_step_s = 1e-6;
  /// Between two nodes the law is looked at in three places; half of the 1e-9 rad that a platform
  /// promises, for what lies between.
  static constexpr double tolerance_rad = 5e-10;

  AttitudeTable() = default;
  /// @param borders_s  ascending, from the first moment to the last: where pieces meet. One alone:
  ///                   the orientation at that moment, for all
  /// @throws InputError where most_nodes are not enough; whatever the law throws
  AttitudeTable(const Law& law, const std::vector<double>& borders_s);

  /// @param time_s  within the borders
  [[nodiscard]] Quaternion at(double time_s) const noexcept;
  [[nodiscard]] bool empty() const noexcept { return times_s_.empty(); }
  [[nodiscard]] std::size_t size() const noexcept { return times_s_.size(); }

 private:
  struct Node {
    double time_s;
    Quaternion orientation;
  };
  void add(Node node);
  void add_until(const Law& law, const Node& from, const Node& to);
  void prepare_guide();

  std::vector<double> times_s_;
  std::vector<Quaternion> orientations_;
  // The span in equal parts: the last node not after each part's beginning.
  std::vector<std::uint32_t> guide_;
  double parts_per_s_ = 0.0;
};

}  // namespace nadir::sensor
