#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/scenario/build_camera.hpp"

// Where arrays lie on the focal plane, and that no two of them are at the same place.

namespace nadir::sim {
namespace {

/// A turned rectangle on the focal plane, lengths in um.
struct Plate {
  double x = 0.0, y = 0.0;            ///< its middle
  double half_x = 0.0, half_y = 0.0;  ///< along its own sides
  double turn_rad = 0.0;              ///< from x to y
};

/// How deep two plates lie in each other: the least depth along the normals of their sides
/// (separating axes); negative where a gap is between them.
double depth(const Plate& a, const Plate& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const double turn : {a.turn_rad, b.turn_rad}) {
    for (const double angle : {turn, turn + std::numbers::pi / 2.0}) {
      const auto reach = [&](const Plate& plate) {
        return plate.half_x * std::abs(std::cos(plate.turn_rad - angle)) +
               plate.half_y * std::abs(std::sin(plate.turn_rad - angle));
      };
      const double apart = (b.x - a.x) * std::cos(angle) + (b.y - a.y) * std::sin(angle);
      least = std::min(least, reach(a) + reach(b) - std::abs(apart));
    }
  }
  return least;
}

bool contains(const Plate& outer, const Plate& inner) {
  const double slack = 1e-9 * (outer.half_x + outer.half_y);  // rounding of equal extents
  return std::abs(inner.x - outer.x) + inner.half_x <= outer.half_x + slack &&
         std::abs(inner.y - outer.y) + inner.half_y <= outer.half_y + slack;
}

struct PlacedArray {
  Plate whole;
  std::vector<Plate> plates;  ///< its modules; `whole` where there are none
  double pixel = 0.0;         ///< the smaller side of a pixel
  bool scanned = false;
};

/// Columns and rows of detectors behind the columns and rows of the image.
std::array<int, 2> detectors_of(const ArrayInput& array) {
  if (const auto* push = std::get_if<PushbroomInput>(&array.timing)) {
    return {array.samples, push->tdi_stages};
  }
  if (const auto* whisk = std::get_if<WhiskbroomInput>(&array.timing)) {
    return {1, whisk->lines_per_scan};
  }
  return {array.samples, array.lines};
}

PlacedArray place_of(const ArrayInput& array, bool orthographic) {
  constexpr double um_per_m = 1e6;
  const double pitch_x = orthographic ? array.ground_pitch_m * um_per_m : array.pitch_um;
  const double own_y = orthographic ? array.ground_pitch_y_m * um_per_m : array.pitch_y_um;
  const double pitch_y = own_y > 0.0 ? own_y : pitch_x;
  const auto [columns, rows] = detectors_of(array);
  PlacedArray placed;
  placed.whole = {orthographic ? array.offset_x_m * um_per_m : array.offset_x_um,
                  orthographic ? array.offset_y_m * um_per_m : array.offset_y_um,
                  0.5 * columns * pitch_x, 0.5 * rows * pitch_y, 0.0};
  placed.pixel = std::min(pitch_x, pitch_y);
  placed.scanned = is_scanned(array.timing);
  for (const ModuleInput& module : array.modules) {
    const double middle = module.first_sample + 0.5 * module.samples - 0.5 * array.samples;
    placed.plates.push_back({placed.whole.x + middle * pitch_x + module.offset_x_um,
                             placed.whole.y + module.offset_y_um, 0.5 * module.samples * pitch_x,
                             placed.whole.half_y, module.rotation_deg * std::numbers::pi / 180.0});
  }
  if (placed.plates.empty()) placed.plates.push_back(placed.whole);
  return placed;
}

/// A tenth of a pixel, as sensor::check allows: what lies edge to edge, or is turned by a trifle,
/// shall pass.
bool overlap(const Plate& a, const Plate& b, double pixel) { return depth(a, b) > 0.1 * pixel; }

bool overlap(const PlacedArray& a, const PlacedArray& b) {
  // A beam splitter shows one field to two frames: one of them then has all of the other's.
  const bool frames = !a.scanned && !b.scanned;
  if (frames && (contains(a.whole, b.whole) || contains(b.whole, a.whole))) return false;
  const double pixel = std::min(a.pixel, b.pixel);
  return std::any_of(a.plates.begin(), a.plates.end(), [&](const Plate& p) {
    return std::any_of(b.plates.begin(), b.plates.end(),
                       [&](const Plate& q) { return overlap(p, q, pixel); });
  });
}

void check_own_modules(const BuildContext& context, const CheckedElement& element,
                       const ArrayInput& array, const PlacedArray& placed) {
  for (std::size_t i = 1; i < placed.plates.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!overlap(placed.plates[i], placed.plates[k], placed.pixel)) continue;
      context.mistake(
          element.offset,
          fmt::format("the modules of array \"{}\" that begin at samples {} and {} lie "
                      "at the same place of the focal plane",
                      array.name, array.modules[k].first_sample, array.modules[i].first_sample));
      return;
    }
  }
}

}  // namespace

void check_focal_plane(const BuildContext& context,
                       const std::vector<const CheckedElement*>& elements,
                       const CameraInput& camera) {
  std::vector<PlacedArray> places;
  for (std::size_t i = 0; i < camera.arrays.size(); ++i) {
    const ArrayInput& array = camera.arrays[i];
    places.push_back(place_of(array, camera.orthographic));
    check_own_modules(context, *elements[i], array, places[i]);
    for (std::size_t k = 0; k < i; ++k) {
      const ArrayInput& other = camera.arrays[k];
      if (array.own_lens || other.own_lens || array.view_table) continue;
      if (!overlap(places[i], places[k])) continue;
      context.mistake(
          elements[i]->offset,
          fmt::format("array \"{}\" lies where array \"{}\" (line {}) is on the focal "
                      "plane",
                      array.name, other.name, context.source.locate(elements[k]->offset).line),
          "move it by its offsets, or give it own_lens=\"true\" if it has a lens or a "
          "beam splitter of its own");
      break;
    }
  }
}

}  // namespace nadir::sim
