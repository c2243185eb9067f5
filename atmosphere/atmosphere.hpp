#pragma once

#include <variant>

#include "core/quantity.hpp"
#include "core/vec.hpp"
#include "spectral/curve.hpp"
#include "spectral/lanes.hpp"

namespace nadir::atmosphere {

/// No air: the sky is black, nothing is lost on any path.
struct None {};

/// The same air along every path and in every direction; below the horizon, where a ray may leave a
/// scene of finite extent, the sky is as bright as above.
struct Uniform {
  spectral::Curve sky_radiance;         ///< W m^-2 sr^-1 um^-1, from every direction of the sky
  Kelvin sky_temperature;               ///< a black sky of this temperature is added; 0 K: none
  spectral::Curve solar_transmittance;  ///< from sun or moon to a surface, in [0, 1]
  spectral::Curve transmittance;        ///< from a surface to the sensor, in [0, 1]
  spectral::Curve path_radiance;        ///< scattered into that path, W m^-2 sr^-1 um^-1
  Kelvin air_temperature;               ///< the path emits (1 - transmittance) B(T); 0 K: nothing
};

/// What the user describes. The full model of the air will be one more alternative.
using Atmosphere = std::variant<None, Uniform>;

/// What a path through the air does to the radiance L at its far end: transmittance * L + path.
struct PathTerms {
  spectral::Spectrum transmittance;
  spectral::Spectrum radiance;
};

/// An atmosphere at the wavelengths of one block of lanes: what rays look up.
class BoundAtmosphere {
 public:
  /// @throws InputError where a curve does not cover the lanes
  BoundAtmosphere(const Atmosphere& atmosphere, const spectral::Lanes& lanes);

  /// Radiance that arrives at a surface from a direction of the open sky, without the discs of sun
  /// and moon. `direction_enu` points away from the surface.
  [[nodiscard]] spectral::Spectrum sky(Vec3 direction_enu) const noexcept;
  /// Share of a body's irradiance that reaches a surface.
  [[nodiscard]] spectral::Spectrum direct_transmittance(Vec3 direction_enu) const noexcept;
  /// The path from a surface to the sensor, `length_m` long.
  [[nodiscard]] PathTerms path(Vec3 direction_enu, double length_m) const noexcept;

 private:
  spectral::Spectrum sky_;
  spectral::Spectrum direct_;
  PathTerms path_;
};

}  // namespace nadir::atmosphere
