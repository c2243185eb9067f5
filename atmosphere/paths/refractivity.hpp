#pragma once

#include <vector>

#include "atmosphere/profile.hpp"
#include "core/quantity.hpp"

namespace nadir::atmosphere {

/// n - 1 of dry air at 15 C and 101325 Pa with 450 ppm of CO2.
///
///     10^8 (n - 1) = 5792105 / (238.0185 - s^2) + 167917 / (57.362 - s^2),  s = 1 / lambda [um^-1]
///
/// Source: P. E. Ciddor, Appl. Opt. 35, 1566 (1996), eq. 1, measured from 0.23 to 1.69 um (5e-8 of
/// n there). Beyond it tends to 2.7261e-4; apart from bands of water and CO2 dry air follows it
/// within 1e-6 up to 14 um.
[[nodiscard]] double standard_refractivity(Micrometres wavelength) noexcept;

/// How strongly the air over a place refracts at one wavelength: n - 1 against height, exponential
/// between the levels of a profile, nothing above the last, below the first as in the lowest layer.
///
///     n - 1 = (n_s - 1) (p / 101325 Pa) (288.15 K / T) - 10^-10 (292.75 K / T) (3.7345 - 0.0401
///     s^2) e
///
/// with e the water vapour's pressure in Pa. An ideal gas: within 0.05 % of Ciddor's density.
/// Source of the last term: Birch & Downs, Metrologia 30, 155 (1993), up to 1.7 um.
class Refractivity {
 public:
  /// @throws InputError for fewer than two levels, or not ascending or not positive ones
  Refractivity(const Profile& profile, Micrometres wavelength);

  [[nodiscard]] double at(double height_m) const noexcept;  ///< n - 1
  [[nodiscard]] double top_m() const noexcept { return height_m_.back(); }

  // Layers count from the lowest up. A layer's own law may be taken beyond its edges.
  [[nodiscard]] int layers() const noexcept { return static_cast<int>(height_m_.size()) - 1; }
  [[nodiscard]] int layer_of(double height_m) const noexcept;  ///< outside the levels the nearest
  [[nodiscard]] double bottom_m(int layer) const { return height_m_[index(layer)]; }
  /// d ln n / dz, m^-1: how strongly a level ray bends there.
  [[nodiscard]] double bending(int layer, double height_m) const noexcept;

 private:
  static std::size_t index(int layer) { return static_cast<std::size_t>(layer); }
  std::vector<double> height_m_;  // ascending
  std::vector<double> value_;     // n - 1 at the levels
  std::vector<double> fall_;      // -d ln(n - 1) / dz by layer, m^-1
};

}  // namespace nadir::atmosphere
