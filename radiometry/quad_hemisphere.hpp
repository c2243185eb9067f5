#pragma once

#include <numbers>

#include "core/vec.hpp"

namespace nadir::radiometry {

/// The hemisphere above a surface, cut into quads of equal solid angle: equal steps in the cosine
/// of the zenith angle mu and in azimuth, since dOmega = dmu dphi.
class QuadHemisphere {
 public:
  QuadHemisphere(int mu_samples, int phi_samples) noexcept
      : mu_samples_{mu_samples}, phi_samples_{phi_samples} {}

  [[nodiscard]] int count() const noexcept { return mu_samples_ * phi_samples_; }
  /// Of each quad, in sr.
  [[nodiscard]] double solid_angle() const noexcept {
    return 2.0 * std::numbers::pi / static_cast<double>(count());
  }
  /// Direction in a quad, local frame (z along the normal); u in [0, 1)^2 covers its solid angle
  /// uniformly.
  [[nodiscard]] Vec3 direction(int quad, Vec2 u) const noexcept;
  [[nodiscard]] Vec3 centre(int quad) const noexcept { return direction(quad, {0.5, 0.5}); }

 private:
  int mu_samples_;
  int phi_samples_;
};

}  // namespace nadir::radiometry
