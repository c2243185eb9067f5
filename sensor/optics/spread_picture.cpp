#include "sensor/optics/spread_picture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nadir::sensor {
namespace {

/// sin(pi x) / (pi x).
double sinc(double x) {
  const double a = std::numbers::pi * x;
  return std::abs(a) < 1e-8 ? 1.0 : std::sin(a) / a;
}

/// The picture at a wavelength: linear between slices, the outermost beyond them.
void add_slice(const TabulatedSpread& table, double wavelength_um, std::vector<double>& sum) {
  const auto& slices = table.slices;
  const auto after = std::find_if(slices.begin(), slices.end(), [&](const auto& slice) {
    return slice.wavelength_um >= wavelength_um;
  });
  const auto hi = after == slices.end() ? slices.end() - 1 : after;
  const auto lo = hi == slices.begin() || after == slices.end() ? hi : hi - 1;
  const double width = hi->wavelength_um - lo->wavelength_um;
  const double share = width > 0.0 ? (wavelength_um - lo->wavelength_um) / width : 0.0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i] += (1.0 - share) * lo->weights[i] + share * hi->weights[i];
  }
}

void normalise(std::vector<double>& weights) {
  double all = 0.0;
  for (const double weight : weights) all += weight;
  for (double& weight : weights) weight /= all;
}

}  // namespace

SpreadPicture::SpreadPicture(const TabulatedSpread& table,
                             const std::vector<WavelengthQuantiles>& bands)
    : columns_{table.columns}, rows_{table.rows}, pitch_m_{table.pitch_m} {
  const std::size_t cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  mean_.assign(cells, 0.0);
  for (const WavelengthQuantiles& band : bands) {
    std::vector<double>& picture = of_band_.emplace_back(cells, 0.0);
    for (std::size_t part = 0; part < WavelengthQuantiles::parts; ++part) {
      add_slice(table, band.middle(part), picture);
    }
    normalise(picture);
    for (std::size_t i = 0; i < cells; ++i) mean_[i] += picture[i];
  }
  normalise(mean_);
  cumulative_.resize(cells);
  double sum = 0.0;
  for (std::size_t i = 0; i < cells; ++i) cumulative_[i] = sum += mean_[i];
}

Vec2 SpreadPicture::draw(double which, Vec2 inside) const noexcept {
  const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end(), which);
  const auto last = static_cast<std::ptrdiff_t>(cumulative_.size()) - 1;
  const auto cell = static_cast<int>(std::min(found - cumulative_.begin(), last));
  return {(cell % columns_ + inside.x - 0.5 * columns_) * pitch_m_,
          (cell / columns_ + inside.y - 0.5 * rows_) * pitch_m_};
}

double SpreadPicture::ratio(std::size_t band, Vec2 place_m) const noexcept {
  const int column = static_cast<int>(std::floor(place_m.x / pitch_m_ + 0.5 * columns_));
  const int row = static_cast<int>(std::floor(place_m.y / pitch_m_ + 0.5 * rows_));
  const auto cell = static_cast<std::size_t>(std::clamp(row, 0, rows_ - 1) * columns_ +
                                             std::clamp(column, 0, columns_ - 1));
  return mean_[cell] > 0.0 ? of_band_[band][cell] / mean_[cell] : 1.0;
}

std::complex<double> SpreadPicture::otf(std::size_t band, Vec2 frequency_per_m) const {
  std::complex<double> sum = 0.0;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const double x = (column + 0.5 - 0.5 * columns_) * pitch_m_;
      const double y = (row + 0.5 - 0.5 * rows_) * pitch_m_;
      const double phase =
          -2.0 * std::numbers::pi * (frequency_per_m.x * x + frequency_per_m.y * y);
      sum += of_band_[band][static_cast<std::size_t>(row * columns_ + column)] *
             std::polar(1.0, phase);
    }
  }
  return sum * sinc(frequency_per_m.x * pitch_m_) * sinc(frequency_per_m.y * pitch_m_);
}

}  // namespace nadir::sensor
