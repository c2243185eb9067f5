#pragma once

namespace nadir::ephemeris {

/// Where an observer stands on the WGS84 ellipsoid.
struct Site {
  double latitude_deg = 0.0;   ///< geodetic, north positive, -90 to 90
  double longitude_deg = 0.0;  ///< east positive, -180 to 360
  double height_m = 0.0;       ///< above the ellipsoid, -12 km to 1000 km
};

/// The site itself.
/// @throws InputError that names every coordinate outside its range
[[nodiscard]] Site checked(const Site& site);

}  // namespace nadir::ephemeris
