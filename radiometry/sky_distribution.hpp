#pragma once

#include <vector>

#include "atmosphere/atmosphere.hpp"
#include "core/vec.hpp"

namespace nadir::radiometry {

/// Where the sky is bright: a piecewise constant density over directions in proportion to the
/// lane-averaged radiance, from which rays towards the sky are drawn. Empty for a sky that is even
/// or dark: the scattering function then samples it best.
class SkyDistribution {
 public:
  SkyDistribution() = default;
  explicit SkyDistribution(const atmosphere::BoundAtmosphere& air);

  [[nodiscard]] bool empty() const noexcept { return cumulative_.empty(); }
  /// Share of the directions that are best drawn from here, the rest from the surface: 0 for an
  /// even sky, half for one with a bright spot. With c the brightest cell over the mean, (c - 1)/(c
  /// + 3).
  [[nodiscard]] double share() const noexcept { return share_; }
  [[nodiscard]] Vec3 sample(Vec2 u) const noexcept;
  [[nodiscard]] double pdf(Vec3 direction) const noexcept;  ///< sr^-1; 1 / 4 pi on average

 private:
  double share_ = 0.0;
  std::vector<double> cumulative_;  // running sums over cells of equal solid angle, the last is 1
};

}  // namespace nadir::radiometry
