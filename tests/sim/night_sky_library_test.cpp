// The night sky's spectra that ship under scenes/library/illumination/.
#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include "sim/files/spectrum_file.hpp"
#include "spectral/luminous_efficiency.hpp"
#include "support/catch.hpp"

using namespace nadir;
using spectral::Curve;

namespace {

Curve shipped_night_sky(const std::string& name) {
  const auto file =
      std::filesystem::path{NADIR_SOURCE_DIR} / "scenes/library/illumination" / (name + ".csv");
  return sim::read_curve(file, "", sim::SpectrumQuantity::radiance, spectral::Outside::reject);
}

/// cd m^-2 of a sky of so many V mag arcsec^-2: 10.8e4 * 10^(-0.4 V), the usual conversion of sky
/// brightness meters.
double luminance(double magnitude) { return 10.8e4 * std::pow(10.0, -0.4 * magnitude); }

}  // namespace

TEST_CASE("the natural night sky has its magnitude and its shares in V", "[sim][library]") {
  const double airglow = shipped_night_sky("night_airglow").at(0.545_um);
  const double starlight = shipped_night_sky("night_starlight").at(0.545_um);
  // 21.9 mag arcsec^-2 of 363.1e-11 erg s^-1 cm^-2 A^-1 (Bessell et al. 1998), in SI
  const double arcsec_sr = std::pow(std::acos(-1.0) / 180.0 / 3600.0, 2.0);
  const double expected = 363.1e-11 * 10.0 * std::pow(10.0, -0.4 * 21.9) / arcsec_sr;
  CHECK(airglow + starlight == Approx(expected).epsilon(1e-3));  // a row lies 0.005 um away
  CHECK(airglow / (airglow + starlight) == Approx(145.0 / 220.0).epsilon(5e-3));  // 65 of 99 %
}

TEST_CASE("the night sky's luminance is that of its magnitude", "[sim][library]") {
  const double natural = spectral::luminous(shipped_night_sky("night_airglow")) +
                         spectral::luminous(shipped_night_sky("night_starlight"));
  // 10 %: V's band is not the eye's, and the sky is not grey
  CHECK(natural == Approx(luminance(21.9)).epsilon(0.1));
  const double town = spectral::luminous(shipped_night_sky("night_suburban_glow"));
  // 20 %: warm light gives the eye, whose band lies 0.014 um to the red, more than V (measured 15
  // %)
  CHECK(natural + town == Approx(luminance(19.5)).epsilon(0.2));
}

TEST_CASE("the natural night sky is about as bright as over Cerro Tololo", "[sim][library]") {
  // NOAO's table of sky brightness at new moon, from erg s^-1 cm^-2 A^-1 arcsec^-2
  const std::map<double, double> tololo{
      {0.36, 2.82e-6}, {0.44, 2.33e-6}, {0.55, 2.92e-6}, {0.64, 4.19e-6}, {0.79, 5.71e-6}};
  const Curve airglow = shipped_night_sky("night_airglow"),
              starlight = shipped_night_sky("night_starlight");
  for (const auto& [um, radiance] : tololo) {
    CAPTURE(um);
    const Micrometres at{um};
    // 30 %: airglow varies more from night to night
    CHECK(airglow.at(at) + starlight.at(at) == Approx(radiance).epsilon(0.3));
  }
}

TEST_CASE("airglow peaks where OH does and ends before the thermal sky", "[sim][library]") {
  const Curve airglow = shipped_night_sky("night_airglow");
  CHECK(airglow.at(1.6_um) == airglow.max_value());
  CHECK(airglow.at(1.6_um) > 30.0 * airglow.at(0.55_um));
  for (const std::string name : {"night_airglow", "night_starlight", "night_suburban_glow"}) {
    CAPTURE(name);
    CHECK(shipped_night_sky(name).covers(0.3_um, 14.0_um));
    CHECK(shipped_night_sky(name).min_value() == 0.0);
    CHECK(shipped_night_sky(name).at(3.0_um) == 0.0);
  }
}
