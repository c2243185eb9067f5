#include "thermal/weather/sky_long_wave.hpp"

#include <cmath>

#include "core/constants.hpp"
#include "core/random.hpp"
#include "support/catch.hpp"
#include "thermal/surface/humidity.hpp"

namespace nadir::thermal {
namespace {

constexpr ClearSkyFormula every_clear[] = {ClearSkyFormula::brutsaert, ClearSkyFormula::swinbank,
                                           ClearSkyFormula::idso, ClearSkyFormula::prata};
constexpr CloudFormula every_cloud[] = {CloudFormula::unsworth_monteith,
                                        CloudFormula::sugita_brutsaert};

double black_w_m2(double t) { return si::stefan_boltzmann * t * t * t * t; }

// The formulas worked by hand for 288.15 K and 10 hPa: (10/288.15)^(1/7) = 0.618704;
// 5.31e-13/5.670374e-8 * 288.15^2 = 0.777535; exp(1500/288.15) = 182.2948;
// w = 1.613743, exp(-sqrt(6.041229)) = 0.08561532.
TEST_CASE("each clear sky has its author's emissivity", "[thermal]") {
  const StationAir air{288.15, 10.0, 0.0};
  CHECK(sky_emissivity({ClearSkyFormula::brutsaert}, air) == Approx(1.24 * 0.618704).epsilon(2e-6));
  CHECK(sky_emissivity({ClearSkyFormula::swinbank}, air) == Approx(0.777535).epsilon(2e-6));
  CHECK(sky_emissivity({ClearSkyFormula::idso}, air) ==
        Approx(0.70 + 5.95e-4 * 182.2948).epsilon(2e-6));
  CHECK(sky_emissivity({ClearSkyFormula::prata}, air) ==
        Approx(1.0 - 2.613743 * 0.08561532).epsilon(2e-6));
}

// Unsworth & Monteith (1975) fitted clear skies of the English Midlands by 213 + 5.5 t W m^-2, t in
// Celsius, 0 to 20: another form, other data. At 70 % humidity the formulas lie within the 23
// W m^-2 that Flerchinger et al. found for the best, Idso's, which runs high, within 40.
TEST_CASE("clear skies agree with those of the Midlands", "[thermal]") {
  for (const double t : {0.0, 5.0, 10.0, 15.0, 20.0}) {
    const double air_k = si::zero_celsius + t;
    const StationAir air{air_k, vapour_pressure_of_humidity_hpa(air_k, 0.7), 0.0};
    const double measured = 213.0 + 5.5 * t;
    for (const ClearSkyFormula clear : every_clear) {
      CAPTURE(t, static_cast<int>(clear));
      const double margin = clear == ClearSkyFormula::idso ? 40.0 : 23.0;
      CHECK(sky_long_wave_w_m2({clear}, air) == Approx(measured).margin(margin));
    }
  }
}

TEST_CASE("clouds follow their authors", "[thermal]") {
  const StationAir half{288.15, 10.0, 0.5};
  const double clear = sky_emissivity({}, {288.15, 10.0, 0.0});
  CHECK(sky_emissivity({}, half) == Approx(0.58 * clear + 0.42).epsilon(1e-14));
  // 0.5^2.45 = 0.183011
  CHECK(sky_emissivity({ClearSkyFormula::prata, CloudFormula::sugita_brutsaert}, half) ==
        Approx((1.0 + 0.0496 * 0.183011) * clear).epsilon(1e-6));
}

TEST_CASE("an overcast sky is nearly black and never more", "[thermal]") {
  for (const ClearSkyFormula clear : every_clear) {
    const StationAir air{283.15, 8.6, 1.0};
    CHECK(sky_emissivity({clear}, air) > 0.95);
    CHECK(sky_emissivity({clear}, air) <= 1.0);
  }
}

TEST_CASE("clouds and vapour only ever warm the sky", "[thermal]") {
  for (const ClearSkyFormula clear : every_clear) {
    for (const CloudFormula clouds : every_cloud) {
      const SkyFormula formula{clear, clouds};
      double before = 0.0;
      for (double c = 0.0; c <= 1.0; c += 0.125) {
        const double now = sky_long_wave_w_m2(formula, {280.0, 6.0, c});
        CHECK(now > before);
        before = now;
      }
      before = 0.0;
      for (double e = 0.5; e <= 60.0; e *= 1.5) {
        const double now = sky_long_wave_w_m2(formula, {310.0, e, 0.2});
        CHECK(now >= before);
        before = now;
      }
    }
  }
}

TEST_CASE("no air makes a sky brighter than a black body", "[thermal]") {
  Rng rng{11, 3};
  for (int i = 0; i < 2000; ++i) {
    const StationAir air{150.0 + 200.0 * rng.next(), 416.0 * rng.next(), 1.4 * rng.next() - 0.2};
    for (const ClearSkyFormula clear : every_clear) {
      for (const CloudFormula clouds : every_cloud) {
        const double flux = sky_long_wave_w_m2({clear, clouds}, air);
        REQUIRE(flux >= 0.0);
        REQUIRE(flux <= black_w_m2(air.temperature_k) * (1.0 + 1e-14));  // rounding
      }
    }
  }
  CHECK(sky_long_wave_w_m2({}, {230.0, 0.0, 0.0}) > 100.0);  // without any vapour
}

}  // namespace
}  // namespace nadir::thermal
