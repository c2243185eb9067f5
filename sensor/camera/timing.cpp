#include "sensor/camera/timing.hpp"

#include <algorithm>

namespace nadir::sensor {
namespace {

// Centres of the first and the last exposure, the time from one to the next, and from stage to
// stage of the time-delay integration.
struct Centres {
  double first_s = 0.0, last_s = 0.0, period_s = 0.0, stage_s = 0.0;
};

Centres centres(const GlobalShutter& shutter, int, int) {
  return {shutter.centre_s, shutter.centre_s};
}

Centres centres(const RollingShutter& shutter, int, int lines) {
  return {shutter.first_line_s, shutter.first_line_s + (lines - 1) * shutter.line_period_s,
          shutter.line_period_s};
}

Centres centres(const Pushbroom& broom, int, int lines) {
  return {broom.first_line_s, broom.first_line_s + (lines - 1) * broom.line_period_s,
          broom.line_period_s, broom.line_period_s};
}

Centres centres(const Whiskbroom& broom, int samples, int lines) {
  const int scans = (lines + broom.lines_per_scan - 1) / broom.lines_per_scan;
  return {broom.first_sample_s,
          broom.first_sample_s + (scans - 1) * broom.scan_period_s +
              (samples - 1) * broom.sample_period_s,
          broom.sample_period_s};
}

}  // namespace

TimeSpan span(const Timing& timing, int samples, int lines) noexcept {
  const Centres all =
      std::visit([&](const auto& scan) { return centres(scan, samples, lines); }, timing.scan);
  // The image begins half a pixel before the first pixel's centre.
  const double around =
      0.5 * std::max(timing.exposure_s, all.period_s) + 0.5 * (timing.tdi_stages - 1) * all.stage_s;
  return {all.first_s - around - most_lags * timing.lag_s, all.last_s + around};
}

}  // namespace nadir::sensor
