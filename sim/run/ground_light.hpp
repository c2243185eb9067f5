#pragma once

#include <optional>
#include <vector>

#include "atmosphere/table/air_table.hpp"
#include "core/diagnostics.hpp"
#include "radiometry/lit_scene.hpp"
#include "spectral/curve.hpp"

namespace nadir::sim {

/// What the user says of the ground about the scene.
struct GroundAbout {
  std::optional<spectral::Curve> reflectance;
  std::optional<Kelvin> temperature;
};

/// The ground about a scene: what is said of it, and for the rest the mean of what the scene shows
/// from straight above, on a grid of 32 x 32 places over its bounds that hit something. Of a
/// surface counts its directional-hemispherical reflectance at 45 degrees, what it emits there, and
/// where a reflectance is given but no temperature, its black body's radiance times 1 -
/// reflectance. A scene without any surface: black and cold, with a warning.
/// @param wavelengths  ascending, one a lane; several may be alike
/// @throws InputError where a spectrum does not cover them
[[nodiscard]] atmosphere::GroundLight ground_light(const radiometry::SceneDescription& scene,
                                                   const GroundAbout& about,
                                                   const std::vector<Micrometres>& wavelengths,
                                                   Diagnostics& diagnostics);

}  // namespace nadir::sim
