#pragma once

#include "core/vec.hpp"
#include "geometry/region.hpp"
#include "radiometry/volumes/walk.hpp"
#include "spectral/lanes.hpp"

namespace nadir::radiometry {

/// What a length d of constant extinction sigma does, per lane.
struct Passage {
  spectral::Spectrum transmittance;  ///< exp(-sigma d)
  spectral::Spectrum path;           ///< (1 - exp(-sigma d)) / sigma, m: d where sigma is 0
};
/// Exact to float's rounding for any optical depth, 1e-8 as well as 1e3.
[[nodiscard]] Passage passage(const spectral::Spectrum& extinction, double length) noexcept;

/// Light that is scattered at a place: which volume does it, and how much of what comes from each
/// lane is scattered towards the ray's origin, over the place's density.
struct Scattered {
  double distance = 0.0;  ///< from the ray's origin, m
  const BoundVolume* volume = nullptr;
  spectral::Spectrum weight;
};

/// Draws a place in the constant part of a step, from the mean of the lanes' densities
/// weight x scattering x exp(-extinction t); balance heuristic over lanes, so that the mean of the
/// result's weights is always that of `share`.
/// @param part    of the step that counts
/// @param weight  of light where the part begins
/// @param share   weight x scattering x passage's path, of mean above 0
[[nodiscard]] Scattered place_in_constant(const Step& step, const geometry::Interval& part,
                                          const spectral::Spectrum& weight,
                                          const spectral::Spectrum& share, Vec2 u) noexcept;

/// Multiplies in double: a factor beyond float's range leaves a lane of 0 at 0.
void scale_by(spectral::Spectrum& weight, double factor) noexcept;

/// Sum over lanes, in double; four sums side by side, since each addition waits for the one before.
[[nodiscard]] inline double total(const spectral::Spectrum& s) noexcept {
  double sums[4] = {0.0, 0.0, 0.0, 0.0};
  const int whole = s.count() & ~3;
  for (int lane = 0; lane < whole; lane += 4) {
    for (int i = 0; i < 4; ++i) sums[i] += static_cast<double>(s[lane + i]);
  }
  for (int lane = whole; lane < s.count(); ++lane) sums[0] += static_cast<double>(s[lane]);
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace nadir::radiometry
