#include "sensor/detector/photon_yield.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/constants.hpp"
#include "sensor/flat_field.hpp"
#include "support/catch.hpp"

namespace nadir::sensor {
namespace {

using flat_field::clean;
using flat_field::exposure_s;
using flat_field::frame;
using flat_field::photons;
using flat_field::red;

SignalChain chain_of(const Detector& detector, const spectral::Response& response = red) {
  return {frame(8, exposure_s, response), 0, detector, 1};
}

}  // namespace

// Independent of the code: electrons wavelength by wavelength, by the midpoint rule on a radiance
// that is not constant. Gauss's quadrature is exact for it, the rule to 1e-7.
TEST_CASE("electrons are the integral of photons times efficiency", "[sensor][detector]") {
  const spectral::Curve curve{{0.5, 0.55, 0.6}, {0.2, 1.0, 0.4}, spectral::Outside::zero};
  const spectral::Response response = spectral::TabulatedResponse{curve};
  Detector detector = clean();
  detector.optics.transmittance = 0.7;
  detector.optics.obscuration = 0.3;
  double peak = 0.0;
  for (double l = 0.5; l < 0.6; l += 1e-5) peak = std::max(peak, curve.at(Micrometres{l}) / l);
  const int steps = 20000;
  double electrons = 0.0, weighted = 0.0, area = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double l = 0.5 + 0.1 * (i + 0.5) / steps, d = 0.1 / steps;
    const double r = curve.at(Micrometres{l}), radiance = 3.0 + 20.0 * l * l;
    const double irradiance = std::numbers::pi * radiance * 0.7 * (1.0 - 0.09) / (1.0 + 4.0 * 16.0);
    const double eta = 0.5 * r / l / peak;
    const double photon_j = si::planck * si::speed_of_light / (l * 1e-6);
    electrons += exposure_s * 1e-10 * irradiance * eta / photon_j * d;
    weighted += radiance * r * d;
    area += r * d;
  }
  const SignalChain chain = chain_of(detector, response);
  CHECK(chain.electrons_per_radiance() * weighted / area == Approx(electrons).epsilon(1e-5));
}

TEST_CASE("a Gaussian's yield agrees with its table's", "[sensor][detector]") {
  const double fwhm = GENERATE(0.02, 0.3, 0.8);
  const spectral::GaussianResponse g{Micrometres{1.5}, Micrometres{fwhm}};
  const spectral::Support s = spectral::support(spectral::Response{g});
  std::vector<double> w, r;
  for (int i = 0; i <= 4000; ++i) {
    w.push_back(s.lo.value + (s.hi - s.lo).value * i / 4000.0);
    r.push_back(spectral::at(spectral::Response{g}, Micrometres{w.back()}));
  }
  r.front() = r[1];  // rounding may put the ends outside
  r.back() = r[r.size() - 2];
  const spectral::Response table =
      spectral::TabulatedResponse{spectral::Curve{w, r, spectral::Outside::zero}};
  // 1e-6: the trapezoid rule's error, (step / fwhm)^2.
  CHECK(photon_yield(spectral::Response{g}).per_radiance ==
        Approx(photon_yield(table).per_radiance).epsilon(1e-5));
}

// Landsat-8 OLI, band 4, as public notes describe it: 886 mm over 135 mm, 36 um, 3.6 ms, tau 0.70,
// QE 0.80, L = 22: 127,037 electrons, shot-limited SNR 356 (sections 1.6 and 4 of the reference
// notes). 1e-3: their rounding.
TEST_CASE("the red band of an OLI counts 127,037 electrons", "[sensor][detector]") {
  Detector detector = clean(1e6);
  detector.optics.f_number = 0.886 / 0.135;
  detector.optics.transmittance = 0.70;
  photons(detector).efficiency = 0.80;
  photons(detector).area_m2 = 36e-6 * 36e-6;
  const SignalChain chain{frame(8, 3.6e-3, flat_field::constant_efficiency(0.636, 0.673)), 0,
                          detector, 1};
  const double electrons = chain.electrons_per_radiance() * 22.0;
  CHECK(electrons == Approx(127037.0).epsilon(1e-3));
  CHECK(std::sqrt(electrons) == Approx(356.0).epsilon(2e-3));
}

// Landsat-8 TIRS, band 10 (Reuter 2015, Jhabvala 2011, as cited in those notes): f/1.64, tau 0.49,
// 25 um, 3.49 ms, conversion 0.8 %, dark 4e7 e-/s, read 260 e-, well 5e6, 12 bit.
TEST_CASE("band 10 of a TIRS has a NEdT of 0.096 K", "[sensor][detector]") {
  Detector detector = clean(5e6);
  detector.optics.f_number = 1.64;
  detector.optics.transmittance = 0.49;
  detector.digitiser.bits = 12;
  PhotonDetector& element = photons(detector);
  element.efficiency = 0.008;
  element.area_m2 = 25e-6 * 25e-6;
  element.dark_e_s = 4e7;
  element.read_noise_e = 260.0;
  const spectral::Response b10 = flat_field::constant_efficiency(10.6, 11.2);
  const SignalChain chain{frame(8, 3.49e-3, b10), 0, detector, 1};
  const double radiance = band_planck(b10, Kelvin{300.0});
  // The notes give two digits.
  CHECK(chain.electrons_per_radiance() * radiance == Approx(7.2e5).epsilon(0.01));
  const double nedl = chain.noise_equivalent_radiance(radiance);
  CHECK(nedl / band_planck_derivative(b10, Kelvin{300.0}) == Approx(0.096).epsilon(0.01));
}

// The textbook's pi / (4 N^2) is too large by 1 / (4 N^2): sensors' reference notes, 1.6.
TEST_CASE("the cone of an f/1 lens is a fifth less than the textbook's", "[sensor][detector]") {
  const auto textbook = [](double n) { return std::numbers::pi / (4.0 * n * n); };
  CHECK(textbook(1.0) / cone_sr({.f_number = 1.0}) == Approx(1.25).epsilon(1e-14));
  CHECK(textbook(6.4) / cone_sr({.f_number = 6.4}) == Approx(1.0061).epsilon(1e-4));
  // Lens and shield together fill the half space.
  CHECK(cone_sr({.f_number = 1.3}) + shield_sr({.f_number = 1.3}) ==
        Approx(std::numbers::pi).epsilon(1e-14));
}

// A cavity: scene, lens and shield all at one temperature. With a perfect detector (no filter) the
// lens's own light makes up for what it does not transmit: as many electrons as without a lens.
TEST_CASE("inside a cavity a lens cannot be seen", "[sensor][detector]") {
  const spectral::Response band = spectral::BoxResponse{Micrometres{8.0}, Micrometres{12.0}};
  const double radiance = band_planck(band, Kelvin{290.0});
  const auto total = [&](double transmittance) {
    Detector detector = clean(1e12);
    detector.optics.transmittance = transmittance;
    detector.optics.emissivity = 1.0 - transmittance;
    detector.optics.temperature_k = 290.0;
    detector.optics.shield_temperature_k = 290.0;
    const SignalChain chain = chain_of(detector, band);
    return chain.electrons_per_radiance() * radiance + chain.background_electrons();
  };
  CHECK(total(0.6) == Approx(total(1.0)).epsilon(1e-13));
  // ... and the half space: pi B t A eta yield.
  const double expected =
      std::numbers::pi * radiance * exposure_s * 1e-10 * 0.5 * photon_yield(band).per_radiance;
  CHECK(total(0.6) == Approx(expected).epsilon(1e-13));
}

TEST_CASE("a cold filter takes from the lens's light as from the scene's", "[sensor][detector]") {
  const spectral::Response band = spectral::BoxResponse{Micrometres{8.0}, Micrometres{12.0}};
  const auto background = [&](double transmittance) {
    Detector detector = clean(1e12);
    detector.optics.transmittance = transmittance;
    detector.optics.emissivity = 0.2;
    detector.optics.temperature_k = 290.0;
    return chain_of(detector, band).background_electrons();
  };
  CHECK(background(0.4) == Approx(0.5 * background(0.8)).epsilon(1e-13));
}

TEST_CASE("dark current doubles with its temperature", "[sensor][detector]") {
  Detector detector = clean();
  photons(detector).dark_e_s = 5e4;
  photons(detector).dark_doubling_k = 6.0;
  CHECK(chain_of(detector).background_electrons() == Approx(100.0).epsilon(1e-13));
  photons(detector).temperature_k += 12.0;
  CHECK(chain_of(detector).background_electrons() == Approx(400.0).epsilon(1e-13));
}

TEST_CASE("time-delay integration multiplies signal, dark and own light", "[sensor][detector]") {
  Detector detector = clean();
  photons(detector).dark_e_s = 5e4;
  DetectorArray array = frame(8, exposure_s, red);
  array.timing.scan = Pushbroom{0.0, exposure_s};
  const SignalChain one{array, 0, detector, 1};
  array.timing.tdi_stages = 16;
  const SignalChain many{array, 0, detector, 1};
  CHECK(many.electrons_per_radiance() ==
        Approx(16.0 * one.electrons_per_radiance()).epsilon(1e-14));
  CHECK(many.background_electrons() == Approx(16.0 * one.background_electrons()).epsilon(1e-14));
}

}  // namespace nadir::sensor
