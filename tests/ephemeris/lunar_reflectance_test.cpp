#include "ephemeris/lunar_reflectance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "support/catch.hpp"

namespace {

using namespace nadir;
using namespace nadir::ephemeris;
using spectral::Curve;
using spectral::Outside;

// Three bands of the paper's table 4: the ends and 549.1 nm. The shipped table is tested where it
// is read.
const LunarBand ultraviolet{Micrometres{0.35},
                            {-2.67511, -1.78539, 0.50612, -0.25578},
                            {0.03744, 0.00981, -0.00322},
                            {0.34185, 0.01441, -0.01602},
                            1.0301};
const LunarBand green{Micrometres{0.5491},
                      {-2.10782, -1.66736, 0.41697, -0.22026},
                      {0.03451, 0.01452, -0.00517},
                      {0.36814, -0.09815, -0.0},
                      0.9843};
const LunarBand infrared{Micrometres{2.3836},
                         {-1.08403, -1.31032, 0.20323, -0.15863},
                         {0.05955, -0.0094, 0.00083},
                         {0.36134, -0.28408, 0.0101},
                         0.9689};
const LunarModel model{{ultraviolet, green, infrared}};

/// The sun over the moon's equator, the observer over its middle, at the mean distances.
LunarGeometry at_phase(double phase_deg, double side = -1.0) {
  return {degrees(phase_deg),
          {degrees(side * phase_deg), Angle{0.0}},
          {},
          Metres{astro::astronomical_unit_m},
          Metres{LunarModel::mean_distance_m}};
}

double green_at(double phase_deg, double side = -1.0) {
  return disc_reflectance(green, at_phase(phase_deg, side));
}

}  // namespace

// Figures of an independent evaluation of the paper's equation 10 (waning, no libration), four
// digits: 1 % of the smallest is half a unit of its last.
TEST_CASE("the moon's reflectance at 549 nm is the ROLO model's", "[ephemeris][lunar]") {
  CHECK(green_at(2.0) == Approx(0.1319).epsilon(0.001));
  CHECK(green_at(7.0) == Approx(0.1001).epsilon(0.001));
  CHECK(green_at(30.0) == Approx(0.0535).epsilon(0.001));
  CHECK(green_at(60.0) == Approx(0.0248).epsilon(0.003));
  CHECK(green_at(90.0) == Approx(0.0099).epsilon(0.006));
}

// By hand: ln A less its libration's terms, with theta = -5, phi = 6 degrees, Phi = 0.5 rad:
// 0.00034115 (-5) - 0.0013425 6 + 0.00095906 0.5 (-5) + 0.00066229 0.5 6 = -0.01017153.
TEST_CASE("libration changes the moon by a hundredth", "[ephemeris][lunar]") {
  LunarGeometry turned = at_phase(30.0);
  turned.sun.longitude = Angle{0.5};
  const double without = disc_reflectance(green, turned);
  turned.observer = {degrees(6.0), degrees(-5.0)};
  CHECK(std::log(disc_reflectance(green, turned) / without) == Approx(-0.01017153).epsilon(1e-6));
}

// Known since the 19th century: the western maria face the sun after full moon. The even terms of
// Phi vanish, so the ratio is exp(2 sum b_j Phi^(2j-1)), 1.10 at 60 degrees.
TEST_CASE("the waxing moon is brighter than the waning", "[ephemeris][lunar]") {
  const double x = degrees(60.0).value;
  const double odd = 0.03451 * x + 0.01452 * std::pow(x, 3) - 0.00517 * std::pow(x, 5);
  CHECK(green_at(60.0, 1.0) / green_at(60.0) == Approx(std::exp(2.0 * odd)).epsilon(1e-12));
  CHECK(green_at(60.0, 1.0) / green_at(60.0) > 1.05);
}

TEST_CASE("the model goes on without a step beyond its phases", "[ephemeris][lunar]") {
  CHECK(green_at(1.0) == Approx(green_at(rolo_first_phase_deg)).epsilon(0.002));  // Phi's own share
  CHECK(green_at(97.0 + 1e-9) == Approx(green_at(97.0)).epsilon(1e-8));
  CHECK(crescent(degrees(97.0)) == Approx(1.0).epsilon(1e-12));
  CHECK(crescent(degrees(150.0 + 1e-9)) == Approx(crescent(degrees(150.0))).epsilon(1e-8));
  CHECK(crescent(degrees(180.0)) == 0.0);
  CHECK(green_at(180.0) == 0.0);
  double previous = green_at(1.55);
  for (double phase_deg = 1.6; phase_deg <= 180.0; phase_deg += 0.1) {
    CAPTURE(phase_deg);
    const double now = green_at(phase_deg);
    REQUIRE(now < previous);
    REQUIRE(now >= 0.0);
    previous = now;
  }
}

// Krisciunas and Schaefer 1991: from 97 to 150 degrees 1.378 + 4e-9 (150^4 - 97^4) = 3.049 mag.
TEST_CASE("the crescent fades as observed", "[ephemeris][lunar]") {
  CHECK(-2.5 * std::log10(crescent(degrees(150.0))) == Approx(3.0489).epsilon(1e-4));
  // A thin crescent of a Lommel-Seeliger sphere: light as the square of what is left of 180
  // degrees.
  CHECK(crescent(degrees(178.0)) / crescent(degrees(179.0)) == Approx(4.0).epsilon(1e-3));
}

TEST_CASE("the moon's irradiance follows both distances", "[ephemeris][lunar]") {
  const Curve flat = Curve::constant(1800.0);
  const LunarGeometry mean = at_phase(7.0);
  LunarGeometry other = mean;
  other.sun_distance = 1.02 * mean.sun_distance;
  other.observer_distance = 0.94 * mean.observer_distance;
  const double e = lunar_irradiance(model, mean, flat).irradiance.at(0.5491_um);
  // A Omega / pi E: the paper's equation 7
  CHECK(e == Approx(green_at(7.0) * 0.9843 * 6.4177e-5 / std::numbers::pi * 1800.0).epsilon(1e-12));
  CHECK(lunar_irradiance(model, other, flat).irradiance.at(0.5491_um) ==
        Approx(e / (1.02 * 1.02 * 0.94 * 0.94)).epsilon(1e-12));
}

TEST_CASE("outside the bands the reflectance is continued as documented", "[ephemeris][lunar]") {
  const Curve a = disc_reflectance(model, at_phase(20.0));
  const double first = a.at(0.35_um), last = a.at(2.3836_um);
  CHECK(first == Approx(disc_reflectance(ultraviolet, at_phase(20.0)) * 1.0301).epsilon(1e-12));
  CHECK(a.at(0.30_um) == Approx(first * (1.0 + ultraviolet_share) / 2.0).epsilon(1e-12));
  CHECK(a.at(0.25_um) == Approx(first * 0.63).epsilon(1e-12));
  CHECK(a.at(0.21_um) == Approx(first * 0.63).epsilon(1e-12));
  CHECK(a.at(14.0_um) == last);
  // The irradiance keeps the sun's table, its ends and its rule beyond them.
  const Curve sun{{0.3, 0.5, 5.0}, {500.0, 1900.0, 4.0}, Outside::reject};
  const Curve moon = lunar_irradiance(model, at_phase(20.0), sun).irradiance;
  CHECK(moon.first() == 0.3_um);
  CHECK(moon.last() == 5.0_um);
  CHECK(std::isnan(moon.at(6.0_um)));
}

TEST_CASE("what was continued is said", "[ephemeris][lunar]") {
  const Curve flat = Curve::constant(1.0);
  const std::string bands =
      "the moon's reflectance is modelled from 0.35 to 2.3836 um: below, it falls to 0.63 of that "
      "at 0.25 um; beyond, it is held";
  CHECK(lunar_irradiance(model, at_phase(20.0), flat).notes == std::vector<std::string>{bands});
  const auto small = lunar_irradiance(model, at_phase(1.0), flat).notes;
  REQUIRE(small.size() == 2);
  CHECK(small[1].find("below the model's 1.55: its reflectance is that at 1.55 deg") !=
        std::string::npos);
  const auto large = lunar_irradiance(model, at_phase(120.0), flat).notes;
  REQUIRE(large.size() == 2);
  CHECK(large[1].find("above the model's 97: its light falls off as a crescent's") !=
        std::string::npos);
}

TEST_CASE("a model out of order is refused", "[ephemeris][lunar]") {
  CHECK_THROWS_WITH(checked(LunarModel{{green}}),
                    "error: the model of the moon's reflectance has fewer than two bands\n");
  CHECK_THROWS_WITH(checked(LunarModel{{infrared, green}}),
                    "error: the model of the moon's reflectance has bands whose wavelengths do not "
                    "ascend, at 0.5491 um\n");
  LunarBand early = ultraviolet;
  early.wavelength = 0.2_um;
  CHECK_THROWS_WITH(checked(LunarModel{{early, green}}),
                    "error: the model of the moon's reflectance has a band at or below 0.25 um\n");
}
