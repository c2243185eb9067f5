#pragma once

#include "core/transform.hpp"
#include "core/vec.hpp"

namespace nadir::geometry {

/// A place on or above the WGS84 ellipsoid.
struct Geodetic {
  double latitude_deg = 0.0;   ///< in [-90, 90]
  double longitude_deg = 0.0;  ///< east positive
  double height_m = 0.0;       ///< above the ellipsoid
};

/// The scene's axes: east, north and up at an origin at its height above the WGS84 ellipsoid, m.
/// Computed by GeographicLib (round trip bounded by a few nanometres near the earth).
class LocalFrame {
 public:
  /// @throws InputError for a latitude outside [-90, 90] or anything that is not finite.
  explicit LocalFrame(const Geodetic& origin);

  [[nodiscard]] Vec3 enu(const Geodetic& place) const;
  [[nodiscard]] Geodetic geodetic(Vec3 enu) const;
  [[nodiscard]] Vec3 ecef(Vec3 enu) const;
  [[nodiscard]] Vec3 enu_from_ecef(Vec3 ecef) const;
  /// Columns: the east, north and up axes of `place`, in scene axes.
  [[nodiscard]] Mat3 axes_at(const Geodetic& place) const;
  [[nodiscard]] const Geodetic& origin() const noexcept { return origin_; }

 private:
  Geodetic origin_;
  Vec3 origin_ecef_;
  Mat3 axes_;  ///< columns: east, north and up at the origin, in ECEF
};

}  // namespace nadir::geometry
