#pragma once

#include <optional>

#include "geometry/region.hpp"
#include "materials/volume/bound_phase.hpp"
#include "radiometry/planck_table.hpp"
#include "radiometry/volumes/grid_field.hpp"
#include "radiometry/volumes/volume.hpp"
#include "spectral/lanes.hpp"

namespace nadir::radiometry {

/// One volume at the lanes. Coefficients are those at density 1.
struct BoundVolume {
  /// @throws InputError located at the volume; see BoundVolumes
  BoundVolume(const Volume& volume, const spectral::Lanes& lanes);

  geometry::Region region;
  materials::BoundPhase phase;
  spectral::Spectrum scattering;  ///< 1/m
  spectral::Spectrum absorption;  ///< 1/m
  spectral::Spectrum extinction;  ///< 1/m
  spectral::Spectrum emission;    ///< absorption x Planck where the temperature is constant, else 0
  float max_extinction = 0.0F;
  bool scatters = false;
  std::optional<GridField> density;
  std::optional<GridField> temperature;
  std::optional<PlanckTable> planck;  ///< with a temperature grid of something that absorbs

  [[nodiscard]] const GridField* blocks() const noexcept { return density ? &*density : nullptr; }
  [[nodiscard]] bool is_empty() const noexcept {
    return max_extinction <= 0.0F || (density && density->range().hi <= 0.0F);
  }
  [[nodiscard]] float density_at(Vec3 unit) const noexcept {
    return density ? density->at(unit) : 1.0F;
  }
};

}  // namespace nadir::radiometry
