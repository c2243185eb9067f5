#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "sensor/camera/path_view.hpp"

// Cameras and ways for the tests of what moves.

namespace nadir::sensor::support {

/// Looks straight down, image down (+y) to the north; x is then to the west.
inline const Mat3 facing_down{{-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, -1.0}};

inline Attitude steady_attitude(const Mat3& axes) {
  return TabulatedAttitude{Reference::scene, {0.0}, {to_quaternion(axes)}};
}

inline const geometry::LocalFrame& any_frame() {
  static const geometry::LocalFrame frame{{10.0, 20.0, 0.0}};
  return frame;
}

/// In a straight line over a flat ground at height 0, past the origin at time 0.
inline PlatformDescription straight_way(double height_m, Vec3 velocity, double seconds,
                                        const Mat3& axes = facing_down) {
  PlatformDescription way;
  const Vec3 middle{0.0, 0.0, height_m};
  way.track =
      Track{{-seconds, seconds}, {middle - seconds * velocity, middle + seconds * velocity}, 2};
  way.attitude = steady_attitude(axes);
  return way;
}

inline Platform platform_of(const PlatformDescription& way, double seconds) {
  return Platform{way, any_frame(), -seconds, seconds};
}

/// Round the scene's origin, which takes the earth's middle's place, in the plane of y and z;
/// looks at it, y along the way.
inline Platform orbit_of(double radius_m, double rate_rad_s, double seconds) {
  std::vector<double> times;
  std::vector<Vec3> places;
  TabulatedAttitude turning;
  for (int i = 0; i <= 200; ++i) {
    const double t = seconds * (i - 100) / 100.0, angle = rate_rad_s * t;
    const Vec3 up{0.0, std::sin(angle), std::cos(angle)},
        way{0.0, std::cos(angle), -std::sin(angle)};
    times.push_back(t);
    places.push_back(radius_m * up);
    turning.orientations.push_back(to_quaternion(Mat3{cross(way, -up), way, -up}));
  }
  turning.times_s = times;
  PlatformDescription description;
  description.track = Track{times, places};
  description.attitude = turning;
  return platform_of(description, seconds);
}

inline DetectorArray perspective(int samples, int lines, double pitch_m, double focal_length_m) {
  return {"a", samples, lines, Perspective{focal_length_m}, pitch_m, 0.0, 0.0, {}};
}

/// A pushbroom whose middle line is exposed at time 0.
inline DetectorArray pushbroom(int samples, int lines, double pitch_m, double focal_length_m,
                               double line_period_s) {
  DetectorArray array = perspective(samples, lines, pitch_m, focal_length_m);
  array.timing.scan = Pushbroom{-0.5 * (lines - 1) * line_period_s, line_period_s};
  return array;
}

/// Where a ray meets the plane at height 0.
inline Vec3 on_ground(const geometry::Ray& ray) {
  return ray.origin - (ray.origin.z / ray.direction.z) * ray.direction;
}

/// How far a place lies off a ray, m.
inline double miss_m(const geometry::Ray& ray, Vec3 place) {
  return length(cross(ray.direction, place - ray.origin));
}

/// A number from 0 to 1 of a fixed sequence.
inline double some(std::uint32_t index, std::uint32_t which) {
  return Sampler{0xCA3E7A, index}.number(which);
}
inline double some(std::uint32_t index, std::uint32_t which, double low, double high) {
  return low + (high - low) * some(index, which);
}

}  // namespace nadir::sensor::support
