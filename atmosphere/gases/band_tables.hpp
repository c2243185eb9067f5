#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "atmosphere/profile.hpp"

namespace nadir::atmosphere {

/// Figures that stand at evenly spaced wavenumbers.
struct EvenRun {
  double first = 0.0;  ///< wavenumber of the first, cm^-1
  double step = 5.0;   ///< cm^-1
  std::vector<double> values;

  [[nodiscard]] double last() const {
    return first + step * static_cast<double>(values.size() - 1);
  }
  /// Linear between the figures, 0 outside them.
  [[nodiscard]] double at(double wavenumber) const noexcept {
    if (values.empty() || wavenumber < first || wavenumber > last()) return 0.0;
    const double x = (wavenumber - first) / step;
    const auto i = static_cast<std::size_t>(x);
    if (i + 1 >= values.size()) return values.back();
    return values[i] + (x - static_cast<double>(i)) * (values[i + 1] - values[i]);
  }
};

/// A set of parameters of the band model: one gas in one part of the spectrum,
/// T = exp(-x^a), x = 10^C' W, W the amount scaled by (p/p0)^n (T0/T)^m.
struct BandSet {
  static constexpr int term_count = 10;
  Gas gas = Gas::h2o;
  int number = 0;  ///< LOWTRAN7's
  double a = 1.0, n = 0.0, m = 0.0;
  std::array<double, term_count> k{};       ///< exp(-x^a) = sum of weight exp(-k x)
  std::array<double, term_count> weight{};  ///< sums to 1
};

/// log10 C' of a set, every 5 cm^-1.
struct BandRun {
  int set = 0;  ///< index into BandTables::sets
  EvenRun log10_c;
};

/// Figures of the band model, as read from the project's data: plain data.
struct BandTables {
  std::vector<BandSet> sets;
  std::vector<BandRun> bands;
  EvenRun self_296, self_260, foreign;          ///< water, 1e-20 cm^3 molecule^-1
  EvenRun nitrogen;                             ///< km^-1 of air at p0, T0
  EvenRun oxygen, oxygen_per_k, oxygen_per_k2;  ///< (atm cm)^-1, K^-1, K^-2 from 220 K
  std::vector<EvenRun> nitric_acid;             ///< (atm cm)^-1
  EvenRun ozone_visible, ozone_far;             ///< (atm cm)^-1
  EvenRun ozone_c0, ozone_c1, ozone_c2;         ///< 0.269 c0 (1 + c1 t + c2 t^2), t in deg C
  std::vector<Profile> standard;                ///< profiles, carbon dioxide as of 1986
};

}  // namespace nadir::atmosphere
