#include "thermal/surface/surface_balance.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/constants.hpp"
#include "core/random.hpp"
#include "support/catch.hpp"
#include "thermal/surface/humidity.hpp"

namespace nadir::thermal {
namespace {

constexpr double coldest_k = 2.7;
constexpr double hottest_k = 2000.0;

SurfaceLoad summer_noon() {
  return {.direct_w_m2 = 700.0,
          .diffuse_w_m2 = 110.0,
          .reflected_w_m2 = 15.0,
          .sky_long_wave_w_m2 = 340.0,
          .surroundings_long_wave_w_m2 = 40.0,
          .air_k = 300.0,
          .vapour_pressure_hpa = 15.0,
          .pressure_hpa = 1000.0,
          .film = film(Tarp{}, {3.0, 0.8})};
}

/// The root of a falling flux.
double temperature_of(const BalanceAt& at) {
  double low = coldest_k;
  double high = hottest_k;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (at(middle).w_m2 > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

TEST_CASE("each term of the balance is what its name says", "[thermal]") {
  const SurfaceProperties surface{.solar_absorptance = 0.6, .emissivity = 0.9};
  const SurfaceLoad load = summer_noon();
  const BalanceTerms terms = balance(surface, load, 310.0);
  CHECK(terms.direct == Approx(420.0).epsilon(1e-14));
  CHECK(terms.diffuse == Approx(66.0).epsilon(1e-14));
  CHECK(terms.reflected == Approx(9.0).epsilon(1e-14));
  CHECK(terms.sky_long_wave == Approx(306.0).epsilon(1e-14));
  CHECK(terms.surroundings_long_wave == Approx(36.0).epsilon(1e-14));
  CHECK(terms.emitted == Approx(-0.9 * si::stefan_boltzmann * std::pow(310.0, 4)).epsilon(1e-14));
  CHECK(terms.convected == Approx(-10.0 * load.film.at(10.0)).epsilon(1e-13));
  CHECK(terms.evaporated == 0.0);
}

// a E = eps sigma (T^4 - T_sky^4): nothing but radiation.
TEST_CASE("a surface without air comes to radiative equilibrium", "[thermal]") {
  SurfaceLoad load;
  load.direct_w_m2 = 600.0;
  load.sky_long_wave_w_m2 = si::stefan_boltzmann * std::pow(250.0, 4);
  const SurfaceProperties surface{.solar_absorptance = 0.8, .emissivity = 0.9};
  const double expected =
      std::pow(0.8 * 600.0 / (0.9 * si::stefan_boltzmann) + std::pow(250.0, 4), 0.25);
  // Bisection ends at a double's resolution.
  CHECK(temperature_of(BalanceAt{surface, load}) == Approx(expected).epsilon(1e-14));
}

TEST_CASE("nothing flows where air, sky and surface have one temperature", "[thermal]") {
  const double t = 288.0;
  for (const double wetness : {0.0, 1.0}) {
    const SurfaceProperties surface{.emissivity = 0.93, .wetness = wetness};
    SurfaceLoad load;
    load.sky_long_wave_w_m2 = 0.4 * si::stefan_boltzmann * std::pow(t, 4);
    load.surroundings_long_wave_w_m2 = 0.6 * si::stefan_boltzmann * std::pow(t, 4);
    load.air_k = t;
    load.vapour_pressure_hpa = saturation_over_water_hpa(t);
    load.film = film(Tarp{}, {4.0, 1.0});
    CHECK(std::abs(balance(surface, load, t).sum()) < 1e-12);  // rounding of 360 W m^-2
    CHECK(std::abs(BalanceAt{surface, load}(t).w_m2) < 1e-12);
  }
}

TEST_CASE("a wet surface evaporates into drier air and takes dew from damper air", "[thermal]") {
  const SurfaceProperties wet{.wetness = 1.0};
  SurfaceLoad load = summer_noon();
  const double dew_k = dew_point_k(load.vapour_pressure_hpa);
  CHECK(balance(wet, load, dew_k + 0.01).evaporated < 0.0);
  CHECK(balance(wet, load, dew_k - 0.01).evaporated > 0.0);
  CHECK(std::abs(balance(wet, load, dew_k).evaporated) < 1e-9);  // e_s of a rounded temperature
  // By halves: wetness is a share of what open water evaporates.
  const SurfaceProperties damp{.wetness = 0.5};
  CHECK(balance(damp, load, 305.0).evaporated ==
        Approx(0.5 * balance(wet, load, 305.0).evaporated).epsilon(1e-14));
}

// A ventilated wet thermometer: h (T_air - T) = h / gamma (e_s(T) - e), the psychrometer's own
// equation. Air at 20 C and 50 % (11.69 hPa) has a wet bulb of 13.7 to 13.8 C (psychrometric
// charts at 1013 hPa: 13.8); gamma here is 0.674, of an aspirated one 0.66 hPa/K.
TEST_CASE("a wet bulb shows its temperature", "[thermal]") {
  const SurfaceProperties wet_bulb{.solar_absorptance = 0.0, .emissivity = 0.0, .wetness = 1.0};
  SurfaceLoad load;
  load.air_k = 293.15;
  load.vapour_pressure_hpa = vapour_pressure_of_humidity_hpa(load.air_k, 0.5);
  load.film = film(FixedFilm{50.0}, {});
  const double found = temperature_of(BalanceAt{wet_bulb, load});
  CHECK(found - si::zero_celsius == Approx(13.8).margin(0.15));
}

// 1 mm of water a day takes 28.4 W m^-2; open water on a warm dry windy day evaporates 5 to 12 mm
// (FAO-56, table 2: 6 to 9 for reference grass in warm arid regions).
TEST_CASE("open water evaporates as much as ponds do", "[thermal]") {
  const SurfaceProperties pond{.convection = McAdams{}, .wetness = 1.0};
  SurfaceLoad load;
  load.air_k = 303.15;
  load.vapour_pressure_hpa = vapour_pressure_of_humidity_hpa(load.air_k, 0.3);
  load.film = film(McAdams{}, {2.0, 1.0});
  const double mm_a_day = -balance(pond, load, 296.15).evaporated / 28.4;
  CHECK(mm_a_day > 5.0);
  CHECK(mm_a_day < 15.0);
}

std::vector<SurfaceLoad> many_airs() {
  std::vector<SurfaceLoad> airs;
  for (const double air_k : {180.0, 260.0, 272.9, 300.0, 345.0}) {
    for (const double vapour_hpa : {0.0, 2.0, 60.0, 416.0}) {
      for (const double wind : {0.0, 0.3, 12.0}) {
        SurfaceLoad load = summer_noon();
        load.air_k = air_k;
        load.vapour_pressure_hpa = vapour_hpa;
        load.film = film(Tarp{}, {wind, wind > 1.0 ? -1.0 : 1.0});
        airs.push_back(load);
      }
    }
  }
  return airs;
}

// The balance takes its cube roots by a quicker way than the film.
TEST_CASE("what the air takes is the film's to rounding at every difference", "[thermal]") {
  const SurfaceProperties surface;
  SurfaceLoad load;
  load.air_k = 0.0;  // so that the difference is exact
  load.film = {0.0, 1.0, 0.0};
  for (double warmer = 1e-12; warmer < 2000.0; warmer *= 1.03) {
    const double expected = -warmer * load.film.at(warmer);
    CHECK(balance(surface, load, warmer).convected == Approx(expected).epsilon(2e-14));
  }
  CHECK(balance(surface, load, 0.0).convected == 0.0);
}

// The column's Newton iteration stands on it: exactly one root.
TEST_CASE("the flux falls with temperature from the sky's cold to molten metal", "[thermal]") {
  const SurfaceProperties surface{.emissivity = 0.05, .wetness = 1.0};
  for (const SurfaceLoad& load : many_airs()) {
    const BalanceAt at{surface, load};
    CAPTURE(load.air_k, load.vapour_pressure_hpa, load.film.forced_w_m2_k);
    int rises = 0;
    double before = at(coldest_k).w_m2;
    // Steps of 0.07 K, finer near the air's temperature where natural convection has its kink.
    for (double t = coldest_k; t < hottest_k; t += std::abs(t - load.air_k) < 3.0 ? 0.002 : 0.9) {
      const SurfaceFlux now = at(t);
      rises += now.w_m2 > before + 1e-9 ? 1 : 0;  // rounding of up to 1e6 W m^-2
      rises += now.per_k_w_m2_k > 0.0 ? 1 : 0;
      before = now.w_m2;
    }
    CHECK(rises == 0);
  }
}

TEST_CASE("the prepared balance is the sum of the terms", "[thermal]") {
  for (const double wetness : {0.0, 0.3, 1.0}) {
    const SurfaceProperties surface{.wetness = wetness};
    for (const SurfaceLoad& load : many_airs()) {
      const BalanceAt at{surface, load};
      for (const double t : {2.7, 150.0, 271.0, 273.15, 301.0, 372.0, 500.0, 2000.0}) {
        const BalanceTerms terms = balance(surface, load, t);
        const double scale = 1.0 + std::abs(terms.emitted) + std::abs(terms.convected) +
                             std::abs(terms.evaporated) + 1200.0;
        CHECK(std::abs(at(t).w_m2 - terms.sum()) < 1e-14 * scale);  // a few roundings
      }
    }
  }
}

// Central differences over 2e-3 K: their own error is h^2/6 of the third derivative, at most 1e-6
// of the slope here, and 1e-9 W m^-2 of rounding over 2e-3 K. Kinks (the air's temperature and 1 K
// around it, the dew point, freezing, boiling) are stepped around.
TEST_CASE("the slope of the balance is that of its differences", "[thermal]") {
  constexpr double h = 1e-3;
  for (const double wetness : {0.0, 1.0}) {
    const SurfaceProperties surface{.emissivity = 0.3, .wetness = wetness};
    for (const SurfaceLoad& load : many_airs()) {
      const BalanceAt at{surface, load};
      for (double t = 20.13; t < 1500.0; t += t < 450.0 ? 7.91 : 97.0) {
        const double away = std::abs(t - load.air_k);
        if (away < 0.1 || std::abs(away - 1.0) < 0.1) continue;
        if (std::abs(saturation_at_surface(t).hpa - load.vapour_pressure_hpa) <
            0.05 * load.vapour_pressure_hpa)
          continue;
        if (std::abs(t - 273.15) < 0.1 || std::abs(t - 373.15) < 0.1) continue;
        const double difference = (at(t + h).w_m2 - at(t - h).w_m2) / (2.0 * h);
        CAPTURE(wetness, load.air_k, load.vapour_pressure_hpa, t);
        CHECK(at(t).per_k_w_m2_k == Approx(difference).epsilon(3e-6).margin(3e-6));
      }
    }
  }
}

TEST_CASE("a sheet open on both sides has the sum of both balances", "[thermal]") {
  const SurfaceProperties surface{.solar_absorptance = 0.4, .emissivity = 0.8, .wetness = 0.2};
  SurfaceLoad front = summer_noon();
  front.film = film(Tarp{}, {2.0, 0.9});
  SurfaceLoad back = summer_noon();
  back.direct_w_m2 = 0.0;
  back.diffuse_w_m2 = 20.0;
  back.reflected_w_m2 = 90.0;
  back.sky_long_wave_w_m2 = 30.0;
  back.surroundings_long_wave_w_m2 = 430.0;
  back.film = film(Tarp{}, {2.0, -0.9});
  const BalanceAt both{surface, front, back};
  for (const double t : {250.0, 285.0, 299.9, 300.4, 330.0, 700.0}) {
    const double sum = balance(surface, front, t).sum() + balance(surface, back, t).sum();
    CHECK(both(t).w_m2 == Approx(sum).epsilon(1e-12).margin(1e-10));
    const double slope =
        BalanceAt{surface, front}(t).per_k_w_m2_k + BalanceAt{surface, back}(t).per_k_w_m2_k;
    CHECK(both(t).per_k_w_m2_k == Approx(slope).epsilon(1e-12));
  }
}

TEST_CASE("vapour over water as warm as the calm air still rises", "[thermal]") {
  const SurfaceProperties pond{.wetness = 1.0};
  SurfaceLoad load = summer_noon();
  load.film = film(Tarp{}, {0.0, 1.0});
  CHECK(balance(pond, load, load.air_k).convected == 0.0);
  CHECK(balance(pond, load, load.air_k).evaporated < -10.0);
}

TEST_CASE("no weather makes the balance infinite", "[thermal]") {
  Rng rng{2024, 5};
  for (int i = 0; i < 10000; ++i) {
    SurfaceLoad load;
    load.direct_w_m2 = 1500.0 * rng.next();
    load.diffuse_w_m2 = 1000.0 * rng.next();
    load.sky_long_wave_w_m2 = 1.0 + 799.0 * rng.next();
    load.air_k = 150.0 + 200.0 * rng.next();
    load.vapour_pressure_hpa = 416.0 * rng.next();
    load.pressure_hpa = 200.0 + 1000.0 * rng.next();
    load.film = film(Tarp{Roughness::very_rough}, {120.0 * rng.next(), 2.0 * rng.next() - 1.0});
    const SurfaceProperties surface{rng.next(), rng.next(), Tarp{}, 1.0, rng.next()};
    const BalanceAt at{surface, load};
    for (const double t : {coldest_k, load.air_k, coldest_k + 1997.3 * rng.next(), hottest_k}) {
      const SurfaceFlux flux = at(t);
      REQUIRE(std::isfinite(flux.w_m2));
      REQUIRE(std::isfinite(flux.per_k_w_m2_k));
      REQUIRE(flux.per_k_w_m2_k <= 0.0);
    }
  }
}

}  // namespace
}  // namespace nadir::thermal
