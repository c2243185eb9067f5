#include "sim/run/load_attitude.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "sim/files/attitude_file.hpp"
#include "sim/run/load_air.hpp"

namespace nadir::sim {
namespace {

using sensor::Reference;

/// Angles as in <nadir>: what they add to its axes, whatever the way.
Mat3 track_turns(const AttitudeAngles& angles, const geometry::LocalFrame& frame) {
  const sensor::TrackState north{{0.0, 0.0, 1000.0}, {0.0, 100.0, 0.0}};
  sensor::TrackAttitude attitude;
  const Mat3 straight = sensor::axes(attitude, frame, north, 0.0);
  attitude.yaw = degrees(angles.yaw_deg);
  attitude.pitch = degrees(angles.pitch_deg);
  attitude.roll = degrees(angles.roll_deg);
  return straight.transposed() * sensor::axes(attitude, frame, north, 0.0);
}

Quaternion orientation_of(const AttitudeAngles& angles, Reference reference,
                          const geometry::LocalFrame& frame) {
  if (reference == Reference::orbit) return to_quaternion(track_turns(angles, frame));
  return to_quaternion(sensor::from_euler({}, Mat3{}, degrees(angles.yaw_deg),
                                          degrees(angles.pitch_deg), degrees(angles.roll_deg))
                           .axes);
}

std::vector<Quaternion> orientations_of(const AttitudeFile& file, Reference reference,
                                        const geometry::LocalFrame& frame) {
  if (const auto* given = std::get_if<std::vector<Quaternion>>(&file.orientations)) return *given;
  if (reference == Reference::earth) {
    throw InputError{
        "yaw_deg, pitch_deg, roll_deg mean nothing in the axes of the earth: give w, x, y, z, or "
        "another reference"};
  }
  std::vector<Quaternion> all;
  for (const AttitudeAngles& angles : std::get<1>(file.orientations)) {
    all.push_back(orientation_of(angles, reference, frame));
  }
  return all;
}

/// A turn of more than a quarter from row to row could have gone either way round.
void check_turns(const AttitudeFile& file, const std::vector<Quaternion>& orientations,
                 const std::string& name) {
  constexpr double most_deg = 90.0, rounding_deg = 1e-6;
  for (std::size_t i = 1; i < orientations.size(); ++i) {
    const double cos_half = std::min(1.0, std::abs(dot(orientations[i - 1], orientations[i])));
    const double turn_deg = to_degrees(Angle{2.0 * std::acos(cos_half)});
    if (turn_deg <= most_deg + rounding_deg) continue;
    refuse_at({name, file.lines[i], 0},
              fmt::format("attitude gap: the platform turns by {:.1f} degrees between {:.9g} s and "
                          "{:.9g} s; at most {} can be told from the other way round",
                          turn_deg, file.times_s[i - 1], file.times_s[i], most_deg));
  }
}

void check_row_gaps(const AttitudeFile& file, std::optional<double> max_gap_s,
                    const PlatformTask& task) {
  const std::optional<double> longest_s = longest_step_s(file.times_s, max_gap_s);
  if (!longest_s || file.times_s.size() < 2) return;
  const auto gap = gap_of(file.times_s, 2, *longest_s, task.span);
  if (!gap) return;
  throw InputError{fmt::format(
      "attitude gap: the camera looks between {:.9g} s and {:.9g} s, where no row stands for "
      "{:.9g} s; {} {:.9g}",
      gap->begin_s, gap->end_s, gap->length_s(),
      max_gap_s ? "max_gap_s is" : "without max_gap_s the limit is five times the median step,",
      *longest_s)};
}

sensor::Attitude load_attitude_table(const AttitudeTableInput& input, const PlatformTask& task) {
  const AttitudeFile file = read_attitude_file(task.files.note(input.file), task.scenario.time);
  const sensor::TimeSpan covered{file.times_s.front(), file.times_s.back()};
  const bool constant = file.times_s.size() == 1;
  if (!constant && leaves_open(covered, task)) {
    throw InputError{"attitude gap: " +
                     open_message(input.file.filename().string(), covered, task)};
  }
  check_row_gaps(file, input.max_gap_s, task);
  std::vector<Quaternion> turned = orientations_of(file, input.reference, task.frame);
  check_turns(file, turned, input.file.string());
  return sensor::checked(
      sensor::TabulatedAttitude{input.reference, file.times_s, std::move(turned)});
}

sensor::Attitude constant_attitude(Reference reference, const Quaternion& orientation) {
  return sensor::TabulatedAttitude{reference, {0.0}, {orientation}};
}

sensor::Attitude moving_attitude(const PlatformTask& task) {
  const AttitudeInput& input = task.input().attitude;
  if (const auto* aim = std::get_if<LookAtInput>(&input)) {
    return sensor::LookAtAttitude{load_place({aim->target, aim->on_terrain}, task),
                                  degrees(aim->roll_deg)};
  }
  if (const auto* angles = std::get_if<EulerInput>(&input)) {
    return sensor::EulerAttitude{degrees(angles->yaw_deg), degrees(angles->pitch_deg),
                                 degrees(angles->roll_deg)};
  }
  if (const auto* given = std::get_if<QuaternionInput>(&input)) {
    return constant_attitude(given->reference, given->orientation);
  }
  if (const auto* table = std::get_if<AttitudeTableInput>(&input))
    return load_attitude_table(*table, task);
  return std::get<sensor::TrackAttitude>(input);
}

}  // namespace

bool is_aimed(const PlatformInput& platform) {
  return std::holds_alternative<LookAtInput>(platform.attitude) ||
         std::holds_alternative<EulerInput>(platform.attitude);
}

sensor::Pose still_pose(const PlatformTask& task, Vec3 position) {
  const PlatformInput& platform = task.input();
  // Angles and "up" are those of the axes in which the position is given.
  const auto* geodetic = std::get_if<geometry::Geodetic>(&platform.position);
  const Mat3 local = geodetic != nullptr ? task.frame.axes_at(*geodetic) : Mat3{};
  if (const auto* aim = std::get_if<LookAtInput>(&platform.attitude)) {
    const Vec3 target = load_place({aim->target, aim->on_terrain}, task);
    return sensor::look_at(position, target, local, degrees(aim->roll_deg));
  }
  const auto& angles = std::get<EulerInput>(platform.attitude);
  return sensor::from_euler(position, local, degrees(angles.yaw_deg), degrees(angles.pitch_deg),
                            degrees(angles.roll_deg));
}

sensor::Attitude load_attitude(const PlatformTask& task, const sensor::Track& track) {
  return at_element(task.input().attitude_where, [&]() -> sensor::Attitude {
    if (track.is_fixed() && is_aimed(task.input())) {
      const Vec3 position = track.at(0.0).position;
      return constant_attitude(Reference::scene, to_quaternion(still_pose(task, position).axes));
    }
    return moving_attitude(task);
  });
}

}  // namespace nadir::sim
