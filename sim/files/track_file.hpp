#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec.hpp"
#include "ephemeris/instant.hpp"

namespace nadir::sim {

/// Where a platform was at some moments, as a file tells it.
struct TrackFile {
  enum class Axes {
    geodetic,  ///< latitude [deg], longitude [deg], height above the WGS84 ellipsoid [m]
    earth,     ///< ECEF, m
    scene      ///< east, north, up of the scene's site, m
  };
  std::vector<double> times_s;  ///< after the origin; ascending
  Axes axes = Axes::geodetic;
  std::vector<Vec3> points;  ///< one a time
};

/// Reads a table of way points: `time_s` or `time_utc`, and `latitude_deg`, `longitude_deg`,
/// `height_m`, or `x_m`, `y_m`, `z_m`, or `east_m`, `north_m`, `up_m`; at least two rows.
/// @param origin  the moment that times are counted from
/// @throws InputError with every mistake of the file (20 in full), each with line and column
[[nodiscard]] TrackFile read_track_file(const std::filesystem::path& file,
                                        const ephemeris::Instant& origin);
/// The same from text; `name` stands in messages.
[[nodiscard]] TrackFile parse_track_file(std::string_view text, const std::string& name,
                                         const ephemeris::Instant& origin);

}  // namespace nadir::sim
