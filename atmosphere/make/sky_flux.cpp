#include "atmosphere/make/sky_flux.hpp"

#include <cmath>
#include <numbers>

namespace nadir::atmosphere {
namespace {

using std::numbers::pi;

/// @param mean  radiance by zenith node, averaged over azimuth
double flux(const std::vector<double>& zenith_rad, const std::vector<double>& mean) {
  double sum = 0.0;
  for (std::size_t i = 1; i < zenith_rad.size(); ++i) {
    const double a = std::sin(zenith_rad[i - 1]), b = std::sin(zenith_rad[i]);
    sum += 0.5 * (mean[i - 1] + mean[i]) * (b * b - a * a);
  }
  return pi * sum;
}

}  // namespace

double body_sky_flux(const LaneFields& fields, const ViewShape& shape, const LaneView& sky,
                     const LaneFields::Beam& beam) {
  const std::size_t azimuths = shape.azimuth_rad.size(), kinds = fields.phases.size();
  const std::size_t places = shape.places();
  std::vector<double> mean;
  for (std::size_t z = 0; z < shape.zenith_rad.size(); ++z) {
    double sum = 0.0;
    for (std::size_t a = 0; a < azimuths; ++a) {
      double light = static_cast<double>(sky.smooth[(beam.body * azimuths + a) * places + z]);
      const double cosine =
          scattering_cosine(shape.zenith_rad[z], shape.azimuth_rad[a], beam.place);
      for (std::size_t k = 0; k < kinds; ++k) {
        light += static_cast<double>(sky.first[(beam.body * kinds + k) * places + z]) *
                 fields.phases[k]->at(cosine);
      }
      sum += light * (a == 0 || a + 1 == azimuths ? 0.5 : 1.0);
    }
    mean.push_back(azimuths > 1 ? sum / static_cast<double>(azimuths - 1) : 2.0 * sum);
  }
  return flux(shape.zenith_rad, mean);
}

}  // namespace nadir::atmosphere
