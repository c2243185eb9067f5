#pragma once

#include <array>
#include <optional>

#include "thermal/conduction/depth_grid.hpp"

namespace nadir::thermal {

/// What holds a column's back.
struct BackCoupling {
  double film_w_m2_k = 0.0;        ///< to a room; 0: nothing passes
  std::optional<double> pinned_k;  ///< the deepest node's temperature, given
};

/// Scratch of one stage, in pairs.
using NodeValues = std::array<double, most_nodes + 2>;

/// An implicit stage of length s: C_i (U_i - B_i) / s = heat that comes from the neighbours, from
/// within, from the back and, at node 0, from the surface, all at the new temperatures U.
///
/// The matrix is eliminated from the back upwards, once. What remains is for every node
///
///     U_i = keep_i B_i + given_i + below_i U_(i+1) + above_i U_(i-1)
///
/// with `below` used on the way up and `above` on the way down. All factors are positive and
/// their sum is 1 (but for heat released), so that U lies between what it is made of: the maximum
/// principle, to the last digit. Pivots are sums of positive terms, nothing cancels.
///
/// Either sweep goes two nodes at a time: the recurrence with itself inserted, which halves the
/// chain of operations that wait for each other.
class Elimination {
 public:
  Elimination(const DepthGrid& grid, const BackCoupling& back, Seconds stage);

  /// Both sweeps for a surface at 0 K.
  /// @param before   temperatures B, one a node
  /// @param back_k   of the room
  /// @param partial  result: U less what the surface's temperature adds
  /// @return         the surface's temperature if no flux came through it
  double prepare(const double* before, double back_k, NodeValues& partial) const noexcept;
  /// Adds what the surface's temperature adds: U.
  void finish(const NodeValues& partial, double surface_k, NodeValues& after) const noexcept;

  /// W m^-2 through the surface for each K above the temperature that prepare() returns.
  [[nodiscard]] double surface_conductance() const noexcept { return surface_conductance_; }

 private:
  /// Products of factors: over two nodes, and all the way down from the surface.
  void chain() noexcept;
  void descend(const NodeValues& up, NodeValues& partial) const noexcept;

  std::size_t nodes_;
  double surface_conductance_ = 0.0;
  double room_share_ = 0.0;  // of the deepest node's temperature that is the room's
  NodeValues keep_{}, given_{};
  NodeValues below_{}, below_two_{};  // of node i + 1, and of i + 2 by way of it
  NodeValues above_{}, above_two_{};
  NodeValues surface_{};  // of node 0 by way of all between
};

}  // namespace nadir::thermal
