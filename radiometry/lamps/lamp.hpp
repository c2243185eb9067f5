#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "core/vec.hpp"
#include "geometry/shapes.hpp"
#include "spectral/curve.hpp"

// Lamps as a scenario describes them: plain data, scene axes.

namespace nadir::radiometry {

/// Relative luminous intensity over the lamp's own directions, as in IES LM-63 (type C): vertical
/// angle from the lamp's axis (nadir of the luminaire), horizontal angle about it, from `side`
/// towards cross(side, axis): counter-clockwise seen from above a lamp that shines down. Any
/// positive scale; linear between the angles, 0 outside the vertical ones.
struct IntensityTable {
  std::vector<double> vertical_rad;  ///< ascending within [0, pi]
  /// Ascending from 0 to pi/2 (each quadrant alike), pi (both halves alike) or 2 pi; one entry: the
  /// same all around.
  std::vector<double> horizontal_rad;
  std::vector<double> value;  ///< vertical fastest, >= 0
};
/// cos^p of the angle from the axis, up to a sharp edge; nothing beyond 90 degrees unless p is 0.
/// p = 0 with pi: alike in all directions.
struct CosinePower {
  double power = 0.0;
  double half_angle_rad = 3.14159265358979323846;
};
using IntensityShape = std::variant<CosinePower, std::shared_ptr<const IntensityTable>>;

/// A lamp too small to have a size: point or spot. Within `nearest_m` its light is as at that
/// distance, since no real lamp is smaller.
struct PointLamp {
  static constexpr double nearest_m = 1e-3;

  Vec3 position;
  Vec3 axis{0.0, 0.0, -1.0};  ///< unit; street lamps shine down
  Vec3 side{1.0, 0.0, 0.0};   ///< unit, normal to the axis: horizontal angle 0
  IntensityShape shape = CosinePower{};
};
/// A surface that shines diffusely: the front of a disc or plane, or the outside of a sphere. It is
/// part of the scene's geometry as well, so that it is seen and throws shadows.
struct AreaLamp {
  std::variant<geometry::Disc, geometry::Plane, geometry::Sphere> surface;
  /// The surface's axes in the scene, unit and at right angles: its point (x, y, z) lies at centre
  /// + x axis_x + y axis_y + z cross(axis_x, axis_y).
  Vec3 centre, axis_x{1.0, 0.0, 0.0}, axis_y{0.0, 1.0, 0.0};
  std::uint32_t object = 0;  ///< that the geometry's hits carry; one lamp only
};

/// A spectrum that many lamps share, and a factor of this one's own.
struct LampFlux {
  std::shared_ptr<const spectral::Curve> curve;
  double factor = 1.0;

  // A curve of its own is a lamp's usual flux.
  LampFlux(spectral::Curve of_one)  // NOLINT(google-explicit-constructor)
      : curve{std::make_shared<const spectral::Curve>(std::move(of_one))} {}
  LampFlux(std::shared_ptr<const spectral::Curve> shared, double times)
      : curve{std::move(shared)}, factor{times} {}
};

struct Lamp {
  std::string name{};
  std::variant<PointLamp, AreaLamp> form{};
  /// Spectral flux in all directions together, W um^-1.
  LampFlux flux = spectral::Curve::constant(0.0);
  SourceLocation where{};
};

}  // namespace nadir::radiometry
