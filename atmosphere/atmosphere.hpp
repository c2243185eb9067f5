#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "atmosphere/air_parts.hpp"
#include "atmosphere/path_terms.hpp"
#include "atmosphere/table/air_table.hpp"
#include "atmosphere/table/bound_air_table.hpp"
#include "core/quantity.hpp"
#include "core/vec.hpp"
#include "spectral/curve.hpp"
#include "spectral/lanes.hpp"

namespace nadir::atmosphere {

/// No air: the sky is black, nothing is lost on any path.
struct None {};

/// How a sky's radiance is spread over the dome. Either way a level surface gets pi times the
/// stated sky radiance.
enum class SkyShape {
  even,     ///< alike in all directions
  overcast  ///< L = 3/7 (1 + 2 cos z) L_sky: the standard overcast sky, three times as bright in
            ///< the zenith as at the horizon. Source: Moon & Spencer, Illum. Eng. 37, 707 (1942);
            ///< CIE S 011 (2003). Below the horizon as at the horizon.
};

/// The same air along every path; below the horizon, where a ray may leave a scene of finite
/// extent, an even sky is as bright as above.
struct Uniform {
  spectral::Curve sky_radiance;         ///< W m^-2 sr^-1 um^-1, from every direction of the sky
  Kelvin sky_temperature;               ///< a black sky of this temperature is added; 0 K: none
  spectral::Curve solar_transmittance;  ///< from sun or moon to a surface, in [0, 1]
  spectral::Curve transmittance;        ///< from a surface to the sensor, in [0, 1]
  spectral::Curve path_radiance;        ///< scattered into that path, W m^-2 sr^-1 um^-1
  Kelvin air_temperature;               ///< the path emits (1 - transmittance) B(T); 0 K: nothing
  SkyShape sky_shape = SkyShape::even;  ///< of sky_radiance; the sky's emission is always even
};

/// Air whose light was computed, or measured, beforehand, and the ground that lights it from below.
struct Tabulated {
  std::shared_ptr<const AirTable> table;
  GroundLight ground;
};

/// The air as the radiometry solvers take it.
using Atmosphere = std::variant<None, Uniform, Tabulated>;

/// An atmosphere at the wavelengths of one block of lanes: what rays look up.
class BoundAtmosphere {
 public:
  /// @param parts  what is wanted: the rest is as without air. What the sensor sees beyond the
  ///               scene is part of its line of sight
  /// @throws InputError where a curve that is wanted does not cover the lanes
  BoundAtmosphere(const Atmosphere& atmosphere, const spectral::Lanes& lanes,
                  const AirParts& parts = {});

  /// Radiance that arrives at a surface from a direction of the open sky, without the discs of sun
  /// and moon. `direction_enu` points away from the surface.
  [[nodiscard]] spectral::Spectrum sky(Vec3 direction_enu) const noexcept;
  /// Whether the sky is alike in all directions.
  [[nodiscard]] bool even_sky() const noexcept { return even_sky_; }
  /// Share of a body's irradiance that reaches a surface.
  [[nodiscard]] spectral::Spectrum direct_transmittance(Vec3 direction_enu) const noexcept;
  /// Share of a body's radiance that reaches the sensor's eye when it looks at the disc itself:
  /// that of what air lies before it there, nothing of it where the ray misses the air. Scene axes.
  [[nodiscard]] spectral::Spectrum disc_transmittance(Vec3 eye, Vec3 direction) const noexcept;
  /// The way from the sensor's eye to a surface, `length_m` along a unit direction; scene axes.
  [[nodiscard]] PathTerms path(Vec3 eye, Vec3 direction, double length_m) const noexcept;
  /// What arrives at the sensor's eye from a direction in which it sees nothing of the scene.
  [[nodiscard]] spectral::Spectrum beyond(Vec3 eye, Vec3 direction) const noexcept;

 private:
  /// The light of uniform air's sky.
  struct Dome {
    spectral::Spectrum even;    // that part of it
    spectral::Spectrum shaped;  // part that follows the sky's shape, where that is not even
    [[nodiscard]] spectral::Spectrum towards(Vec3 direction, SkyShape shape) const noexcept;
  };
  void bind(const Uniform& air, const spectral::Lanes& lanes, const AirParts& parts);

  Dome sky_, beyond_;  // as surfaces see it, and the sensor
  SkyShape shape_ = SkyShape::even;
  bool even_sky_ = true, loses_ = true;  // loses_: on the line of sight
  spectral::Spectrum direct_;
  PathTerms path_;
  std::optional<BoundAirTable> table_;  // in place of all others
  bool views_ = false;                  // the table knows the air before the sensor
};

}  // namespace nadir::atmosphere
