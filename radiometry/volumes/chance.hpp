#pragma once

#include <array>
#include <cstddef>

#include "radiometry/volumes/draws.hpp"
#include "radiometry/volumes/walk.hpp"
#include "spectral/lanes.hpp"

// What is met by chance: the part of grids that is above the constant part of a step.

namespace nadir::radiometry {

/// What a step holds at one place above its constant part.
struct Encounter {
  spectral::Spectrum extinction;                  ///< 1/m
  spectral::Spectrum emission;                    ///< W m^-3 sr^-1 um^-1
  std::array<float, most_overlapping> density{};  ///< of each active volume
};
[[nodiscard]] Encounter encounter(const Step& step, double distance, int lanes) noexcept;

/// A scattering volume of the step, drawn in proportion to the mean over lanes of
/// weight x density x scattering.
struct ScattererChoice {
  const BoundVolume* volume = nullptr;
  double density = 0.0;
  double sum = 0.0;    ///< over lanes, of the volume drawn
  double total = 0.0;  ///< over lanes and volumes
};
[[nodiscard]] ScattererChoice choose_scatterer(const Step& step, const Encounter& met,
                                               const spectral::Spectrum& weight, double u) noexcept;

/// Optical distance to the next chance, of a Poisson process.
[[nodiscard]] double exponential(double u) noexcept;

/// Russian roulette for a weight whose mean has fallen to 1e-3 of what it was: nine of ten end, the
/// tenth counts tenfold. Returns whether anything is left.
[[nodiscard]] bool survives(spectral::Spectrum& weight, double mean_at_start,
                            Draws& draws) noexcept;

/// The rate of chances per metre: enough for all that may be met, and, so that thin grids are seen
/// at all, `least` on average over a crossing.
[[nodiscard]] inline double rate_of(const Step& step, double least) noexcept {
  const double wanted = least * step.chances;
  return step.majorant > wanted ? step.majorant : wanted;
}

}  // namespace nadir::radiometry
