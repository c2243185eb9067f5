#include "sensor/optics/diffraction_mix.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nadir::sensor {
namespace {

constexpr double metres_in_um = 1e-6;
/// Steps of the density in the shortest wavelength's x: a twenty-fifth of a ring.
constexpr double density_step = 0.125;

}  // namespace

DiffractionMix::DiffractionMix(const DiffractionSpread& lens,
                               std::vector<WavelengthQuantiles> bands)
    : aperture_{lens.obscuration}, f_number_{lens.f_number}, bands_{std::move(bands)} {
  if (bands_.size() < 2) return;
  double shortest_um = bands_.front().at(0.0), longest_um = shortest_um;
  for (const WavelengthQuantiles& band : bands_) {
    shortest_um = std::min(shortest_um, band.at(0.0));
    longest_um = std::max(longest_um, band.at(1.0));
  }
  const double unit_m = shortest_um * metres_in_um * f_number_ / std::numbers::pi;
  step_m_ = density_step * unit_m;
  const double reach_m = AnnularAperture::reach * unit_m * longest_um / shortest_um;
  const auto steps = static_cast<std::size_t>(reach_m / step_m_) + 2;
  densities_.reserve(steps * bands_.size());
  for (std::size_t i = 0; i < steps; ++i) {
    for (const WavelengthQuantiles& band : bands_) {
      densities_.push_back(static_cast<float>(density(band, static_cast<double>(i) * step_m_)));
    }
  }
}

double DiffractionMix::density(const WavelengthQuantiles& band, double distance_m) const {
  double sum = 0.0;
  for (std::size_t part = 0; part < WavelengthQuantiles::parts; ++part) {
    const double per_m = std::numbers::pi / (band.middle(part) * metres_in_um * f_number_);
    sum += aperture_.density(distance_m * per_m) * per_m * per_m;
  }
  return sum / static_cast<double>(WavelengthQuantiles::parts);
}

double DiffractionMix::distance(double which, double share) const noexcept {
  const double place = which * static_cast<double>(bands_.size());
  const auto band = std::min(static_cast<std::size_t>(place), bands_.size() - 1);
  const double wavelength_um = bands_[band].at(place - static_cast<double>(band));
  return aperture_.distance(share) * wavelength_um * metres_in_um * f_number_ / std::numbers::pi;
}

void DiffractionMix::weights(double distance_m, std::span<double> by_band) const noexcept {
  std::fill(by_band.begin(), by_band.end(), 1.0);
  const std::size_t count = bands_.size();
  const double place = distance_m / step_m_;
  const auto cell = static_cast<std::size_t>(place);
  if (densities_.empty() || (cell + 2) * count > densities_.size()) return;
  const double within = place - static_cast<double>(cell);
  const float* const here = densities_.data() + cell * count;
  double all = 0.0;
  for (std::size_t b = 0; b < by_band.size(); ++b) {
    by_band[b] = (1.0 - within) * static_cast<double>(here[b]) +
                 within * static_cast<double>(here[b + count]);
    all += by_band[b];
  }
  const double mean = all / static_cast<double>(count);
  for (double& weight : by_band) weight = mean > 0.0 ? weight / mean : 1.0;
}

double DiffractionMix::mtf(std::size_t band, double frequency_per_m) const noexcept {
  double sum = 0.0;
  for (std::size_t part = 0; part < WavelengthQuantiles::parts; ++part) {
    sum += aperture_.mtf(frequency_per_m * bands_[band].middle(part) * metres_in_um * f_number_);
  }
  return sum / static_cast<double>(WavelengthQuantiles::parts);
}

}  // namespace nadir::sensor
