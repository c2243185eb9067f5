#include "thermal/surface/convection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/constants.hpp"

namespace nadir::thermal {
namespace {

template <class Value>
using ByRoughness = std::array<Value, 6>;  // in the order of Roughness: very rough first

template <class Value>
Value for_roughness(const ByRoughness<Value>& table, Roughness roughness) noexcept {
  return table[static_cast<std::size_t>(roughness)];
}

// --- ASHRAE's measured surface conductances, with radiation in them

struct Quadratic {
  double d, e, f;  // h = D + E V + F V^2, W m^-2 K^-1 with V in m s^-1
};
// EnergyPlus Engineering Reference, "Outdoor/Exterior Convection", table of roughness coefficients,
// after ASHRAE Handbook of Fundamentals (1989), figure 1 of page 22.4.
constexpr ByRoughness<Quadratic> combined{{{11.58, 5.894, 0.0},
                                           {12.49, 4.065, 0.028},
                                           {10.79, 4.192, 0.0},
                                           {8.23, 4.0, -0.057},
                                           {10.22, 3.1, 0.0},
                                           {8.23, 3.33, -0.036}}};
// The radiation that those conductances contain; the source does not say how much, so that of a
// usual building material at 20 degrees Celsius is assumed. Long-wave radiation is a term of its
// own here: to leave it in would count it twice.
constexpr double usual_emissivity = 0.9;
constexpr double usual_temperature_k = 293.15;
constexpr double contained_radiation = 4.0 * usual_emissivity * si::stefan_boltzmann *
                                       usual_temperature_k * usual_temperature_k *
                                       usual_temperature_k;

double simple_film(Roughness roughness, double wind_m_s) noexcept {
  const Quadratic c = for_roughness(combined, roughness);
  // A parabola that bends down would turn negative in a hurricane.
  const double v = c.f < 0.0 ? std::min(wind_m_s, -0.5 * c.e / c.f) : wind_m_s;
  return c.d + (c.e + c.f * v) * v - contained_radiation;
}

// --- McAdams (1954)

double mcadams_film(double wind_m_s) noexcept {
  constexpr double limit_m_s = 5.0;
  constexpr double at_limit = 5.7 + 3.8 * limit_m_s;
  if (wind_m_s <= limit_m_s) return 5.7 + 3.8 * wind_m_s;
  return std::max(at_limit, 6.47 * std::pow(wind_m_s, 0.78));
}

// --- TARP: Walton, "Thermal Analysis Research Program Reference Manual", NBSSIR 83-2655 (1983)

constexpr ByRoughness<double> roughness_multiplier{2.17, 1.67, 1.52,
                                                   1.13, 1.11, 1.0};  // Walton 1981
constexpr double perimeter_over_area_per_m = 4.0 / 10.0;  // of a square with sides of 10 m

/// Sparrow, Ramsey & Mass (1979): windward surfaces count 1, leeward ones, on which the wind falls
/// at more than 100 degrees from the normal, 1/2. The mean over the wind's directions: a surface of
/// tilt s is leeward where sin(s) cos(azimuth) < cos(100 degrees).
double mean_windward(double cos_tilt) noexcept {
  constexpr double limit = 0.17364817766693033;  // -cos(100 degrees)
  const double sin_tilt = std::sqrt(std::max(0.0, 1.0 - cos_tilt * cos_tilt));
  if (sin_tilt <= limit) return 1.0;
  return 1.0 - 0.5 * std::acos(limit / sin_tilt) / std::numbers::pi;
}

/// Natural convection over |dT|^(1/3). Where the air beside the surface wants to leave it (warm and
/// facing up, cold and facing down) more than at a wall, else less. EnergyPlus' manual prints
/// 7.283; Walton's 7.238, which its program uses, agrees with the wall, 1.31, and with ASHRAE's
/// 1.52 of a level plate.
double lifted(double cos_up) noexcept {
  return cos_up > 0.0 ? 9.482 / (7.238 - cos_up) : 1.810 / (1.382 - cos_up);
}

Film tarp_film(Roughness roughness, const AirFlow& flow) noexcept {
  const double cos_tilt = std::clamp(flow.cos_tilt, -1.0, 1.0);
  const double forced = 2.537 * for_roughness(roughness_multiplier, roughness) *
                        std::sqrt(perimeter_over_area_per_m * flow.wind_m_s);
  return {.forced_w_m2_k = forced * mean_windward(cos_tilt),
          .natural_warm_w_m2_k43 = lifted(cos_tilt),
          .natural_cold_w_m2_k43 = lifted(-cos_tilt)};
}

/// Says each law's film.
struct FilmOf {
  AirFlow flow;

  Film operator()(const FixedFilm& law) const noexcept {
    return {.forced_w_m2_k = std::max(0.0, law.film_w_m2_k)};
  }
  Film operator()(const McAdams& /*law*/) const noexcept {
    return {.forced_w_m2_k = mcadams_film(flow.wind_m_s)};
  }
  Film operator()(const SimpleByRoughness& law) const noexcept {
    return {.forced_w_m2_k = simple_film(law.roughness, flow.wind_m_s)};
  }
  Film operator()(const Tarp& law) const noexcept { return tarp_film(law.roughness, flow); }
};

}  // namespace

double Film::at(double surface_minus_air_k) const noexcept {
  const double natural = surface_minus_air_k > 0.0 ? natural_warm_w_m2_k43 : natural_cold_w_m2_k43;
  if (natural == 0.0) return forced_w_m2_k;
  return forced_w_m2_k + natural * std::cbrt(std::abs(surface_minus_air_k));
}

Film film(const Convection& law, const AirFlow& flow) noexcept {
  return std::visit(FilmOf{{std::max(0.0, flow.wind_m_s), flow.cos_tilt}}, law);
}

}  // namespace nadir::thermal
