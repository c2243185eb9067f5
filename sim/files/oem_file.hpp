#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/quantity.hpp"
#include "ephemeris/instant.hpp"
#include "sensor/orbit/earth_frames.hpp"

namespace nadir::sim {

/// A place on an orbit: earth-fixed axes, m, and m/s over the turning earth.
struct EphemerisPoint {
  ephemeris::Instant time;
  sensor::StateVector ecef;
};

/// What an orbit ephemeris message holds.
struct OrbitEphemeris {
  std::string object;                  ///< its name
  std::vector<EphemerisPoint> points;  ///< times ascend strictly
  /// The part of the points that may be used; those outside are there to interpolate with.
  std::size_t first_useable = 0, last_useable = 0;
};

/// Reads an orbit ephemeris message (CCSDS 502.0-B, key = value text; docs/orbits.md).
///
/// Time systems UTC, TAI, TT, GPS and UT1. Frames fixed to the earth are taken as they are; TEME,
/// EME2000, GCRF and ICRF are turned into them, without polar motion (at most 10 m at the ground).
/// Covariances and accelerations are passed over. Segments are joined where each begins with the
/// state with which the one before ends.
/// @param ut1_utc  for all of its times, as in Instant::parse_utc
/// @throws InputError with file, line and column
[[nodiscard]] OrbitEphemeris read_oem(const std::filesystem::path& file,
                                      Seconds ut1_utc = Seconds{0.0});
/// The same from text; `name` stands in messages.
[[nodiscard]] OrbitEphemeris parse_oem(std::string_view text, const std::string& name,
                                       Seconds ut1_utc = Seconds{0.0});

/// The points that may be used of a message.
[[nodiscard]] std::vector<EphemerisPoint> read_orbit_ephemeris(const std::filesystem::path& file,
                                                               Seconds ut1_utc = Seconds{0.0});

}  // namespace nadir::sim
