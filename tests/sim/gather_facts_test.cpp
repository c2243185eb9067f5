#include "sim/run/gather_facts.hpp"

#include <cmath>

#include "scenario_support.hpp"
#include "sim/files/data_directory.hpp"
#include "sim/files/spectrum_file.hpp"
#include "sim/plan/light_envelope.hpp"
#include "sim/run/surface_facts.hpp"
#include "spectral/planck.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

TEST_CASE("the sun's envelope holds the library's sun from 0.3 to 14 um", "[effects][facts]") {
  const auto sun = read_curve(data_directory() / "library/illumination/solar.csv", "",
                              SpectrumQuantity::irradiance, spectral::Outside::reject);
  double most = 0.0;
  for (std::size_t i = 0; i < sun.wavelengths_um().size(); ++i) {
    const double um = sun.wavelengths_um()[i];
    if (um < 0.3 || um > 14.0) continue;
    most = std::max(most, sun.values()[i] / sun_envelope(Micrometres{um}));
  }
  CHECK(most <= 1.0);
  CHECK(most > 0.8);  // and is no idle bound
}

TEST_CASE("the moon's envelope falls with its phase and holds the full moon", "[effects][facts]") {
  // 2.8e-6 of the sun's 1870 at 0.55 um (load_light.cpp)
  CHECK(moon_envelope(Micrometres{0.55}, Angle{0.0}) > 2.8e-6 * 1870.0);
  CHECK(moon_envelope(Micrometres{0.55}, degrees(90.0)) <
        0.5 * moon_envelope(Micrometres{0.55}, Angle{0.0}));
}

TEST_CASE("stated temperatures bound emission, weather's by what weather can do",
          "[effects][facts]") {
  Scenario scenario;
  scenario.materials.resize(1);
  scenario.materials[0].temperature = ConstantTemperatureInput{300.0};
  SurfaceWarmth warmth = surface_warmth(scenario, {}, false);
  CHECK(warmth.coldest == 300.0);
  CHECK(warmth.warmest == 300.0);
  CHECK(warmth.warmest_solved == 0.0);
  scenario.materials[0].temperature = HeatBalanceInput{};
  ClearSkyInput day;
  day.air_low_k = 280.0;
  day.air_high_k = 300.0;
  scenario.heat.emplace().weather = day;
  warmth = surface_warmth(scenario, {}, false);
  CHECK(warmth.coldest == 240.0);
  CHECK(warmth.warmest_solved >= 400.0);
  CHECK(surface_warmth(scenario, {}, true).warmest_solved <= warmth.warmest_solved);
}

TEST_CASE("a curve's range within a band has its ends and its knots", "[effects][facts]") {
  const spectral::Curve curve{
      {0.4, 0.5, 0.6, 0.7}, {0.1, 0.9, 0.0, 0.5}, spectral::Outside::reject};
  const CurveRange range = range_within(curve, {0.45, 0.55});
  CHECK(range.least == Approx(0.45).epsilon(1e-9));
  CHECK(range.greatest == 0.9);
  CHECK(std::isnan(range_within(curve, {0.3, 0.5}).least));
}

TEST_CASE("Planck's radiance is bounded over a band, its peak within", "[effects][facts]") {
  const BandEnds band{8.0, 12.0};  // the peak of 290 K is at 9.99 um
  const double most = greatest_planck(band, 290.0), least = least_planck(band, 290.0);
  for (double um = 8.0; um <= 12.0; um += 0.01) {
    const double here = spectral::planck(Micrometres{um}, Kelvin{290.0}).value;
    CHECK(here <= most * (1.0 + 1e-9));
    CHECK(here >= least * (1.0 - 1e-9));
  }
  CHECK(greatest_planck(band, 0.0) == 0.0);
}
