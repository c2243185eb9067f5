#include "sensor/camera/timing.hpp"

#include "support/catch.hpp"

namespace nadir::sensor {
namespace {

// Sums of a few doubles of this size: 1e-15 or so.
constexpr double rounding_s = 1e-12;

void check_span(const Timing& timing, double first_s, double last_s) {
  const TimeSpan all = span(timing, 100, 60);
  CHECK(all.first_s == Approx(first_s).margin(rounding_s));
  CHECK(all.last_s == Approx(last_s).margin(rounding_s));
}

TEST_CASE("a camera that takes all at a moment needs that moment alone", "[sensor][timing]") {
  check_span({}, 0.0, 0.0);
  check_span({.scan = GlobalShutter{3.0}}, 3.0, 3.0);
}

TEST_CASE("an exposure lies about its centre", "[sensor][timing]") {
  check_span({.scan = GlobalShutter{3.0}, .exposure_s = 0.5}, 2.75, 3.25);
}

TEST_CASE("lines are exposed one after the other, from half a period before the first centre",
          "[sensor][timing]") {
  check_span({.scan = Pushbroom{10.0, 0.1}, .exposure_s = 0.08}, 9.95, 15.95);
  check_span({.scan = RollingShutter{10.0, 0.1}, .exposure_s = 0.08}, 9.95, 15.95);
  // Rolling shutters may be open for longer than a line's period.
  check_span({.scan = RollingShutter{10.0, 0.1}, .exposure_s = 0.5}, 9.75, 16.15);
}

TEST_CASE("time-delay integration looks ahead and back by half its stages", "[sensor][timing]") {
  check_span({.scan = Pushbroom{0.0, 0.1}, .tdi_stages = 5}, -0.25, 6.15);
  check_span({.scan = Pushbroom{0.0, 0.1}, .tdi_stages = 5, .tdi_reversed = true}, -0.25, 6.15);
}

TEST_CASE("a bolometer remembers twelve time constants", "[sensor][timing]") {
  check_span({.scan = GlobalShutter{1.0}, .lag_s = 0.01}, 0.88, 1.0);
}

TEST_CASE("a whiskbroom sweeps for every lines_per_scan lines", "[sensor][timing]") {
  // Six sweeps of ten lines, the last begins at 5 + 5 x 2.
  check_span({.scan = Whiskbroom{5.0, 0.01, 2.0, 10}}, 4.995, 5.0 + 10.0 + 0.995);
}

}  // namespace
}  // namespace nadir::sensor
