#include "geometry/earth.hpp"

#include <GeographicLib/Geocentric.hpp>
#include <cmath>
#include <vector>

#include "core/error.hpp"

namespace nadir::geometry {
namespace {

const GeographicLib::Geocentric& wgs84() { return GeographicLib::Geocentric::WGS84(); }

Vec3 ecef_of(const Geodetic& place) {
  Vec3 ecef;
  wgs84().Forward(place.latitude_deg, place.longitude_deg, place.height_m, ecef.x, ecef.y, ecef.z);
  return ecef;
}

/// Columns: east, north and up at `place`, in ECEF.
Mat3 axes_in_ecef(const Geodetic& place) {
  Vec3 ecef;
  std::vector<double> rows(9);
  wgs84().Forward(place.latitude_deg, place.longitude_deg, place.height_m, ecef.x, ecef.y, ecef.z,
                  rows);
  return {{rows[0], rows[3], rows[6]}, {rows[1], rows[4], rows[7]}, {rows[2], rows[5], rows[8]}};
}

}  // namespace

LocalFrame::LocalFrame(const Geodetic& origin) : origin_{origin} {
  if (!(std::abs(origin.latitude_deg) <= 90.0)) {
    throw InputError{"the latitude of the scene's origin must lie in [-90, 90] degrees"};
  }
  if (!std::isfinite(origin.longitude_deg) || !std::isfinite(origin.height_m)) {
    throw InputError{"the longitude and height of the scene's origin must be finite"};
  }
  origin_ecef_ = ecef_of(origin);
  axes_ = axes_in_ecef(origin);
}

Vec3 LocalFrame::enu(const Geodetic& place) const { return enu_from_ecef(ecef_of(place)); }

Geodetic LocalFrame::geodetic(Vec3 enu) const {
  const Vec3 p = ecef(enu);
  Geodetic place;
  wgs84().Reverse(p.x, p.y, p.z, place.latitude_deg, place.longitude_deg, place.height_m);
  return place;
}

Vec3 LocalFrame::ecef(Vec3 enu) const { return origin_ecef_ + axes_ * enu; }

Vec3 LocalFrame::enu_from_ecef(Vec3 ecef) const {
  return axes_.transposed() * (ecef - origin_ecef_);
}

Mat3 LocalFrame::axes_at(const Geodetic& place) const {
  return axes_.transposed() * axes_in_ecef(place);
}

}  // namespace nadir::geometry
