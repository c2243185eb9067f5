#pragma once

#include <numbers>

#include "core/vec.hpp"

namespace nadir::radiometry {

/// The hemisphere above a surface, cut into quads of equal solid angle: equal steps in the cosine
/// of the zenith angle mu and in azimuth, since dOmega = dmu dphi.
///
/// Quads 0 .. count() - 1 are those around +z. The next count() of them are their mirror images
/// around -z, for surfaces that transmit: quad + count() is quad with z turned round.
class QuadHemisphere {
 public:
  QuadHemisphere(int mu_samples, int phi_samples) noexcept
      : mu_samples_{mu_samples}, phi_samples_{phi_samples} {}

  [[nodiscard]] int mu_samples() const noexcept { return mu_samples_; }
  [[nodiscard]] int phi_samples() const noexcept { return phi_samples_; }
  /// Of one hemisphere.
  [[nodiscard]] int count() const noexcept { return mu_samples_ * phi_samples_; }
  [[nodiscard]] int count_of_both_sides() const noexcept { return 2 * count(); }
  [[nodiscard]] bool is_below(int quad) const noexcept { return quad >= count(); }
  /// Of each quad, in sr.
  [[nodiscard]] double solid_angle() const noexcept {
    return 2.0 * std::numbers::pi / static_cast<double>(count());
  }
  /// Direction in a quad of either side, local frame (z along the normal); u in [0, 1)^2 covers its
  /// solid angle uniformly.
  [[nodiscard]] Vec3 direction(int quad, Vec2 u) const noexcept;
  [[nodiscard]] Vec3 centre(int quad) const noexcept { return direction(quad, {0.5, 0.5}); }

  /// A quad and the place in it, in [0, 1)^2: what `direction` takes.
  struct Place {
    int quad = 0;
    Vec2 u;
  };
  /// Where a unit vector of the local frame lies: the inverse of `direction`. One in the surface
  /// itself counts as above it.
  [[nodiscard]] Place place(Vec3 direction) const noexcept;

 private:
  int mu_samples_;
  int phi_samples_;
};

}  // namespace nadir::radiometry
