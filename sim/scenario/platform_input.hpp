#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "core/quaternion.hpp"
#include "core/vec.hpp"
#include "geometry/earth.hpp"
#include "sensor/orbit/kepler_orbit.hpp"
#include "sensor/platform/attitude.hpp"
#include "sensor/platform/mount.hpp"

// What a scenario says of where its camera is and how it moves.

namespace nadir::sim {

/// Geodetic, or local east, north, up in m.
struct PlaceInput {
  std::variant<geometry::Geodetic, Vec3> where;
  bool on_terrain = false;  ///< local up counts from the terrain
};

// ---- position ---------------------------------------------------------------------------------

struct StraightInput {
  PlaceInput place;  ///< at the scenario's time
  double azimuth_deg = 0.0, speed_m_s = 0.0, climb_m_s = 0.0;
};
struct CircleInput {
  PlaceInput centre;  ///< at the height of the flight
  double radius_m = 0.0, speed_m_s = 0.0;
  double azimuth_deg = 0.0;  ///< from the centre to the platform at the scenario's time
  bool clockwise = true;
};
struct WaypointsInput {
  std::filesystem::path file;
  bool straight = false;              ///< straight pieces in place of Lagrange's polynomials
  std::optional<double> max_gap_s{};  ///< longest time between places that are used
};
struct TwoLineInput {
  std::filesystem::path file;
  std::string satellite;  ///< name or catalogue number
};
struct EphemerisInput {
  std::filesystem::path file;         ///< CCSDS OEM
  std::optional<double> max_gap_s{};  ///< longest time between places that are used
};
/// The first two stand still.
using PositionInput =
    std::variant<geometry::Geodetic, Vec3, StraightInput, CircleInput, WaypointsInput,
                 sensor::Overpass, sensor::KeplerElements, TwoLineInput, EphemerisInput>;

// ---- attitude ---------------------------------------------------------------------------------

struct LookAtInput {
  std::variant<geometry::Geodetic, Vec3> target;
  bool on_terrain = false;
  double roll_deg = 0.0;  ///< clockwise about the line of sight; 0: image top as high as it goes
};
/// Yaw clockwise from north, pitch up from the horizon (-90: straight down), roll right side down.
struct EulerInput {
  double yaw_deg = 0.0, pitch_deg = 0.0, roll_deg = 0.0;
};
struct QuaternionInput {
  sensor::Reference reference = sensor::Reference::scene;
  Quaternion orientation;  ///< from the platform's axes to the reference's
};
struct AttitudeTableInput {
  std::filesystem::path file;
  sensor::Reference reference = sensor::Reference::scene;
  std::optional<double> max_gap_s;  ///< longest time between rows where the camera looks
};
using AttitudeInput = std::variant<LookAtInput, EulerInput, QuaternionInput, sensor::TrackAttitude,
                                   AttitudeTableInput>;

// ---- what is between platform and camera ------------------------------------------------------

struct JitterInput {
  Vec3 white_urad;  ///< rms about x, y, z
  std::optional<std::filesystem::path> spectrum;
  std::uint64_t seed = 1;
  SourceLocation where{};
};
/// Right-handed turns about the mount's own z (yaw), x (pitch) and y (roll), in that order.
struct MountInput {
  Vec3 offset_m;  ///< in the carrier's axes
  double yaw_deg = 0.0, pitch_deg = 0.0, roll_deg = 0.0;
  std::variant<sensor::FixedMount, sensor::ScanMount, PlaceInput> law;  ///< a place: stares at it
};

struct PlatformInput {
  using LookAt = LookAtInput;
  using Euler = EulerInput;
  std::string name;  ///< for metadata; may be empty
  PositionInput position;
  bool on_terrain = false;  ///< of a local position that stands still: up counts from the terrain
  AttitudeInput attitude;
  std::optional<JitterInput> jitter;
  std::vector<MountInput> mounts;  ///< from the platform outwards
  SourceLocation where{};
  SourceLocation position_where{}, attitude_where{};  ///< of what they hold

  [[nodiscard]] bool stands_still() const noexcept {
    return std::holds_alternative<geometry::Geodetic>(position) ||
           std::holds_alternative<Vec3>(position);
  }
};

}  // namespace nadir::sim
