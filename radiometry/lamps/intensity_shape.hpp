#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/vec.hpp"
#include "radiometry/lamps/lamp.hpp"

namespace nadir::radiometry {

/// Directions that a lamp may shine into, as the light hierarchy needs them: at an angle a from
/// the axis the intensity is at most `peak` cos(max(0, a - spread)), and 0 where that difference
/// exceeds `fade`.
struct EmissionBound {
  double spread_rad = 3.14159265358979323846;  ///< in [0, pi]
  double fade_rad = 0.0;                       ///< in [0, pi/2]
  double peak = 0.0;                           ///< sr^-1, of a shape that integrates to 1
};

/// A lamp's intensity over direction, scaled so that its integral over the sphere is 1: times the
/// flux it is the intensity in W sr^-1 um^-1. Immutable.
class BoundShape {
 public:
  /// @throws InputError for tables and angles that lamp.hpp rules out, and for shapes without light
  explicit BoundShape(const IntensityShape& shape);

  /// @param direction  unit, in the lamp's axes: z along its axis, x along its side, y =
  /// cross(side,
  ///                   axis), which makes them left-handed (see IntensityTable)
  /// @return sr^-1
  [[nodiscard]] double operator()(Vec3 direction) const noexcept;
  [[nodiscard]] const EmissionBound& bound() const noexcept { return bound_; }

 private:
  struct Cosine {
    double power = 0.0, cos_edge = -1.0, scale = 0.0;
  };
  /// Where a value lies in an ascending list, found without a search: `first` names for each of
  /// equal steps over the list's range the last entry that is not above the step's begin.
  struct Axis {
    std::vector<double> knots;
    std::vector<std::uint32_t> first;
    double steps_per_unit = 0.0;

    explicit Axis(std::vector<double> ascending);
    /// Index of the interval and the place in it from 0 to 1; `value` within the list's range.
    [[nodiscard]] std::pair<std::size_t, double> find(double value) const noexcept;
  };
  struct Table {
    Axis vertical, horizontal;
    std::vector<double> value;

    [[nodiscard]] double at(Vec3 direction) const noexcept;
  };

  void bind(const CosinePower& shape);
  void bind(const IntensityTable& shape);

  Cosine cosine_;
  std::optional<Table> table_;  // instead of the cosine
  EmissionBound bound_;
};

/// Integral over the sphere of a table, sr times its unit: exact for the bilinear interpolation,
/// with the vertical angle's part  int (a + b t) sin t dt  in closed form. Candela give lumens.
/// @throws InputError for a table that lamp.hpp rules out
[[nodiscard]] double integral(const IntensityTable& table);

}  // namespace nadir::radiometry
