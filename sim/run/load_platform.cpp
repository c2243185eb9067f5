#include "sim/run/load_platform.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "sim/files/jitter_file.hpp"
#include "sim/run/load_air.hpp"
#include "sim/run/load_attitude.hpp"
#include "sim/run/load_track.hpp"

namespace nadir::sim {
namespace {

constexpr double rad_per_urad = 1e-6;

sensor::JitterDescription load_jitter(const PlatformTask& task) {
  sensor::JitterDescription description;
  if (!task.input().jitter) return description;
  const JitterInput& input = *task.input().jitter;
  description.white_rms_rad = input.white_urad * rad_per_urad;
  description.seed = input.seed;
  if (!input.spectrum) return description;
  const JitterFile file = read_jitter_file(task.files.note(*input.spectrum));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (file.density_rad2_hz[axis].empty()) continue;
    description.spectra[axis] = {file.frequencies_hz, file.density_rad2_hz[axis]};
  }
  return description;
}

/// Right-handed turns about the own z, x and y axes, each left by the one before.
Mat3 mount_axes(const MountInput& input) {
  return rotation({0.0, 0.0, 1.0}, degrees(input.yaw_deg).value) *
         rotation({1.0, 0.0, 0.0}, degrees(input.pitch_deg).value) *
         rotation({0.0, 1.0, 0.0}, degrees(input.roll_deg).value);
}

sensor::Mount load_mount(const MountInput& input, const PlatformTask& task) {
  sensor::Mount mount{input.offset_m, mount_axes(input), sensor::FixedMount{}};
  if (const auto* scan = std::get_if<sensor::ScanMount>(&input.law)) mount.law = *scan;
  if (const auto* place = std::get_if<PlaceInput>(&input.law)) {
    mount.law = sensor::StareMount{load_place(*place, task)};
  }
  return mount;
}

sensor::PlatformDescription description_of(const PlatformTask& task) {
  const PlatformInput& input = task.input();
  sensor::PlatformDescription description;
  description.track = load_track(task);
  description.attitude = load_attitude(task, description.track);
  description.mounts = at_element(input.where, [&] {
    std::vector<sensor::Mount> mounts;
    for (const MountInput& mount : input.mounts) mounts.push_back(load_mount(mount, task));
    return mounts;
  });
  description.jitter = load_jitter(task);
  return description;
}

/// The place on the terrain above or below another one; nothing where there is no terrain.
std::optional<Vec3> terrain_at(const TerrainProbe& terrain, Vec3 place) {
  try {
    return terrain.lifted({place.x, place.y, 0.0});
  } catch (const InputError&) {
    return std::nullopt;  // the probe's way to say so
  }
}

/// A camera, and the moments of the way that it goes.
struct LoadedPlatform {
  sensor::Platform platform;
  std::vector<double> way_times_s{};  ///< none where it stands still
};

/// Moments at which to look where the camera is: evenly over the span, as ground may rise between
/// two distant places of a way, and those of the way itself. Some 2000 at most, 1 us each.
std::vector<double> moments_of(const LoadedPlatform& loaded, const sensor::TimeSpan& span) {
  constexpr std::size_t most = 1000;
  std::vector<double> moments{span.first_s, span.last_s};
  if (loaded.way_times_s.size() < 2) return moments;
  for (std::size_t i = 1; i < most; ++i) {
    moments.push_back(span.first_s + (span.last_s - span.first_s) * static_cast<double>(i) / most);
  }
  const auto begin =
      std::lower_bound(loaded.way_times_s.begin(), loaded.way_times_s.end(), span.first_s);
  const auto end = std::upper_bound(begin, loaded.way_times_s.end(), span.last_s);
  const auto inside = static_cast<std::size_t>(end - begin);
  const std::size_t step = 1 + inside / most;
  for (std::size_t i = 0; i < inside; i += step) {
    moments.push_back(begin[static_cast<std::ptrdiff_t>(i)]);
  }
  return moments;
}

/// The deepest of the places that were looked at is told.
void check_above_ground(const LoadedPlatform& loaded, const PlatformTask& task) {
  constexpr double rounding_m = 1e-3;  // of heights that went through the earth's centre
  double deepest_m = rounding_m, when_s = 0.0;
  for (const double time_s : moments_of(loaded, task.span)) {
    const Vec3 camera = loaded.platform.steady(time_s).position;
    const auto ground = terrain_at(task.terrain, camera);
    if (!ground || ground->z - camera.z <= deepest_m) continue;
    deepest_m = ground->z - camera.z;
    when_s = time_s;
  }
  if (deepest_m == rounding_m) return;
  const std::string when = task.input().stands_still()
                               ? std::string{}
                               : fmt::format(" {:.9g} s after the scenario's time", when_s);
  refuse_at(
      task.input().position_where,
      fmt::format("camera under ground: it lies {:.3f} m below the terrain{}", deepest_m, when));
}

/// A camera at a place, aimed and left alone.
bool is_plain(const PlatformInput& platform) {
  return platform.stands_still() && is_aimed(platform) && !platform.jitter &&
         platform.mounts.empty();
}

LoadedPlatform platform_of(const PlatformTask& task) {
  const PlatformInput& input = task.input();
  if (is_plain(input)) {
    const Vec3 position = load_track(task).at(0.0).position;
    return at_element(input.attitude_where,
                      [&] { return LoadedPlatform{sensor::Platform{still_pose(task, position)}}; });
  }
  const sensor::PlatformDescription description = description_of(task);
  return at_element(input.where, [&] {
    LoadedPlatform loaded{
        sensor::Platform{description, task.frame, task.span.first_s, task.span.last_s}};
    if (!description.track.is_fixed()) loaded.way_times_s = description.track.times_s();
    return loaded;
  });
}

}  // namespace

sensor::PlatformDescription describe_platform(const Scenario& scenario,
                                              const geometry::LocalFrame& frame,
                                              const TerrainProbe& terrain, InputFiles& files,
                                              sensor::TimeSpan span) {
  return description_of({scenario, frame, terrain, files, span});
}

sensor::Platform load_platform(const Scenario& scenario, const geometry::LocalFrame& frame,
                               const TerrainProbe& terrain, InputFiles& files,
                               sensor::TimeSpan span) {
  const PlatformTask task{scenario, frame, terrain, files, span};
  LoadedPlatform loaded = platform_of(task);
  check_above_ground(loaded, task);
  return std::move(loaded.platform);
}

}  // namespace nadir::sim
