#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/quaternion.hpp"
#include "ephemeris/instant.hpp"

namespace nadir::sim {

/// Angles of an orientation, degrees; what they turn about, the reader's user says.
struct AttitudeAngles {
  double yaw_deg = 0.0, pitch_deg = 0.0, roll_deg = 0.0;
};

/// How a platform was turned at some moments, as a file tells it.
struct AttitudeFile {
  std::vector<double> times_s;  ///< after the origin; ascending
  std::vector<int> lines;       ///< of the file, for messages; one a time
  std::variant<std::vector<Quaternion>, std::vector<AttitudeAngles>> orientations;  ///< one a time
};

/// Reads a table of orientations: `time_s` or `time_utc`, and `w`, `x`, `y`, `z`, or `yaw_deg`,
/// `pitch_deg`, `roll_deg`. Quaternions are of length 1 within 1e-3, which are then made so.
/// @param origin  the moment that times are counted from
/// @throws InputError with every mistake of the file (20 in full), each with line and column
[[nodiscard]] AttitudeFile read_attitude_file(const std::filesystem::path& file,
                                              const ephemeris::Instant& origin);
/// The same from text; `name` stands in messages.
[[nodiscard]] AttitudeFile parse_attitude_file(std::string_view text, const std::string& name,
                                               const ephemeris::Instant& origin);

}  // namespace nadir::sim
