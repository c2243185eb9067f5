#pragma once

#include <variant>

namespace nadir::thermal {

/// Heat that moving air takes: q = h (T_air - T_surface). Each law says h.

/// How rough a surface is, for the correlations that ask.
enum class Roughness { very_rough, rough, medium_rough, medium_smooth, smooth, very_smooth };

/// The same always.
struct FixedFilm {
  double film_w_m2_k = 10.0;
};
/// h = 5.7 + 3.8 V up to 5 m/s, 6.47 V^0.78 above: McAdams, "Heat Transmission" (1954). Where the
/// second falls short of what the first gives at 5 m/s (up to 5.6 m/s), that value stands.
struct McAdams {};
/// h = D + E V + F V^2 by roughness (ASHRAE 1989, figure 1 of chapter 22, as EnergyPlus'
/// "SimpleCombined"), less the radiation that it contains: 4 eps sigma T^3 with eps = 0.9 and
/// T = 293 K, 5.1 W m^-2 K^-1. Beyond the wind at which the quadratic form is largest it stays
/// there (35 m/s medium smooth, 46 m/s very smooth).
struct SimpleByRoughness {
  Roughness roughness = Roughness::medium_rough;
};
/// Natural and forced together: TARP (Walton 1983), natural convection by tilt and by whether the
/// surface is warmer than the air, forced by wind and roughness, for a surface of 10 m x 10 m. The
/// wind's direction counts as its mean over all directions.
struct Tarp {
  Roughness roughness = Roughness::medium_rough;
};
using Convection = std::variant<FixedFilm, McAdams, SimpleByRoughness, Tarp>;

/// What a law of convection needs to know of the moment and the surface.
struct AirFlow {
  double wind_m_s = 0.0;
  double cos_tilt = 1.0;  ///< of the surface's normal against up: 1 level, 0 wall, -1 ceiling
};

/// The part of h that does not depend on the surface's temperature, and the factor of
/// |T_surface - T_air|^(1/3) beside it: h = forced + natural |dT|^(1/3), by sign of dT.
struct Film {
  double forced_w_m2_k = 0.0;
  double natural_warm_w_m2_k43 = 0.0;  ///< surface warmer than the air
  double natural_cold_w_m2_k43 = 0.0;

  [[nodiscard]] double at(double surface_minus_air_k) const noexcept;
};
/// The forced part is a function of the wind times one of the tilt: who has the film of level
/// ground in every wind and that of a tilt in one wind has them all.
[[nodiscard]] Film film(const Convection& law, const AirFlow& flow) noexcept;

}  // namespace nadir::thermal
