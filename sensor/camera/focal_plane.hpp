#pragma once

#include "sensor/camera/detector_array.hpp"

// Between a detector of an array and a place on the focal plane, both ways. Part of the camera.

namespace nadir::sensor {

/// A place among an array's detectors: columns as in the image, (0.5: the first one's middle), and
/// how far below the middle row.
struct DetectorPlace {
  double column = 0.0, row_m = 0.0;
};

/// The module that holds a column, the outermost ones beyond them; null where the array is of one
/// piece.
[[nodiscard]] const Module* module_of(const DetectorArray& array, double column) noexcept;

/// @param module  null: the perfect array
[[nodiscard]] Vec2 focal_place(const DetectorArray& array, const Module* module,
                               DetectorPlace place) noexcept;
[[nodiscard]] DetectorPlace detector_place(const DetectorArray& array, const Module* module,
                                           Vec2 focal_m) noexcept;

/// A place of the focal plane in the coordinates of an array's view table, and back.
[[nodiscard]] Vec2 table_place(const DetectorArray& array, const ViewTable& table,
                               Vec2 focal_m) noexcept;
[[nodiscard]] Vec2 focal_of_table(const DetectorArray& array, const ViewTable& table,
                                  Vec2 place) noexcept;

/// Line of sight through a place of the focal plane, not of length 1: as plain cameras have it,
/// (x, y, f), whose rounding images depend on bit for bit.
[[nodiscard]] Vec3 sight(const DetectorArray& array, Vec2 focal_m) noexcept;

}  // namespace nadir::sensor
