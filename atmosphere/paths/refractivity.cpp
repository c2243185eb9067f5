#include "atmosphere/paths/refractivity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::atmosphere {

double standard_refractivity(Micrometres wavelength) noexcept {
  const double s2 = 1.0 / (wavelength.value * wavelength.value);
  return 1e-8 * (5792105.0 / (238.0185 - s2) + 167917.0 / (57.362 - s2));
}

Refractivity::Refractivity(const Profile& profile, Micrometres wavelength) {
  if (profile.levels.size() < 2) {
    throw InputError{"refraction needs at least two levels of air, found " +
                     std::to_string(profile.levels.size())};
  }
  const double standard = standard_refractivity(wavelength);
  const double vapour = 1e-10 * (3.7345 - 0.0401 / (wavelength.value * wavelength.value));
  for (const Level& level : profile.levels) {
    if (!height_m_.empty() && !(level.height_m > height_m_.back())) {
      throw InputError{"expected ascending levels of air, found " + number_text(level.height_m) +
                       " m after " + number_text(height_m_.back()) + " m"};
    }
    if (!(level.pressure_hpa > 0.0 && level.temperature_k > 0.0)) {
      throw InputError{"expected positive pressure and temperature at " +
                       number_text(level.height_m) + " m"};
    }
    const double pressure_pa = 100.0 * level.pressure_hpa;
    const double mixing = 1e-6 * level.mixing(Gas::h2o);
    const double vapour_pa = pressure_pa * mixing / (1.0 + mixing);
    height_m_.push_back(level.height_m);
    value_.push_back(standard * pressure_pa / 101325.0 * 288.15 / level.temperature_k -
                     vapour * vapour_pa * 292.75 / level.temperature_k);
  }
  for (std::size_t k = 0; k + 1 < value_.size(); ++k) {
    fall_.push_back(std::log(value_[k] / value_[k + 1]) / (height_m_[k + 1] - height_m_[k]));
  }
}

int Refractivity::layer_of(double height_m) const noexcept {
  const auto above = std::upper_bound(height_m_.begin(), height_m_.end(), height_m);
  return std::clamp(static_cast<int>(above - height_m_.begin()) - 1, 0, layers() - 1);
}

double Refractivity::at(double height_m) const noexcept {
  if (height_m > top_m()) return 0.0;
  const std::size_t k = index(layer_of(height_m));
  return value_[k] * std::exp(-fall_[k] * (height_m - height_m_[k]));
}

double Refractivity::bending(int layer, double height_m) const noexcept {
  const std::size_t k = index(layer);
  const double n1 = value_[k] * std::exp(-fall_[k] * (height_m - height_m_[k]));
  return -fall_[k] * n1 / (1.0 + n1);
}

}  // namespace nadir::atmosphere
