#include "sensor/detector/figures.hpp"

#include "sensor/detector/photon_yield.hpp"

namespace nadir::sensor {

Kelvin nedt(const spectral::Response& band, double nedl, Kelvin scene) {
  return Kelvin{nedl / band_planck_derivative(band, scene)};
}

}  // namespace nadir::sensor
