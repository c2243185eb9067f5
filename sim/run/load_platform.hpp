#pragma once

#include "geometry/earth.hpp"
#include "sensor/camera/timing.hpp"
#include "sensor/platform/platform.hpp"
#include "sim/run/input_files.hpp"
#include "sim/run/terrain_probe.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// What the scenario says of its platform, files read and orbits computed.
/// @param terrain  where heights that count from the terrain come from; may be empty
/// @param span     the moments at which the camera looks, s after the scenario's time
/// @throws InputError, at the element or in the file that is wrong: a time outside the way, gaps of
///         the attitude, orbits that cannot be computed
[[nodiscard]] sensor::PlatformDescription describe_platform(const Scenario& scenario,
                                                            const geometry::LocalFrame& frame,
                                                            const TerrainProbe& terrain,
                                                            InputFiles& files,
                                                            sensor::TimeSpan span);

/// The same, ready to be asked for poses within the span.
/// @throws InputError as `describe_platform`, and for a camera under the terrain at any of the
/// moments
///         of its way within the span, or of some 1000 even ones
[[nodiscard]] sensor::Platform load_platform(const Scenario& scenario,
                                             const geometry::LocalFrame& frame,
                                             const TerrainProbe& terrain, InputFiles& files,
                                             sensor::TimeSpan span);

}  // namespace nadir::sim
