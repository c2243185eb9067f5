#include "atmosphere/make/direction_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nadir::atmosphere {

DirectionGrid::DirectionGrid(int streams) {
  // An even number of steps, so that the horizon is a node; 24 steps: 1e-4 at 8 streams.
  const int steps = std::clamp(2 * ((3 * streams) / 2), 24, 48);
  for (int i = 0; i <= steps; ++i) {
    mu_.push_back(-std::cos(std::numbers::pi * i / steps));
  }
  mu_[static_cast<std::size_t>(steps / 2)] = 0.0;
}

MuWeights DirectionGrid::at(double mu) const noexcept {
  const int steps = static_cast<int>(mu_.size()) - 1;
  const double place = std::acos(std::clamp(-mu, -1.0, 1.0)) / std::numbers::pi * steps;
  const int first = std::clamp(static_cast<int>(place) - 1, 0, steps - 3);
  const double t = place - first;  // nodes at 0, 1, 2, 3
  return {static_cast<std::size_t>(first),
          {-(t - 1.0) * (t - 2.0) * (t - 3.0) / 6.0, t * (t - 2.0) * (t - 3.0) / 2.0,
           -t * (t - 1.0) * (t - 3.0) / 2.0, t * (t - 1.0) * (t - 2.0) / 6.0}};
}

}  // namespace nadir::atmosphere
