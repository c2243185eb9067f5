#include "sensor/detector/figures.hpp"

#include <cmath>
#include <numbers>

#include "sensor/detector/photon_yield.hpp"
#include "sensor/flat_field.hpp"
#include "spectral/band_quadrature.hpp"
#include "support/catch.hpp"

namespace nadir::sensor {
namespace {

const spectral::Response long_wave = spectral::BoxResponse{Micrometres{7.5}, Micrometres{13.5}};

/// An uncooled camera by its data sheet: noise of 0.05 K at 300 K, by bolometers.
Detector uncooled() {
  const double nedl = 0.05 * band_planck_derivative(long_wave, Kelvin{300.0});
  Detector detector;
  detector.element = fit_noise({{band_planck(long_wave, Kelvin{300.0}), nedl}});
  detector.digitiser = {.bits = 14};
  detector.digitiser.saturation = band_planck(long_wave, Kelvin{420.0});
  return detector;
}

/// A cooled one by its physics, with warm optics.
Detector cooled() {
  PhotonDetector element;
  element.efficiency = 0.6;
  element.area_m2 = 6.25e-10;
  element.dark_e_s = 1e9;
  element.read_noise_e = 500.0;
  element.full_well_e = 1e7;
  Detector detector;
  detector.optics = {.f_number = 2.0,
                     .transmittance = 0.8,
                     .temperature_k = 290.0,
                     .emissivity = 0.1,
                     .shield_temperature_k = 80.0};
  detector.element = element;
  detector.digitiser.bits = 14;
  return detector;
}

/// Standard deviation of the brightness temperature of an even field at 300 K, K.
double measured_nedt(const DetectorArray& array, const Detector& detector) {
  const spectral::Response& response = array.bands.front().response;
  const spectral::BandQuadrature band = spectral::gauss_quadrature(response, 8);
  const Calibration back = SignalChain{array, 0, detector, 1}.calibration();
  const auto image = flat_field::expose(array, detector, band_planck(response, Kelvin{300.0}), 11);
  Welford temperature;
  for (const auto dn : image.dn) {
    const SpectralRadiance radiance{back.gain * dn + back.offset};
    temperature.add(spectral::band_brightness_temperature(band, radiance).value);
  }
  return std::sqrt(temperature.variance());
}

}  // namespace

// FLIR, "What is the sensitivity of Tau cameras in watts per m2?": 50 mK at f/1 are less than
// 0.14 W m^-2 in 7.5 .. 13.5 um. dM/dT at 300 K = 2.772 W m^-2 K^-1, half a unit of its last digit.
TEST_CASE("fifty millikelvin are 0.139 W per square metre", "[sensor][detector]") {
  const double exitance = std::numbers::pi * 6.0 * band_planck_derivative(long_wave, Kelvin{300.0});
  CHECK(exitance == Approx(2.772).margin(0.0005));
  CHECK(0.05 * exitance == Approx(0.139).margin(0.0005));
  const double nedl = 0.139 / (std::numbers::pi * 6.0);
  CHECK(nedt(long_wave, nedl, Kelvin{300.0}).value == Approx(0.0501).margin(0.0001));
}

// 16,384 pixels: the standard deviation to 0.55 %; 3 % is what is asked for. The slope of Planck's
// law changes by 1e-4 over one standard deviation of the temperature.
TEST_CASE("the NEdT of an image of a 300 K field is the one that is predicted",
          "[sensor][detector]") {
  const bool by_physics = GENERATE(true, false);
  const Detector detector = by_physics ? cooled() : uncooled();
  const DetectorArray array = flat_field::frame(128, by_physics ? 4e-5 : 0.0, long_wave);
  const SignalChain chain{array, 0, detector, 1};
  const double radiance = band_planck(long_wave, Kelvin{300.0});
  REQUIRE(radiance < chain.saturation_radiance());
  const double predicted =
      nedt(long_wave, chain.noise_equivalent_radiance(radiance), Kelvin{300.0}).value;
  if (!by_physics) CHECK(predicted == Approx(0.05).epsilon(1e-12));
  CHECK(measured_nedt(array, detector) == Approx(predicted).epsilon(0.03));
}

}  // namespace nadir::sensor
