#pragma once

#include <vector>

#include "atmosphere/make/path_light.hpp"
#include "atmosphere/make/view_paths.hpp"
#include "atmosphere/table/air_table.hpp"

namespace nadir::atmosphere {

/// A view's axes and lines of sight.
struct ViewShape {
  double height_m = 0.0;
  bool whole = false;  ///< radiances are whole: the sky
  std::vector<double> zenith_rad, azimuth_rad, share;
  std::vector<ViewPath> paths;  ///< by zenith

  [[nodiscard]] std::size_t places() const { return zenith_rad.size() * share.size(); }
};

/// @param night  whether light from outside the air is seen: what ends just before the end of the
///               way then needs a node of its own
[[nodiscard]] ViewShape view_shape(const Shells& shells, const AirSettings& settings,
                                   double height_m, bool night);
[[nodiscard]] ViewShape sky_shape(const Shells& shells, const AirSettings& settings);

/// One lane of a view, in the order of the table's arrays.
struct LaneView {
  std::vector<float> extinction, even, night, ground, first, smooth;
};

/// @param bodies  of the table, among them those of the fields
[[nodiscard]] LaneView lane_view(const LaneFields& fields, const ViewShape& shape,
                                 std::size_t bodies);

/// What reaches a path's far end from outside, straight: the night sky in its direction.
[[nodiscard]] double night_beyond(const LaneFields& fields, const ViewPath& path) noexcept;

}  // namespace nadir::atmosphere
