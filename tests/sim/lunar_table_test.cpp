#include "sim/files/lunar_table.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "sim/files/spectrum_file.hpp"
#include "support/catch.hpp"

namespace {

using namespace nadir;
using ephemeris::LunarBand;
using ephemeris::LunarGeometry;
using ephemeris::LunarModel;

const std::string lunar_table_library = NADIR_SOURCE_DIR "/scenes/library/illumination/";

const LunarModel& shipped_lunar_table() {
  static const LunarModel model = sim::read_lunar_model(lunar_table_library + "moon.csv");
  return model;
}

LunarGeometry waning(double phase_deg) {
  return {degrees(phase_deg),
          {degrees(-phase_deg), Angle{0.0}},
          {},
          Metres{astro::astronomical_unit_m},
          Metres{LunarModel::mean_distance_m}};
}

double lunar_table_reflectance(const LunarModel& model, double um, double phase_deg) {
  const auto band = std::find_if(model.bands.begin(), model.bands.end(), [&](const LunarBand& b) {
    return std::abs(b.wavelength.value - um) < 1e-6;
  });
  REQUIRE(band != model.bands.end());
  return ephemeris::disc_reflectance(*band, waning(phase_deg));
}

std::string table(const std::string& header, const std::string& rows) {
  return "# nadir-spectrum: 1\n# title: moon\n# quantity: parameter\n# unit: 1\n# wavelength: um, "
         "vacuum\n# source: a test\n# licence: none\n# made-by: hand\n" +
         header + rows;
}

}  // namespace

// Kieffer and Stone 2005 give 32 bands from 350 to 2383.6 nm. Reflectances at 549.1 nm by an
// independent evaluation, four digits.
TEST_CASE("the shipped bands of the moon are the ROLO model's", "[sim][lunar]") {
  REQUIRE(shipped_lunar_table().bands.size() == 32);
  CHECK(shipped_lunar_table().bands.front().wavelength == 0.35_um);
  CHECK(shipped_lunar_table().bands.back().wavelength == 2.3836_um);
  const double phases[] = {2.0, 7.0, 30.0, 60.0, 90.0};
  const double published[] = {0.1319, 0.1001, 0.0535, 0.0248, 0.0099};
  for (std::size_t i = 0; i < 5; ++i) {
    CAPTURE(phases[i]);
    CHECK(lunar_table_reflectance(shipped_lunar_table(), 0.5491, phases[i]) ==
          Approx(published[i]).epsilon(0.006));
  }
}

// The smoothing is what makes one spectrum of 32 instruments' bands: without it neighbours differ
// by up to 14 %.
TEST_CASE("the moon's spectrum is smooth and reddens", "[sim][lunar]") {
  const double phase_deg = GENERATE(2.0, 30.0, 90.0);
  const spectral::Curve a = ephemeris::disc_reflectance(shipped_lunar_table(), waning(phase_deg));
  const auto& um = a.wavelengths_um();
  const auto& value = a.values();
  for (std::size_t i = 2; i < um.size(); ++i) {
    CAPTURE(phase_deg, um[i]);
    // steepest in the ultraviolet at large phase: 16 % for each 10 % of wavelength
    const double steps = std::log(um[i] / um[i - 1]) / std::log(1.1);
    CHECK(value[i] / value[i - 1] > 0.96);
    CHECK(value[i] / value[i - 1] < 1.04 + 0.16 * steps);
  }
  CHECK(a.at(2.0_um) > 1.8 * a.at(0.55_um));
  CHECK(a.at(0.40_um) < 0.85 * a.at(0.55_um));
}

// 5.2e-6 and 3.9e-7 W m^-2 nm^-1 at 2 and 90 degrees by the independent evaluation, with the 1 nm
// solar spectrum and the band as it is; here the smoothed band (0.9843) and 5 nm of sun.
TEST_CASE("the moon's irradiance is the ROLO model's", "[sim][lunar]") {
  const auto sun = sim::read_curve(lunar_table_library + "solar.csv", "",
                                   sim::SpectrumQuantity::irradiance, spectral::Outside::reject);
  const auto e = [&](double phase_deg) {
    return ephemeris::lunar_irradiance(shipped_lunar_table(), waning(phase_deg), sun)
        .irradiance.at(0.5491_um);
  };
  CHECK(e(2.0) == Approx(5.2e-3 * 0.9843).epsilon(0.02));
  CHECK(e(90.0) == Approx(3.9e-4 * 0.9843).epsilon(0.02));
  CHECK(e(2.0) / sun.at(0.5491_um) == Approx(2.7e-6).epsilon(0.02));
}

TEST_CASE("a table of the moon that lacks something is refused", "[sim][lunar]") {
  const std::string all = "wavelength_um,a0,a1,a2,a3,b1,b2,b3,d1,d2,d3,smoothing\n";
  const std::string row = ",-2,-1.7,0.4,-0.2,0.03,0.01,0,0.3,-0.1,0,1\n";
  CHECK(sim::parse_lunar_model(table(all, "0.5" + row + "0.6" + row), "moon.csv").bands.size() ==
        2);
  CHECK_THROWS_WITH(
      sim::parse_lunar_model(
          table(all, "0.5" + row + "0.6,-2,,0.4,-0.2,0.03,0.01,0,0.3,-0.1,0,1\n" + "0.7" + row),
          "moon.csv"),
      "moon.csv: error: column \"a1\" has not the wavelengths of column \"a0\": every band needs "
      "every coefficient\n");
  const std::string few = "wavelength_um,a0,a1,a2,a3,b1,b2,b3,d1,d2,d3\n";
  CHECK_THROWS_AS(
      sim::parse_lunar_model(table(few, "0.5,1,1,1,1,1,1,1,1,1,1\n0.6,1,1,1,1,1,1,1,1,1,1\n"), "m"),
      InputError);
}
