#include "sensor/optics/diffraction_mix.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nadir::sensor {
namespace {

constexpr double metres_in_um = 1e-6;
/// Steps of the density in the shortest wavelength's x: a quarter of a radian, a twelfth of a ring.
constexpr double density_step = 0.25;

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
  for (const WavelengthQuantiles& band : bands_) {
    std::vector<float>& density = densities_.emplace_back(steps);
    for (std::size_t i = 0; i < steps; ++i) {
      double sum = 0.0;
      for (std::size_t part = 0; part < WavelengthQuantiles::parts; ++part) {
        const double per_m = std::numbers::pi / (band.middle(part) * metres_in_um * f_number_);
        sum += aperture_.density(static_cast<double>(i) * step_m_ * per_m) * per_m * per_m;
      }
      density[i] = static_cast<float>(sum);
    }
  }
}

double DiffractionMix::distance(double which, double share) const noexcept {
  const double place = which * static_cast<double>(bands_.size());
  const auto band = std::min(static_cast<std::size_t>(place), bands_.size() - 1);
  const double wavelength_um = bands_[band].at(place - static_cast<double>(band));
  return aperture_.distance(share) * wavelength_um * metres_in_um * f_number_ / std::numbers::pi;
}

double DiffractionMix::tabulated(std::size_t band, double place) const noexcept {
  const std::vector<float>& density = densities_[band];
  const auto cell = static_cast<std::size_t>(place);
  if (cell + 1 >= density.size()) return 0.0;
  const double within = place - static_cast<double>(cell);
  return (1.0 - within) * static_cast<double>(density[cell]) +
         within * static_cast<double>(density[cell + 1]);
}

double DiffractionMix::ratio(std::size_t band, double distance_m) const noexcept {
  if (densities_.empty()) return 1.0;
  const double place = distance_m / step_m_;
  double mean = 0.0;
  for (std::size_t b = 0; b < densities_.size(); ++b) mean += tabulated(b, place);
  mean /= static_cast<double>(densities_.size());
  return mean > 0.0 ? tabulated(band, place) / mean : 1.0;
}

double DiffractionMix::mtf(std::size_t band, double frequency_per_m) const noexcept {
  double sum = 0.0;
  for (std::size_t part = 0; part < WavelengthQuantiles::parts; ++part) {
    sum += aperture_.mtf(frequency_per_m * bands_[band].middle(part) * metres_in_um * f_number_);
  }
  return sum / static_cast<double>(WavelengthQuantiles::parts);
}

}  // namespace nadir::sensor
