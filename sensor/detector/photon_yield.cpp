#include "sensor/detector/photon_yield.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/constants.hpp"
#include "spectral/band_quadrature.hpp"
#include "spectral/planck.hpp"

namespace nadir::sensor {
namespace {

/// Planck's law is smooth: twelve nodes give its mean over 3 .. 5 um at 250 K to 1e-13.
constexpr int planck_nodes = 12;

/// Area of a response, um, and the greatest value of R / lambda, um^-1.
struct Weights {
  double area_um = 0.0, peak_per_um = 0.0;
};

Weights weights_of(const spectral::TabulatedResponse& table) {
  const auto& w = table.curve.wavelengths_um();
  const auto& r = table.curve.values();
  Weights found;
  // On a segment R = a + b lambda, so R / lambda is monotonic: its peak is at a node.
  for (std::size_t i = 0; i < w.size(); ++i) {
    found.peak_per_um = std::max(found.peak_per_um, r[i] / w[i]);
    if (i > 0) found.area_um += 0.5 * (w[i] - w[i - 1]) * (r[i] + r[i - 1]);
  }
  return found;
}

Weights weights_of(const spectral::GaussianResponse& g) {
  const double centre = g.centre.value, fwhm = g.fwhm.value;
  const double steepness = 4.0 * std::numbers::ln2 / (fwhm * fwhm);
  const double half = 0.5 * (support(spectral::Response{g}).hi - support(spectral::Response{g}).lo)
                                .value;  // the Gaussian is cut off
  Weights found;
  found.area_um = std::sqrt(std::numbers::pi / steepness) * std::erf(std::sqrt(steepness) * half);
  // d ln(R / lambda) = 0:  lambda (lambda - centre) = -1 / (2 steepness), the root near the centre.
  const double root = centre * centre - 2.0 / steepness;
  const double lo = centre - half;
  const double peak = root > 0.0 ? std::max(0.5 * (centre + std::sqrt(root)), lo) : lo;
  const auto density = [&](double lambda) {
    return std::exp(-steepness * (lambda - centre) * (lambda - centre)) / lambda;
  };
  found.peak_per_um = std::max(density(peak), density(lo));  // very wide ones grow to the blue
  return found;
}

Weights weights_of(const spectral::BoxResponse& box) {
  return {(box.hi - box.lo).value, 1.0 / box.lo.value};
}

template <class Law>
double band_mean(const spectral::Response& response, const Law& law) {
  const spectral::BandQuadrature band = spectral::gauss_quadrature(response, planck_nodes);
  double sum = 0.0;
  for (std::size_t i = 0; i < band.weights.size(); ++i) {
    sum += band.weights[i] * law(band.wavelengths[i]);
  }
  return sum;
}

}  // namespace

PhotonYield photon_yield(const spectral::Response& response) {
  const Weights w = std::visit([](const auto& r) { return weights_of(r); }, response);
  constexpr double metres_per_um = 1e-6;  // h c / lambda takes the wavelength in metres
  return {w.area_um / w.peak_per_um * metres_per_um / (si::planck * si::speed_of_light)};
}

double cone_sr(const Optics& optics) noexcept {
  const double n = optics.f_number, e = optics.obscuration;
  return std::numbers::pi * (1.0 - e * e) / (1.0 + 4.0 * n * n);
}

double shield_sr(const Optics& optics) noexcept {
  const double n = optics.f_number;
  return std::numbers::pi * (4.0 * n * n) / (1.0 + 4.0 * n * n);
}

double band_planck(const spectral::Response& response, Kelvin temperature) {
  return band_mean(response,
                   [&](Micrometres lambda) { return spectral::planck(lambda, temperature).value; });
}

double band_planck_derivative(const spectral::Response& response, Kelvin temperature) {
  return band_mean(response, [&](Micrometres lambda) {
    return spectral::planck_derivative(lambda, temperature);
  });
}

}  // namespace nadir::sensor
