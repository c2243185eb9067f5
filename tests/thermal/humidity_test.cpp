#include "thermal/surface/humidity.hpp"

#include <cmath>

#include "atmosphere/profile.hpp"
#include "core/constants.hpp"
#include "support/catch.hpp"

namespace nadir::thermal {
namespace {

constexpr double celsius(double value) { return si::zero_celsius + value; }

// Handbook of Chemistry and Physics, vapour pressure of water: 0.6113, 1.2281, 2.3388, 4.2455,
// 7.3814, 12.344 kPa at 0, 10 ... 50 degrees Celsius. Magnus' formula as the WMO gives it misses
// them by up to 0.4 %.
TEST_CASE("saturation over water has the handbook's values", "[thermal]") {
  const double handbook_hpa[] = {6.113, 12.281, 23.388, 42.455, 73.814, 123.44};
  for (int i = 0; i < 6; ++i) {
    CAPTURE(10 * i);
    CHECK(saturation_over_water_hpa(celsius(10.0 * i)) == Approx(handbook_hpa[i]).epsilon(4e-3));
  }
}

// An independent formula of the same quantity, eq. 10 of Murphy & Koop (2005): 0.6 % as stated.
TEST_CASE("saturation over water agrees with Murphy and Koop's from 233 to 333 K", "[thermal]") {
  for (double t = 233.15; t <= 333.15; t += 2.5) {
    CHECK(saturation_over_water_hpa(t) ==
          Approx(atmosphere::saturation_pressure_hpa(t)).epsilon(6e-3));
  }
}

// Murphy & Koop (2005), eq. 7, in Pa.
TEST_CASE("saturation over ice agrees with Murphy and Koop's from 223 to 273 K", "[thermal]") {
  for (double t = 223.15; t < 273.15; t += 2.5) {
    const double pa = std::exp(9.550426 - 5723.265 / t + 3.53068 * std::log(t) - 0.00728332 * t);
    CHECK(saturation_at_surface(t).hpa == Approx(1e-2 * pa).epsilon(5e-4));
  }
}

TEST_CASE("a wet surface is water above freezing and ice below", "[thermal]") {
  CHECK(saturation_at_surface(290.0).hpa == saturation_over_water_hpa(290.0));
  CHECK(saturation_at_surface(255.0).hpa < 0.9 * saturation_over_water_hpa(255.0));
  CHECK(saturation_at_surface(std::nextafter(273.15, 0.0)).hpa ==
        Approx(saturation_at_surface(273.15).hpa).epsilon(1e-12));  // both formulas give 6.112
}

TEST_CASE("saturation never falls with temperature, from 0 to 3000 K", "[thermal]") {
  double before = 0.0;
  for (double t = 0.0; t <= 3000.0; t += 0.25) {
    const SaturationPressure now = saturation_at_surface(t);
    CHECK((std::isfinite(now.hpa) && now.hpa >= before && now.per_k >= 0.0));
    before = now.hpa;
  }
  CHECK(before == Approx(1038.4492).epsilon(1e-7));  // 6.112 exp(1762 / 343.12)
  CHECK(saturation_at_surface(2.7).hpa == 0.0);
}

// Central differences over 0.02 K: off by h^2/6 of the third derivative, below 1e-6 of the slope.
TEST_CASE("the slope of saturation is that of its differences", "[thermal]") {
  for (const double t : {150.0, 200.0, 260.0, 273.1, 273.2, 300.0, 350.0, 373.1}) {
    const double h = 0.01;
    const double difference =
        (saturation_at_surface(t + h).hpa - saturation_at_surface(t - h).hpa) / (2.0 * h);
    CHECK(saturation_at_surface(t).per_k == Approx(difference).epsilon(2e-6));
  }
  CHECK(saturation_at_surface(400.0).per_k == 0.0);
}

TEST_CASE("dew forms at the dew point", "[thermal]") {
  for (const double t : {235.0, 263.0, 273.15, 288.0, 303.0, 345.0}) {
    CHECK(dew_point_k(vapour_pressure_of_dew_point_hpa(t)) == Approx(t).epsilon(1e-13));
  }
  // Psychrometric charts: 20 degrees at 50 % have a dew point of 9.3, 30 degrees at 80 % of 26.2.
  CHECK(dew_point_k(vapour_pressure_of_humidity_hpa(celsius(20.0), 0.5)) ==
        Approx(celsius(9.3)).margin(0.1));
  CHECK(dew_point_k(vapour_pressure_of_humidity_hpa(celsius(30.0), 0.8)) ==
        Approx(celsius(26.2)).margin(0.1));
}

// FAO Irrigation and Drainage Paper 56, example 2: 0.054 kPa/K at 81.8 kPa.
TEST_CASE("the psychrometric constant goes with pressure", "[thermal]") {
  CHECK(10.0 * psychrometric_constant_hpa_k(81.8) == Approx(0.54).margin(0.005));
}

}  // namespace
}  // namespace nadir::thermal
