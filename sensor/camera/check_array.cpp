#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"
#include "sensor/camera/detector_array.hpp"
#include "sensor/camera/focal_plane.hpp"

namespace nadir::sensor {
namespace {

void require_array(bool holds, const std::string& message) {
  if (!holds) throw InputError{message};
}

bool above_zero(double value) { return value > 0.0 && std::isfinite(value); }

void check_sizes(const DetectorArray& array) {
  require_array(array.samples > 0 && array.lines > 0, "an array has at least 1 sample and 1 line");
  require_array(above_zero(array.pitch_m), "the pixels' pitch must be above 0 m");
  require_array(array.pitch_y_m == 0.0 || above_zero(array.pitch_y_m),
                "the pixels' pitch along y must be above 0 m");
  require_array(std::isfinite(array.offset_x_m) && std::isfinite(array.offset_y_m),
                "the array's offset is not finite");
  for (const double fill : {array.fill_x, array.fill_y}) {
    require_array(fill > 0.0 && fill <= 1.0, "the sensitive part of the pitch is " +
                                                 number_text(fill) + ", allowed range is (0, 1]");
  }
}

void check_scan(const DetectorArray& array, const GlobalShutter& shutter) {
  static_cast<void>(array);
  require_array(std::isfinite(shutter.centre_s), "the exposure's time is not finite");
}

void check_scan(const DetectorArray& array, const RollingShutter& shutter) {
  static_cast<void>(array);
  require_array(std::isfinite(shutter.first_line_s), "the first line's time is not finite");
  require_array(shutter.line_period_s >= 0.0 && std::isfinite(shutter.line_period_s),
                "the line period of a rolling shutter must be at least 0 s");
}

void check_scan(const DetectorArray& array, const Pushbroom& broom) {
  require_array(std::isfinite(broom.first_line_s), "the first line's time is not finite");
  require_array(above_zero(broom.line_period_s),
                "the line period of a pushbroom must be above 0 s");
  require_array(array.timing.exposure_s <= broom.line_period_s * (1.0 + 1e-12),
                "the exposure, " + number_text(array.timing.exposure_s) +
                    " s, is longer than the line period, " + number_text(broom.line_period_s) +
                    " s");
}

void check_scan(const DetectorArray& array, const Whiskbroom& broom) {
  require_array(std::isfinite(broom.first_sample_s), "the first sample's time is not finite");
  require_array(above_zero(broom.sample_period_s) && above_zero(broom.scan_period_s),
                "the periods of a whiskbroom must be above 0 s");
  require_array(array.timing.exposure_s <= broom.sample_period_s * (1.0 + 1e-12),
                "the exposure, " + number_text(array.timing.exposure_s) +
                    " s, is longer than the sample period, " + number_text(broom.sample_period_s) +
                    " s");
  const double sweep_s = array.samples * broom.sample_period_s;
  require_array(sweep_s <= broom.scan_period_s * (1.0 + 1e-12),
                "a sweep of " + std::to_string(array.samples) + " samples takes " +
                    number_text(sweep_s) + " s, longer than the scan period, " +
                    number_text(broom.scan_period_s) + " s");
  require_array(broom.lines_per_scan > 0, "a whiskbroom has at least 1 line a scan");
  require_array(array.lines % broom.lines_per_scan == 0,
                "a whiskbroom's " + std::to_string(array.lines) +
                    " lines are not a whole number of scans of " +
                    std::to_string(broom.lines_per_scan) + " lines");
  require_array(array.modules.empty(), "a whiskbroom's column cannot be cut into modules");
  require_array(!std::holds_alternative<Tabulated>(array.projection),
                "a whiskbroom cannot have a view table: its column has one sample");
}

void check_timing(const DetectorArray& array) {
  const Timing& timing = array.timing;
  require_array(timing.exposure_s >= 0.0 && std::isfinite(timing.exposure_s),
                "the exposure must be at least 0 s");
  require_array(timing.lag_s >= 0.0 && std::isfinite(timing.lag_s),
                "the detector's time constant must be at least 0 s");
  require_array(timing.exposure_s == 0.0 || timing.lag_s == 0.0,
                "a detector has an exposure or a time constant, not both");
  require_array(timing.tdi_stages >= 1, "time-delay integration has at least 1 stage");
  require_array(timing.tdi_stages == 1 || std::holds_alternative<Pushbroom>(timing.scan),
                "time-delay integration is for pushbrooms only");
  std::visit([&](const auto& scan) { check_scan(array, scan); }, timing.scan);
}

void check_module_samples(const DetectorArray& array) {
  int next = 0;
  for (std::size_t i = 0; i < array.modules.size(); ++i) {
    const Module& module = array.modules[i];
    const std::string name = "module " + std::to_string(i + 1);
    require_array(module.samples > 0, name + " has no samples");
    require_array(std::isfinite(module.offset_x_m + module.offset_y_m + module.rotation_rad),
                  "the place of " + name + " is not finite");
    require_array(module.first_sample >= next,
                  name + " begins at sample " + std::to_string(module.first_sample) +
                      " and overlaps the one before, which ends at " + std::to_string(next));
    require_array(module.first_sample == next,
                  name + " begins at sample " + std::to_string(module.first_sample) +
                      " and leaves a gap after " + std::to_string(next));
    next += module.samples;
  }
  require_array(array.modules.empty() || next == array.samples,
                "the modules have " + std::to_string(next) + " samples, the array " +
                    std::to_string(array.samples));
}

// Corners of what lies on the focal plane: rows of detectors, without those beyond the image.
using Corners = std::array<Vec2, 4>;

double rows_of(const DetectorArray& array) {
  if (std::holds_alternative<Pushbroom>(array.timing.scan)) return array.timing.tdi_stages;
  const auto* broom = std::get_if<Whiskbroom>(&array.timing.scan);
  return broom != nullptr ? broom->lines_per_scan : array.lines;
}

/// @param trim  how much less on each side, in pixels
Corners corners(const DetectorArray& array, const Module* module, double trim) {
  const bool column = std::holds_alternative<Whiskbroom>(array.timing.scan);
  double left = module != nullptr ? module->first_sample : 0.0;
  double right = module != nullptr ? left + module->samples : array.samples;
  if (column) {
    left = 0.5 * array.samples - 0.5;
    right = left + 1.0;
  }
  const double half_m = (0.5 * rows_of(array) - trim) * array.height_m();
  const auto at = [&](double c, double row_m) { return focal_place(array, module, {c, row_m}); };
  return {at(left + trim, -half_m), at(right - trim, -half_m), at(right - trim, half_m),
          at(left + trim, half_m)};
}

std::vector<Corners> pieces(const DetectorArray& array, double trim) {
  std::vector<Corners> all;
  for (const Module& module : array.modules) all.push_back(corners(array, &module, trim));
  if (all.empty()) all.push_back(corners(array, nullptr, trim));
  return all;
}

struct Reach {
  double low = 0.0, high = 0.0;
};

Reach reach_along(const Corners& piece, Vec2 axis) {
  Reach reach{1e300, -1e300};
  for (const Vec2 corner : piece) {
    const double place = corner.x * axis.x + corner.y * axis.y;
    reach = {std::min(reach.low, place), std::max(reach.high, place)};
  }
  return reach;
}

// Rectangles are apart where a side of one of them divides them.
bool divided_by_side(const Corners& a, const Corners& b) {
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec2 side{a[i + 1].x - a[i].x, a[i + 1].y - a[i].y};
    const Reach one = reach_along(a, side), other = reach_along(b, side);
    if (one.high <= other.low || other.high <= one.low) return true;
  }
  return false;
}

bool overlap(const Corners& a, const Corners& b) {
  return !divided_by_side(a, b) && !divided_by_side(b, a);
}

// What lies edge to edge, or is turned by a trifle, shall pass.
constexpr double trim_px = 0.05;

void check_module_places(const DetectorArray& array) {
  const auto all = pieces(array, trim_px);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      require_array(!overlap(all[i], all[k]), "modules " + std::to_string(i + 1) + " and " +
                                                  std::to_string(k + 1) +
                                                  " overlap on the focal plane");
    }
  }
}

void check_projection(const DetectorArray& array, const Perspective& lens) {
  require_array(above_zero(lens.focal_length_m), "the focal length must be above 0 m");
  double reach_m = 0.0;
  for (const Corners& piece : pieces(array, 0.0)) {
    for (const Vec2 corner : piece) reach_m = std::max(reach_m, std::hypot(corner.x, corner.y));
  }
  check(lens.distortion, reach_m / lens.focal_length_m);
}

void check_projection(const DetectorArray&, const Orthographic&) {}

void check_projection(const DetectorArray& array, const Tabulated& table) {
  require_array(table != nullptr, "an array's view table is missing");
  require_array(array.modules.empty() && array.offset_x_m == 0.0 && array.offset_y_m == 0.0,
                "a view table holds the places of all pixels: it takes no offset and no modules");
  // A thousandth of a pixel: steps are printed with few digits.
  const auto covers = [](int nodes, double step, int pixels) {
    return std::abs((nodes - 1) * step - (pixels - 1)) <= 1e-3;
  };
  require_array(covers(table->samples, table->sample_step, array.samples),
                "the view table ends at sample " +
                    number_text((table->samples - 1) * table->sample_step + 0.5) +
                    ", the array's last is " + number_text(array.samples - 0.5));
  const bool broom = std::holds_alternative<Pushbroom>(array.timing.scan);
  require_array(!broom || table->lines == 1, "the view table of a pushbroom has one line");
  require_array(broom || covers(table->lines, table->line_step, array.lines),
                "the view table ends at line " +
                    number_text((table->lines - 1) * table->line_step + 0.5) +
                    ", the array's last is " + number_text(array.lines - 0.5));
}

}  // namespace

void check(const DetectorArray& array) {
  check_sizes(array);
  check_timing(array);
  check_module_samples(array);
  check_module_places(array);
  std::visit([&](const auto& projection) { check_projection(array, projection); },
             array.projection);
}

void check_apart(const std::vector<DetectorArray>& arrays) {
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    for (std::size_t k = i + 1; k < arrays.size(); ++k) {
      for (const Corners& one : pieces(arrays[i], trim_px)) {
        for (const Corners& other : pieces(arrays[k], trim_px)) {
          require_array(!overlap(one, other), "arrays \"" + arrays[i].name + "\" and \"" +
                                                  arrays[k].name + "\" overlap on the focal plane");
        }
      }
    }
  }
}

}  // namespace nadir::sensor
