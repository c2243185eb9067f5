#include "thermal/conduction/elimination.hpp"

#include <cstring>
#include <limits>

namespace nadir::thermal {
namespace {

/// Two nodes at a time, moved as wholes: what is stored by halves and loaded as a whole waits.
using Pair [[gnu::vector_size(16)]] = double;

Pair load(const double* from) {
  Pair pair;
  std::memcpy(&pair, from, sizeof pair);
  return pair;
}
void store(Pair pair, double* to) { std::memcpy(to, &pair, sizeof pair); }

/// Denormal numbers would be slow and are nothing beside 1 K.
double or_nothing(double factor) {
  return factor < std::numeric_limits<double>::min() ? 0.0 : factor;
}

}  // namespace

Elimination::Elimination(const DepthGrid& grid, const BackCoupling& back, Seconds stage)
    : nodes_(grid.nodes()) {
  const std::size_t last = nodes_ - 1;
  std::size_t i = nodes_;
  double beneath = back.film_w_m2_k;  // conductance from node i to all that is deeper
  if (back.pinned_k) {
    given_[last] = *back.pinned_k;
    i = last;
    beneath = grid.conductance_w_m2_k[last - 1];
  }
  while (i-- > 0) {
    const double inertia = grid.capacity_j_m2_k[i] / stage.value;
    const double to_below = i < last ? grid.conductance_w_m2_k[i] : 0.0;
    const double to_above = i > 0 ? grid.conductance_w_m2_k[i - 1] : 0.0;
    const double down = inertia + beneath;
    const double pivot = down + to_above;
    keep_[i] = inertia / pivot;
    given_[i] = grid.heat_w_m2[i] / pivot;
    below_[i] = to_below / pivot;
    above_[i] = or_nothing(to_above / pivot);
    if (i == last) room_share_ = back.film_w_m2_k / pivot;
    beneath = to_above * (down / pivot);  // in series: the node gives way
    surface_conductance_ = pivot;         // in the end that of node 0
  }
  chain();
}

void Elimination::chain() noexcept {
  surface_[0] = 1.0;
  below_two_[0] = or_nothing(below_[0] * below_[1]);
  for (std::size_t i = 1; i < nodes_; ++i) {
    below_two_[i] = or_nothing(below_[i] * below_[i + 1]);
    above_two_[i] = or_nothing(above_[i] * above_[i - 1]);
    surface_[i] = or_nothing(above_[i] * surface_[i - 1]);
  }
}

double Elimination::prepare(const double* before, double back_k,
                            NodeValues& partial) const noexcept {
  NodeValues up;
  const double room = room_share_ * back_k;
  const std::size_t pairs = nodes_ / 2;
  double own_below = 0.0;  // of the node below the pair: all but what comes from deeper
  Pair sum{0.0, 0.0};      // of the pair below
  if (nodes_ % 2 != 0) {
    const std::size_t last = nodes_ - 1;
    own_below = keep_[last] * before[last] + given_[last] + room;
    sum = Pair{own_below, 0.0};
    store(sum, &up[last]);
  }
  Pair extra = nodes_ % 2 != 0 ? Pair{0.0, 0.0} : Pair{0.0, room};
  for (std::size_t i = 2 * pairs; i > 0;) {
    i -= 2;
    const Pair own = load(&keep_[i]) * load(before + i) + load(&given_[i]) + extra;
    const Pair next{own[1], own_below};
    sum = (own + load(&below_[i]) * next) + load(&below_two_[i]) * sum;
    store(sum, &up[i]);
    own_below = own[0];
    extra = Pair{0.0, 0.0};
  }
  descend(up, partial);
  return sum[0];
}

void Elimination::descend(const NodeValues& up, NodeValues& partial) const noexcept {
  Pair above{0.0, 0.0};
  Pair sum{0.0, up[1]};  // the surface's own is left out; of a single node up[1] is 0
  store(sum, partial.data());
  above[1] = up[1];
  for (std::size_t i = 2; i < nodes_; i += 2) {
    const Pair own = load(&up[i]);
    const Pair next{above[1], own[0]};
    sum = (own + load(&above_[i]) * next) + load(&above_two_[i]) * sum;
    store(sum, &partial[i]);
    above = own;
  }
}

void Elimination::finish(const NodeValues& partial, double surface_k,
                         NodeValues& after) const noexcept {
  const Pair surface{surface_k, surface_k};
  for (std::size_t i = 0; i < nodes_; i += 2) {
    store(load(&partial[i]) + load(&surface_[i]) * surface, &after[i]);
  }
}

}  // namespace nadir::thermal
