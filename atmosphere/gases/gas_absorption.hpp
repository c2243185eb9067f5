#pragma once

#include <memory>
#include <vector>

#include "atmosphere/gases/absorption_term.hpp"
#include "atmosphere/gases/band_tables.hpp"
#include "atmosphere/gases/gas_amounts.hpp"
#include "atmosphere/profile.hpp"
#include "spectral/lanes.hpp"

namespace nadir::atmosphere {

/// The absorption of all gases in the layers of a profile. The figures are those of LOWTRAN7's
/// band model: averages over 20 cm^-1 every 5 cm^-1, 0 to 50,000 cm^-1.
class GasAbsorption {
 public:
  /// @param level_height_m  descending, within the profile
  GasAbsorption(std::shared_ptr<const BandTables> tables, const Profile& profile,
                std::vector<double> level_height_m);

  /// The terms for an interval of wavelengths (or one wavelength where both are alike), ascending
  /// in total depth; few: those that are alike are merged until the transmittance of the merged sum
  /// would differ by more than `tolerance` for a vertical or slant path from the top or the ground
  /// (air mass up to 6).
  /// @throws InputError outside 0.2 to 1e4 um
  [[nodiscard]] std::vector<AbsorptionTerm> terms(Micrometres lo, Micrometres hi,
                                                  double tolerance) const;
  /// Transmittance of a path that crosses layer k `slant[k]` times its thickness, by the band
  /// model itself, exp(-x^a): without any sum of exponentials. For checks.
  [[nodiscard]] double band_transmittance(Micrometres wavelength,
                                          const std::vector<double>& slant) const;
  /// The same with the sums of exponentials in place of exp(-x^a), averaged over an interval of
  /// wavelengths: what terms() comes to with a tolerance of 0. For checks.
  [[nodiscard]] double mean_transmittance(Micrometres lo, Micrometres hi,
                                          const std::vector<double>& slant) const;
  /// Vertical optical depth of Rayleigh scattering by layer.
  [[nodiscard]] std::vector<double> rayleigh_depth(Micrometres wavelength) const;

  [[nodiscard]] int layers() const noexcept { return amounts_.layers(); }

 private:
  std::shared_ptr<const BandTables> tables_;
  GasAmounts amounts_;
};

}  // namespace nadir::atmosphere
