#pragma once

#include <optional>

#include "radiometry/lit_scene.hpp"

namespace nadir::radiometry {

/// Parts of the radiance at the aperture that need no sampling; the rest was reflected (or let
/// through) by the surface. W m^-2 sr^-1 um^-1 per lane.
struct EffectShares {
  spectral::Spectrum path;      ///< added by the air; all of it where the ray meets no surface
  spectral::Spectrum emission;  ///< by the surface, through the air
};

/// @param hit  what the ray meets first, its material resolved. Volumes on the way are passed over.
[[nodiscard]] EffectShares effect_shares(const LitScene& scene, const geometry::Ray& ray,
                                         const std::optional<geometry::Hit>& hit);

}  // namespace nadir::radiometry
