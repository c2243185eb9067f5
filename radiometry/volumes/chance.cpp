#include "radiometry/volumes/chance.hpp"

#include <algorithm>
#include <cmath>

#include "radiometry/volumes/passage.hpp"

namespace nadir::radiometry {

Encounter encounter(const Step& step, double distance, int lanes) noexcept {
  Encounter met{spectral::Spectrum{lanes}, spectral::Spectrum{lanes}, {}};
  for (int i = 0; i < step.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const ActiveVolume& active = step.active[k];
    const BoundVolume& volume = *active.volume;
    const bool glows = volume.planck.has_value();
    if (active.span <= 0.0F && !glows) continue;
    const Vec3 place = active.own_axes(distance);
    const float density = volume.density_at(place);
    const float above = std::clamp(density - active.lo, 0.0F, active.span);
    met.density[k] = above;
    met.extinction.add_scaled(volume.extinction, above);
    met.emission.add_scaled(volume.emission, above);
    if (!glows) continue;
    auto radiance = volume.planck->at(static_cast<double>(volume.temperature->at(place)));
    radiance *= volume.absorption;
    met.emission.add_scaled(radiance, density);
  }
  return met;
}

ScattererChoice choose_scatterer(const Step& step, const Encounter& met,
                                 const spectral::Spectrum& weight, double u) noexcept {
  std::array<double, most_overlapping> chance{};
  ScattererChoice choice;
  for (int i = 0; i < step.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const BoundVolume& volume = *step.active[k].volume;
    if (met.density[k] <= 0.0F || !volume.scatters) continue;
    chance[k] = static_cast<double>(met.density[k]) * total(weight * volume.scattering);
    choice.total += chance[k];
  }
  double left = u * choice.total;
  for (int i = 0; i < step.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (chance[k] <= 0.0) continue;
    choice.volume = step.active[k].volume;
    choice.density = static_cast<double>(met.density[k]);
    choice.sum = chance[k];
    if (left < chance[k]) break;
    left -= chance[k];
  }
  return choice;
}

double exponential(double u) noexcept { return -std::log1p(-u); }

bool survives(spectral::Spectrum& weight, double mean_at_start, Draws& draws) noexcept {
  constexpr double small = 1e-3;
  constexpr double chance = 0.1;
  const double mean = static_cast<double>(weight.mean());
  if (mean >= small * mean_at_start) return mean > 0.0;
  const bool lives = draws.next().x < chance;
  weight *= lives ? static_cast<float>(1.0 / chance) : 0.0F;
  return lives && mean > 0.0;
}

}  // namespace nadir::radiometry
