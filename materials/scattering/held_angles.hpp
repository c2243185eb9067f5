#pragma once

#include <algorithm>
#include <cmath>

#include "core/vec.hpp"

namespace nadir::materials {

/// Zenith angle beyond which models that were fitted to measurements keep their value: 80 degrees.
/// Few instruments see further, the models' own papers stop there, and past it their formulae
/// diverge. Held on both sides alike, a reciprocal model stays so.
inline constexpr double held_zenith_cosine = 0.17364817766693033;

/// Both directions of a reflection, their zenith angles at most 80 degrees.
struct HeldAngles {
  double mu_i = 1.0, mu_o = 1.0;    ///< cosines of the zenith angles
  double sin_i = 0.0, sin_o = 0.0;  ///< their sines
  double cos_phi = 1.0;             ///< of the azimuth between them; 1: back scatter

  /// @param least_cosine  directions nearer to the horizon are raised to it
  HeldAngles(Vec3 wi, Vec3 wo, double least_cosine = held_zenith_cosine) noexcept
      : mu_i{std::max(std::abs(wi.z), least_cosine)}, mu_o{std::max(std::abs(wo.z), least_cosine)} {
    const double across_i = std::sqrt(wi.x * wi.x + wi.y * wi.y),
                 across_o = std::sqrt(wo.x * wo.x + wo.y * wo.y);
    sin_i = mu_i > std::abs(wi.z) ? std::sqrt((1.0 - mu_i) * (1.0 + mu_i)) : across_i;
    sin_o = mu_o > std::abs(wo.z) ? std::sqrt((1.0 - mu_o) * (1.0 + mu_o)) : across_o;
    const double both = across_i * across_o;
    if (both > 0.0) cos_phi = std::clamp((wi.x * wo.x + wi.y * wo.y) / both, -1.0, 1.0);
  }

  /// Cosine of the phase angle between the directions.
  [[nodiscard]] double cos_phase() const noexcept {
    return std::clamp(mu_i * mu_o + sin_i * sin_o * cos_phi, -1.0, 1.0);
  }
  /// sqrt(tan_i^2 + tan_o^2 - 2 tan_i tan_o cos_phi): how far the two shadows of a point lie apart,
  /// in units of its height. Written so that it vanishes exactly at the hot spot.
  [[nodiscard]] double shadow_distance() const noexcept {
    const double tan_i = sin_i / mu_i, tan_o = sin_o / mu_o, apart = tan_i - tan_o;
    return std::sqrt(apart * apart + 2.0 * tan_i * tan_o * (1.0 - cos_phi));
  }
};

}  // namespace nadir::materials
