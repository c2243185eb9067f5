#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace nadir::atmosphere {

enum class Gas { h2o, co2, o3, n2o, co, ch4, o2, no, so2, no2, nh3, hno3 };
inline constexpr int gas_count = 12;

/// Pressure and temperature that amounts of gas are reduced to, as in LOWTRAN7.
inline constexpr double standard_pressure_hpa = 1013.25;
inline constexpr double standard_temperature_k = 273.15;

/// The air at one height.
struct Level {
  double height_m = 0.0;  ///< above mean sea level
  double pressure_hpa = 0.0;
  double temperature_k = 0.0;
  std::array<double, gas_count> ppmv{};  ///< share of all molecules, 1e-6, by Gas

  [[nodiscard]] double mixing(Gas gas) const { return ppmv[static_cast<std::size_t>(gas)]; }
  [[nodiscard]] double& mixing(Gas gas) { return ppmv[static_cast<std::size_t>(gas)]; }
};

/// The air over the scene, from the ground up: heights ascend.
struct Profile {
  std::string name;
  std::vector<Level> levels;
  /// How far below the first level the air is taken to go on as in the lowest layer (standard
  /// profiles: 500 m).
  double reaches_below_m = 0.0;
};

// Layers and levels of everything that is computed from a profile count from the top of the air
// down, the way light comes: layer k lies between level k (above) and level k + 1 (below).

struct BandTables;

/// Volume mixing ratio of carbon dioxide in standard profiles unless asked otherwise (2023).
inline constexpr double carbon_dioxide_ppmv = 420.0;

/// One of the standard profiles, its carbon dioxide scaled to `co2_ppmv` at the ground.
/// @throws InputError for an unknown name, with the nearest one
[[nodiscard]] Profile standard_profile(const BandTables& tables, const std::string& name,
                                       double co2_ppmv = carbon_dioxide_ppmv);

/// The air at any height: temperature linear in height, logarithms of pressure and of mixing
/// ratios linear in height (a mixing ratio that is 0 at one end: itself). As far
/// below the first level as the profile reaches, the lowest layer's temperature and pressure go on
/// and mixing ratios are held.
/// @throws InputError further below and above the last level
[[nodiscard]] Level level_at(const Profile& profile, double height_m);

/// Air molecules relative to standard_pressure_hpa and standard_temperature_k.
[[nodiscard]] double relative_density(const Level& level) noexcept;
/// Density of water vapour, g m^-3.
[[nodiscard]] double water_density(const Level& level) noexcept;
/// Saturation vapour pressure over liquid water, hPa, 123 to 332 K (Murphy & Koop 2005, eq. 10,
/// doi:10.1256/qj.04.94).
[[nodiscard]] double saturation_pressure_hpa(double temperature_k) noexcept;
/// Over liquid water, 1 = saturated.
[[nodiscard]] double relative_humidity(const Level& level) noexcept;

/// Integral over height of what falls off exponentially between two heights (linearly where one
/// value is 0 or signs differ): value times length.
[[nodiscard]] double exponential_integral(double below, double above, double length) noexcept;

/// Water vapour above a height, g cm^-2 (= cm of precipitable water).
[[nodiscard]] double water_column(const Profile& profile, double above_m);
/// Ozone above a height, Dobson units (1e-3 atm cm).
[[nodiscard]] double ozone_column(const Profile& profile, double above_m);

/// What a scaling came to.
struct ScaledProfile {
  Profile profile;
  double column = 0.0;    ///< above `above_m`, in the unit asked in
  int capped_levels = 0;  ///< held at a relative humidity of 100 %
};
/// Water vapour times a factor >= 0; no level goes above saturation (nor, where it was above it
/// before, above what it was).
[[nodiscard]] ScaledProfile scale_water(const Profile& profile, double factor, double above_m);
/// Water vapour scaled to a column above a height, g cm^-2. Where saturation does not allow as
/// much, the column comes out smaller.
[[nodiscard]] ScaledProfile scale_water_to(const Profile& profile, double column_g_cm2,
                                           double above_m);
/// Ozone times a factor >= 0.
[[nodiscard]] ScaledProfile scale_ozone(const Profile& profile, double factor, double above_m);
/// Ozone scaled to a column above a height, Dobson units.
[[nodiscard]] ScaledProfile scale_ozone_to(const Profile& profile, double dobson, double above_m);
/// Carbon dioxide scaled to a mixing ratio at the ground.
[[nodiscard]] Profile scale_carbon_dioxide(const Profile& profile, double ppmv);

/// Heights ascend, pressures fall, all is finite and positive. @throws InputError
void check(const Profile& profile);

}  // namespace nadir::atmosphere
