#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/earth.hpp"
#include "sensor/detector/figures.hpp"
#include "sensor/optics/system_mtf.hpp"
#include "sim/products/line_plot.hpp"
#include "sim/run/camera.hpp"

namespace nadir::sim {

/// What a camera looks at on its data sheet: the earth's ellipsoid, raised so that the camera is at
/// the nominal height over it.
struct SheetGround {
  geometry::LocalFrame frame{geometry::Geodetic{45.0, 0.0, 0.0}};  ///< of the scene's axes
  double height_m = 0.0;  ///< of the camera over the ground, > 0
  /// Of the place that a camera that stands still looks at, along image down; 0: not known, then
  /// lines of a pushbroom are taken to fit its motion.
  double ground_speed_m_s = 0.0;
};

/// How fast what a detector looks at moves over the ground, in pixels; + along growing samples and
/// lines.
struct ImageMotion {
  double x_px_s = 0.0, y_px_s = 0.0;
};

struct BandSheet {
  sensor::BandFigures figures;
  sensor::SystemMtf mtf_x, mtf_y;
  double exposure_s = 0.0;
  ImageMotion motion;
};

/// A camera's data sheet. What cannot be told (lines of sight that miss the ground) is NaN.
struct SensorSheet {
  std::string instrument, platform, title, source;
  double height_m = 0.0;
  double ground_speed_m_s = 0.0;  ///< of what the first array looks at
  std::vector<BandSheet> bands;
};

/// @throws InputError for figures out of range, naming array and band, and a height that is not
///         positive
[[nodiscard]] SensorSheet sensor_sheet(const Camera& camera, const SheetGround& ground);

/// A table for people.
[[nodiscard]] std::string sheet_text(const SensorSheet& sheet);
/// JSON, units in the names; null for what cannot be told.
[[nodiscard]] std::string sheet_json(const SensorSheet& sheet);
/// Modulation transfer to one cycle a pixel, across and along; the terms of one band are dashed.
/// @param band  whose terms are shown, "array/band" or its name; empty: the first one
/// @throws InputError for a band that is not there
[[nodiscard]] LinePlot mtf_plot(const SensorSheet& sheet, const std::string& band);

}  // namespace nadir::sim
