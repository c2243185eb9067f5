#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "atmosphere/gases/band_tables.hpp"
#include "atmosphere/gases/gas_amounts.hpp"

namespace nadir::atmosphere {

/// The band model's grid: 0 to 50,000 cm^-1 every 5 cm^-1.
inline constexpr double grid_step = 5.0;
inline constexpr double grid_end = 50'000.0;

/// What absorbs at one wavenumber of the grid.
struct GridPoint {
  struct Part {
    std::size_t column = 0;    ///< of GasAmounts
    double coefficient = 0.0;  ///< of the amount: optical depth, or x of a band set
  };
  double wavenumber = 0.0;  ///< cm^-1
  double weight = 1.0;      ///< of this point in its interval
  std::vector<Part> bands;  ///< at most one a gas
  std::vector<Part> smooth;
};

/// The points that an interval of wavelengths (or one wavelength, where both are alike) takes its
/// transmittance from, linear between them, uniform over wavelength; their weights sum to 1.
/// @throws InputError outside 0.2 to 1e4 um
[[nodiscard]] std::vector<GridPoint> grid_points(const BandTables& tables,
                                                 const GasAmounts& amounts, double lo_um,
                                                 double hi_um);

/// Rayleigh scattering of 1 km of air at p0, T0, in LOWTRAN7's form; 0.2 um and longer.
[[nodiscard]] double rayleigh_per_km(double wavenumber) noexcept;

}  // namespace nadir::atmosphere
