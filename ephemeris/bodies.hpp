#pragma once

#include <optional>
#include <string>

#include "core/quantity.hpp"
#include "ephemeris/eclipse.hpp"
#include "ephemeris/illumination.hpp"
#include "ephemeris/sun_moon.hpp"
#include "spectral/curve.hpp"

namespace nadir::ephemeris {

/// The sun as a source: E(lambda) = E_1au(lambda) / d^2, with d the distance in au, times what an
/// eclipse leaves of it.
///
/// The direction is without refraction. A sun below the horizon is a source too: what stands
/// above the horizon is for whoever has the scene to say. An eclipsed body keeps its whole disc, of
/// the radiance that makes its irradiance right.
/// @param irradiance_1au  solar irradiance at 1 au, W m^-2 um^-1
/// @throws InputError where a value of the curve is negative
[[nodiscard]] LightSource sun_light(const BodyPosition& sun, const spectral::Curve& irradiance_1au,
                                    const Eclipse& eclipse = {});

/// The moon as a source of a given brightness.
/// @param irradiance  outside the air at the site, at this phase and distance, W m^-2 um^-1
/// @param eclipse     what the irradiance does not know of
/// @throws InputError where a value of the curve is negative
[[nodiscard]] LightSource moon_light(const BodyPosition& moon, const spectral::Curve& irradiance,
                                     const Eclipse& eclipse = {});

/// Both: the sun, eclipsed or not, and the moon where its irradiance is given, as it is given.
[[nodiscard]] Illumination illumination(const SunAndMoon& positions,
                                        const spectral::Curve& solar_irradiance_1au,
                                        const std::optional<spectral::Curve>& moon_irradiance = {});

/// A body put at a place in the sky by hand.
struct FixedBody {
  std::string name;
  Angle azimuth;         ///< clockwise from north, finite
  Angle elevation;       ///< -pi/2 to pi/2
  Angle angular_radius;  ///< > 0, < pi/2
};

/// @param irradiance  on a plane normal to the direction, outside the air, W m^-2 um^-1
/// @throws InputError that names every value outside its range
[[nodiscard]] LightSource fixed_light(const FixedBody& body, const spectral::Curve& irradiance);

}  // namespace nadir::ephemeris
