#pragma once

#include <variant>

namespace nadir::sensor {

// When a detector array sees what. Times are seconds after the scenario's.

/// All pixels at once.
struct GlobalShutter {
  double centre_s = 0.0;  ///< of the exposure
};
/// Line after line of the same frame.
struct RollingShutter {
  double first_line_s = 0.0;  ///< centre of the exposure of line 0
  double line_period_s = 0.0;
};
/// One row of detectors; lines of the image come by the platform's motion.
struct Pushbroom {
  double first_line_s = 0.0;  ///< centre of the exposure of line 0
  double line_period_s = 0.0;
};
/// A column of detectors that a mirror (a ScanMount) sweeps across: samples come by its motion,
/// `lines_per_scan` lines at a time.
struct Whiskbroom {
  double first_sample_s = 0.0;  ///< centre of the exposure of sample 0 of the first sweep
  double sample_period_s = 0.0;
  double scan_period_s = 0.0;  ///< from sweep to sweep
  int lines_per_scan = 1;
};

struct Timing {
  std::variant<GlobalShutter, RollingShutter, Pushbroom, Whiskbroom> scan = GlobalShutter{};
  double exposure_s = 0.0;  ///< length; 0: a moment
  /// Time constant of detectors that have no shutter (bolometers): the signal read out at a moment
  /// weights what came before by exp(-age / lag). 0: none; excludes an exposure.
  double lag_s = 0.0;
  /// Rows that add up the same ground by time-delay integration; 1: none. Rows lie towards +y (they
  /// see the ground first), or towards -y with tdi_reversed.
  int tdi_stages = 1;
  bool tdi_reversed = false;
  /// Nothing moves while light is gathered: all of it counts as of the middle of the exposure (of
  /// lag: as of the moment of reading) and of the rows. How much light there is does not change.
  bool still = false;
};

/// Lag reaches back so many time constants and no further: what came before them weighs
/// exp(-12) = 6e-6 of all, and is taken at that age.
inline constexpr double most_lags = 12.0;

/// The first and the last moment that an array of so many samples and lines can ask for.
struct TimeSpan {
  double first_s = 0.0, last_s = 0.0;
};
/// @param samples, lines  of the image
[[nodiscard]] TimeSpan span(const Timing& timing, int samples, int lines) noexcept;

}  // namespace nadir::sensor
