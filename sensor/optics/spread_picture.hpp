#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "core/vec.hpp"
#include "sensor/optics/point_spread.hpp"
#include "sensor/optics/wavelength_quantiles.hpp"

namespace nadir::sensor {

/// A tabulated point-spread function as each band sees it.
class SpreadPicture {
 public:
  SpreadPicture(const TabulatedSpread& table, const std::vector<WavelengthQuantiles>& bands);

  /// A place drawn from the mean of the bands' pictures, m.
  /// @param which  decides the cell   @param inside  where in it
  [[nodiscard]] Vec2 draw(double which, Vec2 inside) const noexcept;
  /// Ratio of a band's picture to the mean one at a place that was drawn.
  [[nodiscard]] double ratio(std::size_t band, Vec2 place_m) const noexcept;
  /// Transfer function: of the cells' weights, times that of a cell.
  [[nodiscard]] std::complex<double> otf(std::size_t band, Vec2 frequency_per_m) const;

 private:
  int columns_ = 0, rows_ = 0;
  double pitch_m_ = 0.0;
  std::vector<std::vector<double>> of_band_;
  std::vector<double> mean_, cumulative_;
};

}  // namespace nadir::sensor
