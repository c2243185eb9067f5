#pragma once

#include "sim/run/load_air.hpp"
#include "sim/run/load_geometry.hpp"
#include "sim/run/render.hpp"

namespace nadir::sim {

/// Height above sea level of a place in scene axes over a round earth, as tables of the air count.
[[nodiscard]] double height_above_sea_m(Vec3 place, double ground_m) noexcept;

/// Sets what the air's table needs to know of the camera, and checks that air, scene and camera go
/// together: a camera above the ground, a table that was made for this place and these bodies.
/// Tells of a camera at a height that the table was not made for.
/// Where the air refracts, sun and moon of the ephemeris are moved to where they are seen.
/// @throws InputError located at the element that is wrong
void fit_air(const Scenario& scenario, const LoadedGeometry& geometry,
             const atmosphere::Atmosphere& air, ephemeris::Illumination& bodies,
             const Camera& camera, AirTask& task, Diagnostics& diagnostics);

/// Checks that the spectra of the air reach the lanes.
/// @throws InputError located at the air's element
void check_air_spectra(const AirTask& task, const spectral::Lanes& lanes);

}  // namespace nadir::sim
