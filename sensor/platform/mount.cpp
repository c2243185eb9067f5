#include "sensor/platform/mount.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::sensor {
namespace {

Mat3 law_axes(const FixedMount& /*law*/, const Pose& rest, double /*time_s*/) { return rest.axes; }

Mat3 law_axes(const ScanMount& law, const Pose& rest, double time_s) {
  return rest.axes * rotation(law.axis, scan_angle(law, time_s));
}

Mat3 law_axes(const StareMount& law, const Pose& rest, double /*time_s*/) {
  const Vec3 offset = law.target - rest.position;
  const double distance = length(offset);
  if (!(distance > 0.0)) return rest.axes;
  const Vec3 z = offset / distance;
  const Vec3 x = rest.axes.x - z * dot(rest.axes.x, z);
  // Along the x axis no x is nearer than another, but y can stay as it is.
  if (length(x) < 1e-9) {
    const Vec3 y = normalised(rest.axes.y - z * dot(rest.axes.y, z));
    return {cross(y, z), y, z};
  }
  const Vec3 unit_x = normalised(x);
  return {unit_x, cross(z, unit_x), z};
}

void check_law(const FixedMount& /*law*/) {}

void check_law(const ScanMount& scan) {
  if (!(std::abs(length(scan.axis) - 1.0) <= 1e-9)) {
    throw InputError{"the axis of a scanning mount must be of length 1"};
  }
  if (!is_finite({scan.first_rad, scan.last_rad, scan.start_s})) {
    throw InputError{"angles and start of a scanning mount must be finite"};
  }
  if (!(scan.sweep_s > 0.0 && std::isfinite(scan.sweep_s))) {
    throw InputError{"the sweep of a scanning mount must take more than 0 s, not " +
                     number_text(scan.sweep_s) + " s"};
  }
  if (!(scan.period_s >= scan.sweep_s && std::isfinite(scan.period_s))) {
    throw InputError{"the period of a scanning mount, " + number_text(scan.period_s) +
                     " s, is shorter than its sweep, " + number_text(scan.sweep_s) + " s"};
  }
}

void check_law(const StareMount& stare) {
  if (!is_finite(stare.target)) throw InputError{"the target of a mount must be finite"};
}

}  // namespace

double scan_angle(const ScanMount& scan, double time_s) noexcept {
  const double periods = (time_s - scan.start_s) / scan.period_s;
  const double begun = std::floor(periods);
  const double share = (periods - begun) * scan.period_s / scan.sweep_s;
  if (scan.motion == ScanMount::Motion::sweep) {
    // Compared with room for rounding, so that a sweep that fills its period has no dead moment.
    if (share > 1.0 + 1e-12) return scan.first_rad;
    return scan.first_rad + std::min(share, 1.0) * (scan.last_rad - scan.first_rad);
  }
  const bool back = begun - 2.0 * std::floor(0.5 * begun) > 0.5;
  const double from = back ? scan.last_rad : scan.first_rad;
  const double to = back ? scan.first_rad : scan.last_rad;
  return from + std::min(share, 1.0) * (to - from);
}

Pose carried(const Pose& carrier, const Mount& mount, double time_s) noexcept {
  const Pose rest{carrier.position + carrier.axes * mount.offset_m, carrier.axes * mount.axes};
  return {rest.position,
          std::visit([&](const auto& law) { return law_axes(law, rest, time_s); }, mount.law)};
}

void check(const Mount& mount) {
  if (!is_finite(mount.offset_m)) throw InputError{"the offset of a mount must be finite"};
  const Mat3 square = mount.axes.transposed() * mount.axes;
  const double off = length(square.x - Vec3{1.0, 0.0, 0.0}) +
                     length(square.y - Vec3{0.0, 1.0, 0.0}) +
                     length(square.z - Vec3{0.0, 0.0, 1.0});
  if (!(off <= 1e-6 && mount.axes.determinant() > 0.0)) {
    throw InputError{"the axes of a mount must be orthonormal and right-handed"};
  }
  std::visit([](const auto& law) { check_law(law); }, mount.law);
}

}  // namespace nadir::sensor
