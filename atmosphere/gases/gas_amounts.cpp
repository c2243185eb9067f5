#include "atmosphere/gases/gas_amounts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"

namespace nadir::atmosphere {

namespace {

/// Molecules cm^-2 km^-1 at p0, T0, as LOWTRAN7 has it.
constexpr double loschmidt_per_km = 2.6868e24;

/// What each column amounts to at one level, per km.
std::vector<double> densities(const BandTables& tables, const Level& level) {
  std::vector<double> per_km;
  per_km.reserve(tables.sets.size() + smooth_count);
  const double pressure = level.pressure_hpa / standard_pressure_hpa;
  const double cold = standard_temperature_k / level.temperature_k;
  const double air = relative_density(level);
  const double water = water_density(level);
  // 1e-6 of the air over 1 km is 0.1 atm cm at p0, T0; water vapour in g cm^-2.
  const auto amount = [&](Gas gas) {
    return gas == Gas::h2o ? 0.1 * water : 0.1 * air * level.mixing(gas);
  };
  for (const BandSet& set : tables.sets) {
    per_km.push_back(amount(set.gas) * std::pow(pressure, set.n) * std::pow(cold, set.m));
  }
  // Water's density relative to air at p0, T0 (LOWTRAN7: 3.3429e21 molecules km^-1 per g m^-3).
  const double vapour = 3.3429e21 * water / loschmidt_per_km;
  const double self = loschmidt_per_km * vapour * vapour * 296.0 / standard_temperature_k;
  const double t = level.temperature_k;
  const double celsius = t - standard_temperature_k;
  const double oxygen = amount(Gas::o2) * pressure;
  per_km.push_back(self);
  per_km.push_back(self * std::clamp((296.0 - t) / 36.0, 0.0, 1.0));
  per_km.push_back(loschmidt_per_km * vapour * std::max(0.0, air - vapour) * 296.0 /
                   standard_temperature_k);
  per_km.push_back(0.781 * pressure * pressure * std::pow(cold, 1.5));
  per_km.push_back(oxygen);
  per_km.push_back(oxygen * (t - 220.0));
  per_km.push_back(oxygen * (t - 220.0) * (t - 220.0));
  per_km.push_back(amount(Gas::hno3));
  per_km.push_back(amount(Gas::o3));
  per_km.push_back(amount(Gas::o3) * celsius);
  per_km.push_back(amount(Gas::o3) * celsius * celsius);
  per_km.push_back(air);
  return per_km;
}

/// Between two levels of densities: each as exponential_integral() takes it.
double density_between(double below, double above, double share) {
  if (below * above <= 0.0) return below + share * (above - below);
  return below * std::pow(above / below, share);
}

void check_levels(const Profile& profile, const std::vector<double>& level_height_m) {
  if (level_height_m.size() < 2) throw InputError("the air needs at least two levels");
  for (std::size_t i = 1; i < level_height_m.size(); ++i) {
    if (!(level_height_m[i] < level_height_m[i - 1])) {
      throw InputError("the levels of the air must descend");
    }
  }
  static_cast<void>(level_at(profile, level_height_m.front()));  // reports what lies outside
  static_cast<void>(level_at(profile, level_height_m.back()));
}

}  // namespace

GasAmounts::GasAmounts(const BandTables& tables, const Profile& profile,
                       std::vector<double> level_height_m)
    : sets_{tables.sets.size()}, level_height_m_{std::move(level_height_m)} {
  check_levels(profile, level_height_m_);
  const auto layer_count = static_cast<std::size_t>(layers());
  amounts_.assign(sets_ + smooth_count, std::vector<double>(layer_count, 0.0));

  // The profile's own levels, and the ground where it lies below them.
  std::vector<Level> own = profile.levels;
  if (level_height_m_.back() < own.front().height_m) {
    own.insert(own.begin(), level_at(profile, level_height_m_.back()));
  }
  std::vector<std::vector<double>> at;
  at.reserve(own.size());
  for (const Level& level : own) at.push_back(densities(tables, level));

  for (std::size_t layer = 0; layer < layer_count; ++layer) {
    const double bottom = level_height_m_[layer + 1], top = level_height_m_[layer];
    for (std::size_t i = 0; i + 1 < own.size(); ++i) {
      const double lo = std::max(bottom, own[i].height_m);
      const double hi = std::min(top, own[i + 1].height_m);
      if (hi <= lo) continue;
      const double thickness = own[i + 1].height_m - own[i].height_m;
      const double a = (lo - own[i].height_m) / thickness, b = (hi - own[i].height_m) / thickness;
      for (std::size_t column = 0; column < amounts_.size(); ++column) {
        const double below = at[i][column], above = at[i + 1][column];
        if (below == 0.0 && above == 0.0) continue;
        amounts_[column][layer] += exponential_integral(
            a == 0.0 ? below : density_between(below, above, a),
            b == 1.0 ? above : density_between(below, above, b), (hi - lo) * 1e-3);
      }
    }
  }
  for (const std::vector<double>& column : amounts_) {
    totals_.push_back(std::accumulate(column.begin(), column.end(), 0.0));
  }
}

}  // namespace nadir::atmosphere
