#include "spectral/planck.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/constants.hpp"
#include "spectral/band_quadrature.hpp"
#include "support/catch.hpp"

// Planck's law and its inverses from absolute zero to 1e5 K, far beyond the wavelengths of a scene.

namespace nadir::spectral {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// In long double, whose exponent is wide enough for what double is not.
long double reference(double wavelength_um, double kelvin) {
  const long double l = wavelength_um;
  const long double x = static_cast<long double>(si::radiation_c2) / (l * kelvin);
  return static_cast<long double>(si::radiation_c1) / (l * l * l * l * l) / std::expm1(x);
}

TEST_CASE("Planck: finite, not negative and growing from 0 K to 1e5 K, 1 nm to 1 cm",
          "[hard][planck]") {
  for (const double wavelength : {1e-3, 0.2, 0.3, 1.0, 3.9, 10.0, 14.0, 100.0, 1e4}) {
    double before = -1.0;
    for (const double kelvin : {0.0, 1e-300, 1e-6, 2.7, 3.0, 150.0, 300.0, 2000.0, 6000.0, 1e5}) {
      const double radiance = planck(Micrometres{wavelength}, Kelvin{kelvin}).value;
      CAPTURE(wavelength, kelvin, radiance);
      CHECK(std::isfinite(radiance));
      CHECK(radiance >= 0.0);
      CHECK(radiance >= before);
      before = radiance;
      if (radiance > 1e-290) {
        const double x = si::radiation_c2 / (wavelength * kelvin);
        CHECK(radiance == Approx(static_cast<double>(reference(wavelength, kelvin)))
                              .epsilon(1e-15 + 4e-16 * x));  // the stated accuracy
      }
      const double slope = planck_derivative(Micrometres{wavelength}, Kelvin{kelvin});
      CHECK(std::isfinite(slope));
      CHECK(slope >= 0.0);
    }
  }
}

TEST_CASE("Planck: 3 K at 0.3 um is exactly 0, as a float lane and as a double", "[hard][planck]") {
  CHECK(planck(0.3_um, 3.0_K).value == 0.0);  // exp(-16000): no floating-point number holds it
  CHECK(planck(Lanes{{0.3_um, 14.0_um}}, 3.0_K)[0] == 0.0F);
  CHECK(planck_derivative(0.3_um, 3.0_K) == 0.0);
}

TEST_CASE("Planck: the inverse gives the temperature back wherever the radiance is a number",
          "[hard][planck]") {
  for (const double wavelength : {0.3, 1.0, 3.9, 10.0, 14.0, 1e3}) {
    for (const double kelvin : {0.0, 3.0, 30.0, 150.0, 300.0, 6000.0, 1e5}) {
      const SpectralRadiance radiance = planck(Micrometres{wavelength}, Kelvin{kelvin});
      const double back = brightness_temperature(Micrometres{wavelength}, radiance).value;
      CAPTURE(wavelength, kelvin, radiance.value);
      if (radiance.value == 0.0) {
        CHECK(back == 0.0);
      } else if (radiance.value > 1e-290) {
        CHECK(back == Approx(kelvin).epsilon(1e-14));
      }
    }
  }
}

TEST_CASE("Planck: the smallest and the largest double have a brightness temperature",
          "[hard][planck]") {
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  double before = 0.0;
  for (const double radiance : {smallest, 1e-300, 1e-30, 1.0, 1e30, 1e300}) {
    const double kelvin = brightness_temperature(10.0_um, SpectralRadiance{radiance}).value;
    CHECK(std::isfinite(kelvin));
    CHECK(kelvin > before);
    before = kelvin;
  }
}

TEST_CASE("Planck: all wavelengths together are sigma T^4 / pi from 3 K to 1e5 K",
          "[hard][planck]") {
  CHECK(planck_band(0.3_um, 14.0_um, 0.0_K).value == 0.0);
  CHECK(planck_band(5.0_um, 5.0_um, 300.0_K).value == 0.0);
  for (const double kelvin : {3.0, 300.0, 6000.0, 1e5}) {
    const double all = planck_band(Micrometres{0.0}, Micrometres{infinity}, Kelvin{kelvin}).value;
    const double law = si::stefan_boltzmann * std::pow(kelvin, 4) / std::numbers::pi;
    CHECK(all == Approx(law).epsilon(1e-12));
    const double parts = planck_band(Micrometres{0.0}, 1.0_um, Kelvin{kelvin}).value +
                         planck_band(1.0_um, 14.0_um, Kelvin{kelvin}).value +
                         planck_band(14.0_um, Micrometres{infinity}, Kelvin{kelvin}).value;
    CHECK(parts == Approx(law).epsilon(1e-12));
  }
}

TEST_CASE("Planck: a band as narrow as doubles allow is its width times the radiance",
          "[hard][planck]") {
  for (const double kelvin : {3.0, 300.0, 6000.0}) {
    const double lo = 10.0, hi = std::nextafter(10.0, 11.0);
    const double band = planck_band(Micrometres{lo}, Micrometres{hi}, Kelvin{kelvin}).value;
    const double radiance = planck(Micrometres{lo}, Kelvin{kelvin}).value;
    CAPTURE(kelvin);
    CHECK(band == Approx(radiance * (hi - lo)).epsilon(1e-12));
  }
}

TEST_CASE("Planck: a band's brightness temperature is that of the black body, 3 K to 1e5 K",
          "[hard][planck]") {
  const BandQuadrature band = gauss_quadrature(BoxResponse{8.0_um, 14.0_um}, 8);
  for (const double kelvin : {3.0, 300.0, 6000.0, 1e5}) {
    double radiance = 0.0;
    for (std::size_t i = 0; i < band.weights.size(); ++i) {
      radiance += band.weights[i] * planck(band.wavelengths[i], Kelvin{kelvin}).value;
    }
    CHECK(band_brightness_temperature(band, SpectralRadiance{radiance}).value ==
          Approx(kelvin).epsilon(1e-13));
  }
  CHECK(band_brightness_temperature(band, SpectralRadiance{0.0}).value == 0.0);
}

TEST_CASE("Planck: what has no meaning is NaN, not a number that looks like one",
          "[hard][planck]") {
  CHECK(std::isnan(planck(10.0_um, Kelvin{-1.0}).value));
  CHECK(std::isnan(planck(Micrometres{0.0}, 300.0_K).value));
  CHECK(std::isnan(planck(Micrometres{-1.0}, 300.0_K).value));
  CHECK(std::isnan(planck_band(10.0_um, 9.0_um, 300.0_K).value));
  CHECK(std::isnan(brightness_temperature(10.0_um, SpectralRadiance{-1e-300}).value));
}

}  // namespace
}  // namespace nadir::spectral
