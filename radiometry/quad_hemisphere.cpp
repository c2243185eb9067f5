#include "radiometry/quad_hemisphere.hpp"

#include <algorithm>
#include <cmath>

namespace nadir::radiometry {

namespace {

/// Largest double below 1.
constexpr double below_one = 1.0 - 0x1p-53;

struct Step {
  int index;
  double rest;  ///< in [0, 1)
};

/// A coordinate in [0, count] as a step and the place in it; rounding never leaves the range.
Step step_of(double coordinate, int count) noexcept {
  const int index = std::clamp(static_cast<int>(coordinate), 0, count - 1);
  return {index, std::clamp(coordinate - index, 0.0, below_one)};
}

}  // namespace

Vec3 QuadHemisphere::direction(int quad, Vec2 u) const noexcept {
  const int above = is_below(quad) ? quad - count() : quad;
  const int ring = above / phi_samples_, sector = above % phi_samples_;
  // 1 - u turns [0, 1) into (0, 1], so that no direction lies in the surface itself.
  const double mu = (ring + (1.0 - u.x)) / mu_samples_;
  const double phi = 2.0 * std::numbers::pi * (sector + u.y) / phi_samples_;
  const double sine = std::sqrt(std::max(0.0, 1.0 - mu * mu));
  return {sine * std::cos(phi), sine * std::sin(phi), is_below(quad) ? -mu : mu};
}

QuadHemisphere::Place QuadHemisphere::place(Vec3 direction) const noexcept {
  // Rings are open below and closed above, as mu = (ring + 1 - u.x) / mu_samples is.
  const Step from_top = step_of(mu_samples_ * (1.0 - std::fabs(direction.z)), mu_samples_);
  const double turn = std::atan2(direction.y, direction.x) / (2.0 * std::numbers::pi);
  const Step sector = step_of(phi_samples_ * (turn < 0.0 ? turn + 1.0 : turn), phi_samples_);
  const int above = (mu_samples_ - 1 - from_top.index) * phi_samples_ + sector.index;
  return {direction.z < 0.0 ? above + count() : above, {from_top.rest, sector.rest}};
}

}  // namespace nadir::radiometry
