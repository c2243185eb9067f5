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

[[nodiscard]] Vec2 focal_place(const DetectorArray& array, const Module& module,
                               DetectorPlace place) noexcept;
/// @param module  null: the perfect array
[[nodiscard]] inline Vec2 focal_place(const DetectorArray& array, const Module* module,
                                      DetectorPlace place) noexcept {
  if (module != nullptr) return focal_place(array, *module, place);
  return {array.offset_x_m + (place.column - 0.5 * array.samples) * array.pitch_m,
          array.offset_y_m + place.row_m};
}
[[nodiscard]] DetectorPlace detector_place(const DetectorArray& array, const Module* module,
                                           Vec2 focal_m) noexcept;

/// A place of the focal plane in the coordinates of an array's view table, and back.
[[nodiscard]] Vec2 table_place(const DetectorArray& array, const ViewTable& table,
                               Vec2 focal_m) noexcept;
[[nodiscard]] Vec2 focal_of_table(const DetectorArray& array, const ViewTable& table,
                                  Vec2 place) noexcept;

/// Line of sight of lenses with distortion and of view tables, not of length 1.
[[nodiscard]] Vec3 bent_sight(const DetectorArray& array, Vec2 focal_m) noexcept;
/// Line of sight through a place of the focal plane, not of length 1: as plain cameras have it,
/// (x, y, f), whose rounding images depend on bit for bit.
[[nodiscard]] inline Vec3 sight(const DetectorArray& array, Vec2 focal_m) noexcept {
  const auto* lens = std::get_if<Perspective>(&array.projection);
  if (lens == nullptr || !lens->distortion.is_none()) return bent_sight(array, focal_m);
  return {focal_m.x, focal_m.y, lens->focal_length_m};
}

}  // namespace nadir::sensor
