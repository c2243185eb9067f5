#pragma once

#include <cstddef>
#include <vector>

#include "atmosphere/gases/band_tables.hpp"
#include "atmosphere/profile.hpp"

namespace nadir::atmosphere {

/// What absorbs evenly over wavelength or scatters: amounts that are not those of a band set.
enum class Smooth {
  water_self,     ///< water meets water, at 296 K                          [molecules cm^-2]
  water_cold,     ///< the same times (296 K - T)/36 K, held within 0 and 1
  water_foreign,  ///< water meets other air                                [molecules cm^-2]
  nitrogen,       ///< km at p0, T0
  oxygen,         ///< atm cm times p/p0
  oxygen_warm,    ///< the same times T - 220 K
  oxygen_warm2,   ///< the same times (T - 220 K)^2
  nitric_acid,    ///< atm cm
  ozone,          ///< atm cm
  ozone_warm,     ///< the same times T in deg C
  ozone_warm2,    ///< the same times its square
  air,            ///< km at p0, T0
};
inline constexpr int smooth_count = 12;

/// How much of each absorber lies in each layer, scaled as its parameters say: columns of numbers,
/// first the band sets in their order, then the smooth ones.
class GasAmounts {
 public:
  GasAmounts(const BandTables& tables, const Profile& profile, std::vector<double> level_height_m);

  [[nodiscard]] int layers() const noexcept { return static_cast<int>(level_height_m_.size()) - 1; }
  /// By layer, from the top down.
  [[nodiscard]] const std::vector<double>& of(std::size_t column) const { return amounts_[column]; }
  [[nodiscard]] std::size_t column_of(Smooth smooth) const {
    return sets_ + static_cast<std::size_t>(smooth);
  }
  [[nodiscard]] double total(std::size_t column) const { return totals_[column]; }
  [[nodiscard]] const std::vector<double>& level_height_m() const { return level_height_m_; }

 private:
  std::size_t sets_;
  std::vector<double> level_height_m_;
  std::vector<std::vector<double>> amounts_;
  std::vector<double> totals_;
};

}  // namespace nadir::atmosphere
