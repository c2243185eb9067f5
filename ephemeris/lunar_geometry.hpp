#pragma once

#include "core/quantity.hpp"
#include "core/vec.hpp"
#include "ephemeris/time_scales.hpp"

namespace nadir::ephemeris {

/// A point of the moon, east and north positive; 0, 0 is the mean middle of the side that faces
/// the earth.
struct Selenographic {
  Angle longitude;  ///< -pi to pi
  Angle latitude;
};

/// What the moon's brightness depends on: where on it sun and observer stand overhead, how far
/// they are. The sun's longitude is positive while the moon waxes.
struct LunarGeometry {
  Angle phase;  ///< sun - moon - observer, at the moon
  Selenographic sun;
  Selenographic observer;
  Metres sun_distance;       ///< from the moon
  Metres observer_distance;  ///< from the moon's centre
};

/// The point of the moon over which a direction points outwards, in the mean earth / polar axis
/// system.
///
/// Source: IAU Working Group on Cartographic Coordinates and Rotational Elements (Archinal et al.
/// 2011, doi:10.1007/s10569-010-9320-4, table 2): pole and prime meridian with 13 periodic terms,
/// optical and the greater part of physical libration. Accuracy: some 150 m on the moon, 0.005
/// degrees (their text); 0.02 degrees allowed for.
/// @param from_moon  on the axes of the ICRS, any length
[[nodiscard]] Selenographic selenographic(Vec3 from_moon, TtDate tt) noexcept;

/// @param moon_to_sun, moon_to_observer  metres, on the axes of the ICRS
[[nodiscard]] LunarGeometry lunar_geometry(Vec3 moon_to_sun, Vec3 moon_to_observer,
                                           TtDate tt) noexcept;

}  // namespace nadir::ephemeris
