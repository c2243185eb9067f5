#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/earth.hpp"
#include "sensor/camera/timing.hpp"
#include "sensor/platform/track.hpp"
#include "sim/run/input_files.hpp"
#include "sim/run/terrain_probe.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// What every part of a platform is loaded from.
struct PlatformTask {
  const Scenario& scenario;
  const geometry::LocalFrame& frame;
  const TerrainProbe& terrain;
  InputFiles& files;
  sensor::TimeSpan span;

  [[nodiscard]] const PlatformInput& input() const noexcept { return scenario.platform; }
};

/// A place in scene axes.
[[nodiscard]] Vec3 load_place(const PlaceInput& place, const PlatformTask& task);

/// Where the platform is in time, over the task's span at least.
/// @throws InputError at the element or in the file
[[nodiscard]] sensor::Track load_track(const PlatformTask& task);

/// Whether a table of that span leaves a moment of the task's open.
[[nodiscard]] bool leaves_open(const sensor::TimeSpan& covered, const PlatformTask& task) noexcept;
/// `the camera looks from 0 s to 3 s after the scenario's time, but a.csv covers 0 s to 2 s`.
[[nodiscard]] std::string open_message(const std::string& file, const sensor::TimeSpan& covered,
                                       const PlatformTask& task);

/// The longest step between two rows that a table may have: what the user says, or five times its
/// median step; nothing where it has fewer than eight rows, from which a usual step is not told.
[[nodiscard]] std::optional<double> longest_step_s(const std::vector<double>& times_s,
                                                   std::optional<double> max_gap_s);

/// A step of a table between rows.
struct TableStep {
  double begin_s = 0.0, end_s = 0.0;

  [[nodiscard]] double length_s() const noexcept { return end_s - begin_s; }
};
/// The first step longer than that, of those that values within the span come from.
/// @param points  that a value between two rows is interpolated from, half of them on either side
[[nodiscard]] std::optional<TableStep> gap_of(const std::vector<double>& times_s, int points,
                                              double longest_s, const sensor::TimeSpan& span);

}  // namespace nadir::sim
