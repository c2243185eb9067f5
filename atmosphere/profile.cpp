#include "atmosphere/profile.hpp"

#include <algorithm>
#include <cmath>

#include "atmosphere/gases/band_tables.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::atmosphere {

namespace {

/// Molecules of water in 1e-6 g, per cm^3: what LOWTRAN7 turns numbers into g m^-3 with.
constexpr double molecules_per_gram_m3 = 3.3429e16;
/// Molecules in a cm^3 at 1013.25 hPa and 273.15 K (CODATA 2018).
constexpr double loschmidt_cm3 = 2.686'780'111e19;

/// Between two levels: logarithmic where both are positive.
double between(double a, double b, double share) {
  if (a <= 0.0 || b <= 0.0) return a + share * (b - a);
  return a * std::pow(b / a, share);
}

Level interpolated(const Level& a, const Level& b, double height_m) {
  const double share = (height_m - a.height_m) / (b.height_m - a.height_m);
  Level level;
  level.height_m = height_m;
  level.pressure_hpa = between(a.pressure_hpa, b.pressure_hpa, share);
  level.temperature_k = a.temperature_k + share * (b.temperature_k - a.temperature_k);
  const double held = std::clamp(share, 0.0, 1.0);
  for (std::size_t gas = 0; gas < level.ppmv.size(); ++gas) {
    level.ppmv[gas] = between(a.ppmv[gas], b.ppmv[gas], held);
  }
  return level;
}

/// The integral over height of a density per km, from `above_m` up.
template <class Density>
double column(const Profile& profile, double above_m, Density density) {
  const std::vector<Level>& levels = profile.levels;
  double sum = 0.0;
  Level below = level_at(profile, above_m);
  for (const Level& level : levels) {
    if (level.height_m <= above_m) continue;
    sum += exponential_integral(density(below), density(level),
                                (level.height_m - below.height_m) * 1e-3);
    below = level;
  }
  return sum;
}

void check_factor(double factor, const char* what) {
  if (!(factor >= 0.0) || !std::isfinite(factor)) {
    throw InputError(std::string{what} + " must not be negative, found " + number_text(factor));
  }
}

}  // namespace

Profile standard_profile(const BandTables& tables, const std::string& name, double co2_ppmv) {
  std::vector<std::string> names;
  for (const Profile& profile : tables.standard) {
    if (profile.name == name) return scale_carbon_dioxide(profile, co2_ppmv);
    names.push_back(profile.name);
  }
  InputIssue issue{{}, "unknown standard profile \"" + name + "\"", {}, {}};
  const std::string nearest = nearest_name(name, names);
  if (!nearest.empty()) {
    issue.hint = "did you mean \"" + nearest + "\"?";
  } else {
    for (const std::string& known : names) issue.hint += (issue.hint.empty() ? "" : ", ") + known;
    issue.hint = "known: " + issue.hint;
  }
  throw InputError(std::move(issue));
}

Level level_at(const Profile& profile, double height_m) {
  const std::vector<Level>& levels = profile.levels;
  const double lowest_m = levels.front().height_m - profile.reaches_below_m;
  if (!(height_m >= lowest_m)) {
    throw InputError("the height " + number_text(height_m) + " m lies below the profile \"" +
                     profile.name + "\", which begins at " + number_text(lowest_m) + " m");
  }
  if (height_m > levels.back().height_m) {
    throw InputError("the height " + number_text(height_m) + " m lies above the profile \"" +
                     profile.name + "\", which ends at " + number_text(levels.back().height_m) +
                     " m");
  }
  const auto above = std::find_if(levels.begin() + 1, levels.end() - 1,
                                  [&](const Level& level) { return level.height_m >= height_m; });
  return interpolated(*(above - 1), *above, height_m);
}

double relative_density(const Level& level) noexcept {
  return level.pressure_hpa / standard_pressure_hpa *
         (standard_temperature_k / level.temperature_k);
}

double water_density(const Level& level) noexcept {
  return level.mixing(Gas::h2o) * 1e-6 * relative_density(level) * loschmidt_cm3 /
         molecules_per_gram_m3;
}

double saturation_pressure_hpa(double temperature_k) noexcept {
  const double t = temperature_k;
  const double log_t = std::log(t);
  const double log_pa =
      54.842763 - 6763.22 / t - 4.210 * log_t + 0.000367 * t +
      std::tanh(0.0415 * (t - 218.8)) * (53.878 - 1331.22 / t - 9.44523 * log_t + 0.014025 * t);
  return std::exp(log_pa) * 1e-2;
}

double relative_humidity(const Level& level) noexcept {
  return level.mixing(Gas::h2o) * 1e-6 * level.pressure_hpa /
         saturation_pressure_hpa(level.temperature_k);
}

double exponential_integral(double below, double above, double length) noexcept {
  if (below * above <= 0.0) return 0.5 * (below + above) * length;
  const double ratio = std::log(above / below);
  // The exact mean of an exponential; its series where the difference quotient would cancel:
  // the next term is ratio^4 / 1920, below 1e-14.
  if (std::abs(ratio) < 1e-3)
    return std::sqrt(below * above) * (1.0 + ratio * ratio / 24.0) * length;
  return (above - below) / ratio * length;
}

double water_column(const Profile& profile, double above_m) {
  return column(profile, above_m, [](const Level& l) { return 0.1 * water_density(l); });
}

double ozone_column(const Profile& profile, double above_m) {
  // 1e-6 of the air, km: 0.1 cm; in Dobson units 100.
  return column(profile, above_m,
                [](const Level& l) { return 100.0 * l.mixing(Gas::o3) * relative_density(l); });
}

ScaledProfile scale_water(const Profile& profile, double factor, double above_m) {
  check_factor(factor, "the factor of water vapour");
  ScaledProfile scaled{profile, 0.0, 0};
  for (Level& level : scaled.profile.levels) {
    const double before = level.mixing(Gas::h2o);
    const double most =
        std::max(before, saturation_pressure_hpa(level.temperature_k) / level.pressure_hpa * 1e6);
    if (before * factor > most) ++scaled.capped_levels;
    level.mixing(Gas::h2o) = std::min(before * factor, most);
  }
  scaled.column = water_column(scaled.profile, above_m);
  return scaled;
}

ScaledProfile scale_water_to(const Profile& profile, double column_g_cm2, double above_m) {
  check_factor(column_g_cm2, "the column of water vapour");
  const double before = water_column(profile, above_m);
  if (!(before > 0.0)) throw InputError("a profile without water vapour cannot be scaled");
  double lo = 0.0, hi = column_g_cm2 / before;
  ScaledProfile scaled = scale_water(profile, hi, above_m);
  if (scaled.capped_levels == 0) return scaled;
  // Levels at saturation do not follow: the others take more. Above a factor of 1e4 all of the
  // troposphere is saturated.
  while (scaled.column < column_g_cm2 && hi < 1e4) {
    lo = hi;
    hi *= 2.0;
    scaled = scale_water(profile, hi, above_m);
  }
  if (scaled.column < column_g_cm2) return scaled;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (lo + hi);
    (water_column(scale_water(profile, middle, above_m).profile, above_m) < column_g_cm2 ? lo
                                                                                         : hi) =
        middle;
  }
  return scale_water(profile, hi, above_m);
}

ScaledProfile scale_ozone(const Profile& profile, double factor, double above_m) {
  check_factor(factor, "the factor of ozone");
  ScaledProfile scaled{profile, 0.0, 0};
  for (Level& level : scaled.profile.levels) level.mixing(Gas::o3) *= factor;
  scaled.column = ozone_column(scaled.profile, above_m);
  return scaled;
}

ScaledProfile scale_ozone_to(const Profile& profile, double dobson, double above_m) {
  check_factor(dobson, "the column of ozone");
  const double before = ozone_column(profile, above_m);
  if (!(before > 0.0)) throw InputError("a profile without ozone cannot be scaled");
  return scale_ozone(profile, dobson / before, above_m);
}

Profile scale_carbon_dioxide(const Profile& profile, double ppmv) {
  check_factor(ppmv, "the mixing ratio of carbon dioxide");
  Profile scaled = profile;
  const double before = profile.levels.front().mixing(Gas::co2);
  if (!(before > 0.0)) throw InputError("a profile without carbon dioxide cannot be scaled");
  for (Level& level : scaled.levels) level.mixing(Gas::co2) *= ppmv / before;
  return scaled;
}

void check(const Profile& profile) {
  const auto fail = [&](const std::string& what) {
    throw InputError("the profile \"" + profile.name + "\": " + what);
  };
  if (profile.levels.size() < 2) fail("needs at least two levels");
  for (std::size_t i = 0; i < profile.levels.size(); ++i) {
    const Level& level = profile.levels[i];
    const std::string at = "at " + number_text(level.height_m) + " m ";
    const auto legal = [](double x) { return std::isfinite(x) && x >= 0.0; };
    if (!std::isfinite(level.height_m)) fail("a height is not finite");
    if (!legal(level.pressure_hpa) || level.pressure_hpa == 0.0) fail(at + "pressure must be > 0");
    if (!legal(level.temperature_k) || level.temperature_k == 0.0) {
      fail(at + "temperature must be > 0");
    }
    if (!std::all_of(level.ppmv.begin(), level.ppmv.end(), legal)) {
      fail(at + "a mixing ratio is negative or not finite");
    }
    if (i == 0) continue;
    if (level.height_m <= profile.levels[i - 1].height_m) fail(at + "heights must ascend");
    if (level.pressure_hpa >= profile.levels[i - 1].pressure_hpa) fail(at + "pressure must fall");
  }
}

}  // namespace nadir::atmosphere
