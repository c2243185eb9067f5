#pragma once

#include "thermal/conduction/column.hpp"
#include "thermal/surface/convection.hpp"

namespace nadir::thermal {

/// The balance of a surface, all fluxes in W m^-2 and positive into it:
///
///     q(T) = a (E_direct + E_diffuse + E_reflected) + eps (E_sky + E_surroundings - sigma T^4)
///            + h(T) (T_air - T) + w h_v(T) / gamma (e_air - e_s(T))
///
/// h from convection.hpp, e_s and gamma from humidity.hpp, w the wetness. h_v, the film as vapour
/// meets it, is h with natural convection at no less than 1 K: moist air is lighter, and vapour
/// over water as warm as the air drives as much. It is h over warmer evaporating and under cooler
/// dewy surfaces, and otherwise this least film; so q falls with T everywhere.

/// What a surface exchanges with light, air and surroundings.
struct SurfaceProperties {
  double solar_absorptance = 0.7;  ///< of sunlight, 1 - rho - tau
  double emissivity = 0.95;        ///< hemispherical, long-wave; its absorptance as well
  Convection convection = Tarp{};
  double wind_factor = 1.0;  ///< wind at the surface over the station's
  double wetness = 0.0;      ///< 0 dry to 1 open water: share of potential evaporation
};

/// What reaches a surface at one moment, all that does not depend on its own temperature.
struct SurfaceLoad {
  double direct_w_m2 = 0.0;     ///< sun, on the surface, shadow and cosine counted
  double diffuse_w_m2 = 0.0;    ///< sky's sunlight, on the surface
  double reflected_w_m2 = 0.0;  ///< sunlight by way of the surroundings
  double sky_long_wave_w_m2 = 0.0;
  double surroundings_long_wave_w_m2 = 0.0;
  double air_k = 288.15;
  double vapour_pressure_hpa = 10.0;
  double pressure_hpa = 1013.25;
  Film film;
};

/// The terms of the balance, all W m^-2, positive into the surface.
struct BalanceTerms {
  double direct = 0.0, diffuse = 0.0, reflected = 0.0;       ///< absorbed
  double sky_long_wave = 0.0, surroundings_long_wave = 0.0;  ///< absorbed
  double emitted = 0.0;                                      ///< <= 0
  double convected = 0.0;
  double evaporated = 0.0;  ///< evaporation < 0, dew > 0

  [[nodiscard]] double sum() const noexcept {
    return direct + diffuse + reflected + sky_long_wave + surroundings_long_wave + emitted +
           convected + evaporated;
  }
};
[[nodiscard]] BalanceTerms balance(const SurfaceProperties& surface, const SurfaceLoad& load,
                                   double temperature_k) noexcept;

/// The same balance prepared for a Newton iteration: what does not depend on T summed once. Its sum
/// equals that of balance() to rounding. The flux never grows with T.
class BalanceAt {
 public:
  BalanceAt(const SurfaceProperties& surface, const SurfaceLoad& load) noexcept;
  /// A sheet open on both sides, of one temperature: the sum of the balances of its two sides,
  /// which lie in the same air (temperature, vapour and pressure are those of `front`).
  BalanceAt(const SurfaceProperties& surface, const SurfaceLoad& front,
            const SurfaceLoad& back) noexcept;

  [[nodiscard]] SurfaceFlux operator()(double temperature_k) const noexcept;

 private:
  double absorbed_w_m2_ = 0.0;     // light and long-wave
  double emission_w_m2_k4_ = 0.0;  // emissivity sigma, of both sides if there are two
  double air_k_ = 0.0;
  double vapour_pressure_hpa_ = 0.0;
  double wetness_per_gamma_k_hpa_ = 0.0;
  Film film_;
};

}  // namespace nadir::thermal
