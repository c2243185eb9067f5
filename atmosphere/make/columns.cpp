#include "atmosphere/make/columns.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "atmosphere/make/levels.hpp"

namespace nadir::atmosphere {
namespace {

// LOWTRAN7 and Bodhaine et al. (1999) agree on air's depolarisation to 1e-3 of the depth.
constexpr double depolarisation = 0.0279;
constexpr double negligible = 1e-7;

std::shared_ptr<const PhaseFunction> rayleigh_phase() {
  static const auto phase =
      std::make_shared<const PhaseFunction>(PhaseFunction::rayleigh(depolarisation));
  return phase;
}

/// The mean of phase functions, on angles that are dense where all particles' peaks are.
std::shared_ptr<const PhaseFunction> mean_phase(const std::vector<KindOptics>& optics,
                                                const std::vector<double>& weights) {
  std::vector<double> angles, values;
  constexpr int count = 200;
  for (int i = 0; i <= count; ++i) {
    const double x = static_cast<double>(i) / count;
    angles.push_back(std::numbers::pi * x * x);
    double value = 0.0;
    for (std::size_t k = 0; k < optics.size(); ++k) {
      value += weights[k] * optics[k].phase->at(std::cos(angles.back()));
    }
    values.push_back(value);
  }
  return std::make_shared<const PhaseFunction>(std::move(angles), std::move(values));
}

}  // namespace

ColumnMaker::ColumnMaker(const Layered& air, const std::vector<Micrometres>& wavelengths)
    : levels_m_{column_levels_m(air.profile, air.aerosol, air.clouds, air.ground_height_m)},
      gases_{air.gases, air.profile, levels_m_},
      particles_{air.particles, air.aerosol, air.clouds, levels_m_} {
  for (const double z : levels_m_)
    temperatures_k_.push_back(level_at(air.profile, z).temperature_k);
  for (int k = 0; k < particles_.kinds(); ++k) {
    const auto& depth = particles_.depth_550(k);
    total_550_.push_back(std::accumulate(depth.begin(), depth.end(), 0.0));
  }
  group_kinds(wavelengths);
}

void ColumnMaker::group_kinds(const std::vector<Micrometres>& wavelengths) {
  const auto count = static_cast<std::size_t>(particles_.kinds());
  std::vector<double> share(count, 0.0);  // of all scattering, where it is largest
  for (const Micrometres wavelength : wavelengths) {
    const auto rayleigh = gases_.rayleigh_depth(wavelength);
    double sum = std::accumulate(rayleigh.begin(), rayleigh.end(), 0.0);
    std::vector<double> each(count);
    for (std::size_t k = 0; k < count; ++k) {
      if (total_550_[k] <= 0.0) continue;
      each[k] = total_550_[k] * particles_.optics(static_cast<int>(k), wavelength).scattering;
      sum += each[k];
    }
    for (std::size_t k = 0; k < count; ++k) share[k] = std::max(share[k], each[k] / sum);
  }
  std::vector<int> order;
  for (std::size_t k = 0; k < count; ++k) {
    if (share[k] >= negligible) order.push_back(static_cast<int>(k));
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return share[static_cast<std::size_t>(a)] > share[static_cast<std::size_t>(b)];
  });
  for (const int kind : order) {
    if (groups_.size() + 1 < static_cast<std::size_t>(most_kinds)) {
      groups_.push_back({kind});
    } else {
      groups_.back().push_back(kind);
    }
  }
}

std::vector<AbsorptionTerm> ColumnMaker::terms(const spectral::AbsorptionLane& lane,
                                               Micrometres wavelength, double tolerance) const {
  const bool interval = lane.hi_um > lane.lo_um;
  return gases_.terms(interval ? Micrometres{lane.lo_um} : wavelength,
                      interval ? Micrometres{lane.hi_um} : wavelength, tolerance);
}

OpticalColumn::Kind ColumnMaker::merged(const std::vector<int>& group,
                                        const std::vector<KindOptics>& optics) const {
  OpticalColumn::Kind made;
  made.scattering.assign(levels_m_.size() - 1, 0.0);
  std::vector<KindOptics> members;
  std::vector<double> weights;
  for (const int kind : group) {
    const auto k = static_cast<std::size_t>(kind);
    const auto& depth = particles_.depth_550(kind);
    for (std::size_t i = 0; i < depth.size(); ++i) {
      made.scattering[i] += depth[i] * optics[k].scattering;
    }
    members.push_back(optics[k]);
    weights.push_back(total_550_[k] * optics[k].scattering);
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  const bool one = members.size() == 1 || sum <= 0.0;
  made.phase = one ? members.front().phase : mean_phase(members, weights);
  return made;
}

OpticalColumn ColumnMaker::column(Micrometres wavelength,
                                  const std::vector<double>& gas_depth) const {
  OpticalColumn column;
  column.level_height_m = levels_m_;
  column.level_temperature_k = temperatures_k_;
  column.absorption = gas_depth;
  column.kinds.push_back({gases_.rayleigh_depth(wavelength), rayleigh_phase()});
  std::vector<KindOptics> optics;
  for (int k = 0; k < particles_.kinds(); ++k) {
    optics.push_back(particles_.optics(k, wavelength));
    const auto& depth = particles_.depth_550(k);
    for (std::size_t i = 0; i < depth.size(); ++i) {
      column.absorption[i] += depth[i] * optics.back().absorption;
    }
  }
  for (const auto& group : groups_) column.kinds.push_back(merged(group, optics));
  return column;
}

}  // namespace nadir::atmosphere
