#include "sensor/camera/detector_array.hpp"

#include <algorithm>
#include <cmath>

#include "sensor/camera/focal_plane.hpp"

namespace nadir::sensor {
namespace {

// Where a module's middle is, and how it is turned.
struct Seat {
  double middle = 0.0;  // column
  Vec2 place_m;
  double cosine = 1.0, sine = 0.0;
};

Seat seat(const DetectorArray& array, const Module& module) noexcept {
  const double middle = module.first_sample + 0.5 * module.samples;
  Seat at{middle,
          {array.offset_x_m + (middle - 0.5 * array.samples) * array.pitch_m + module.offset_x_m,
           array.offset_y_m + module.offset_y_m}};
  if (module.rotation_rad != 0.0) {
    at.cosine = std::cos(module.rotation_rad);
    at.sine = std::sin(module.rotation_rad);
  }
  return at;
}

double beyond_whole(double coordinate) noexcept { return coordinate - std::floor(coordinate); }

}  // namespace

const Module* module_of(const DetectorArray& array, double column) noexcept {
  if (array.modules.empty()) return nullptr;
  const auto after =
      std::upper_bound(array.modules.begin(), array.modules.end(), column,
                       [](double c, const Module& module) { return c < module.first_sample; });
  return after == array.modules.begin() ? &*after : &*(after - 1);
}

Vec2 focal_place(const DetectorArray& array, const Module& module, DetectorPlace place) noexcept {
  const Seat at = seat(array, module);
  const double along = (place.column - at.middle) * array.pitch_m;
  return {at.place_m.x + at.cosine * along - at.sine * place.row_m,
          at.place_m.y + at.sine * along + at.cosine * place.row_m};
}

DetectorPlace detector_place(const DetectorArray& array, const Module* module,
                             Vec2 focal_m) noexcept {
  if (module == nullptr) {
    return {(focal_m.x - array.offset_x_m) / array.pitch_m + 0.5 * array.samples,
            focal_m.y - array.offset_y_m};
  }
  const Seat at = seat(array, *module);
  const double x = focal_m.x - at.place_m.x, y = focal_m.y - at.place_m.y;
  return {at.middle + (at.cosine * x + at.sine * y) / array.pitch_m, at.cosine * y - at.sine * x};
}

Vec2 focal_place(const DetectorArray& array, Vec2 image) noexcept {
  const double height_m = array.height_m();
  DetectorPlace place{image.x, 0.0};
  if (std::holds_alternative<Pushbroom>(array.timing.scan)) {
    place.row_m = (beyond_whole(image.y) - 0.5) * height_m;
  } else if (const auto* broom = std::get_if<Whiskbroom>(&array.timing.scan)) {
    const double rows = broom->lines_per_scan;
    place.column = 0.5 * array.samples + (beyond_whole(image.x) - 0.5);
    place.row_m = (image.y - rows * std::floor(image.y / rows) - 0.5 * rows) * height_m;
  } else {
    place.row_m = (image.y - 0.5 * array.lines) * height_m;
  }
  return focal_place(array, module_of(array, place.column), place);
}

Vec2 table_place(const DetectorArray& array, const ViewTable& table, Vec2 focal_m) noexcept {
  const double sample = focal_m.x / array.pitch_m + 0.5 * array.samples;
  if (table.lines == 1) return {sample, focal_m.y / array.pitch_m + 0.5};
  return {sample, focal_m.y / array.height_m() + 0.5 * array.lines};
}

Vec2 focal_of_table(const DetectorArray& array, const ViewTable& table, Vec2 place) noexcept {
  const double x_m = (place.x - 0.5 * array.samples) * array.pitch_m;
  if (table.lines == 1) return {x_m, (place.y - 0.5) * array.pitch_m};
  return {x_m, (place.y - 0.5 * array.lines) * array.height_m()};
}

Vec3 bent_sight(const DetectorArray& array, Vec2 focal_m) noexcept {
  if (const auto* lens = std::get_if<Perspective>(&array.projection)) {
    const double f = lens->focal_length_m;
    const Vec2 ideal = undistorted(lens->distortion, {focal_m.x / f, focal_m.y / f});
    return {ideal.x, ideal.y, 1.0};
  }
  if (const auto* table = std::get_if<Tabulated>(&array.projection)) {
    return direction(**table, table_place(array, **table, focal_m));
  }
  return {0.0, 0.0, 1.0};
}

Vec3 camera_direction(const DetectorArray& array, Vec2 focal_m) noexcept {
  return normalised(sight(array, focal_m));
}

}  // namespace nadir::sensor
