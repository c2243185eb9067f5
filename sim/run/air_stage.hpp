#pragma once

#include <span>
#include <string>
#include <vector>

#include "atmosphere/air_parts.hpp"
#include "radiometry/effect.hpp"
#include "sim/plan/camera_plan.hpp"
#include "sim/products/report.hpp"
#include "sim/run/air_cache.hpp"
#include "sim/run/world.hpp"

namespace nadir::sim {

/// Finishes the scene's air: air in layers is solved for all lanes of all arrays at once (or its
/// table taken from the cache), a table from elsewhere gets the ground about. Nothing is done for
/// other air.
///
/// What an array leaves out is not solved for at its wavelengths, unless another array that has the
/// same ones asks for it. Where no array asks for anything of the air, nor for light of sun or
/// moon, which comes through it, the scene is left without air.
/// @param effects  by array; empty: all of them
/// @return what the report tells of it; empty where nothing was done
/// @throws InputError located at the air's element
ReportValues finish_air(World& world, const SamplingInput& sampling, Diagnostics& diagnostics,
                        const AirCacheOptions& cache = {},
                        std::span<const radiometry::EffectSet> effects = {});

/// The bending of the camera's rays, where the scenario asks for it and it shifts what some array
/// sees by a tenth of a pixel or more, or where the scenario says that refraction is on; otherwise
/// rays are straight, and nothing is spent on it. One wavelength stands for all: the mean of the
/// camera's.
/// @param report  told of the shift
[[nodiscard]] std::optional<RayBending> camera_bending(const World& world, ReportValues& report);

/// Everything that the table of air in layers depends on, as text: the cache's key. Numbers are
/// written so that they read back to the last bit.
/// @param nodes    the lanes follow from them
/// @param figures  digest of the files of gases and particles
/// @param wanted   by node, what is solved for; empty: everything
[[nodiscard]] std::string air_key(const atmosphere::Layered& air,
                                  const atmosphere::AirSettings& settings, const AirLanes& nodes,
                                  const ephemeris::Illumination& bodies, const std::string& figures,
                                  std::span<const atmosphere::AirParts> wanted = {});

/// What the arrays want of the air at each of the camera's nodes (air_nodes).
/// @param effects  by array; empty: all of them
[[nodiscard]] std::vector<atmosphere::AirParts> wanted_of_air(
    const std::vector<sensor::DetectorArray>& arrays, const BandNodes& per_band,
    std::span<const radiometry::EffectSet> effects);

}  // namespace nadir::sim
