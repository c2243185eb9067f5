#include "ephemeris/refraction.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/catch.hpp"

namespace {

using namespace nadir;
using namespace nadir::ephemeris;

double arcminutes(double elevation_deg, const AirAtSite& air = {}) {
  return to_degrees(refraction(degrees(elevation_deg), air)) * 60.0;
}

double at_apparent(double elevation_deg, const AirAtSite& air = {}) {
  return to_degrees(refraction_at_apparent(degrees(elevation_deg), air)) * 60.0;
}

/// Dry air over the radius: a lapse of 6.5 K/km to 11 km, isothermal above, in hydrostatic balance
/// (the model of C. Y. Hohenkerk and A. T. Sinclair, NAO Technical Note 63, 1985).
struct Refractivity {
  double index, slope;  // n and dn/dr, 1/m
};
constexpr double earth_m = 6'378'120.0, tropopause_m = 11e3, lapse = 0.0065;

Refractivity refractivity(double radius_m, const AirAtSite& air) {
  constexpr double standard = 2.7784e-4;  // n - 1 at 15 C, 1013.25 hPa, 0.55 um (Ciddor)
  constexpr double scale = 9.784 * 28.9644 / 8314.32;  // K/m
  const double t0 = 273.15 + air.temperature_c, h = radius_m - earth_m;
  const double at_ground = standard * (air.pressure_hpa / 1013.25) * (288.15 / t0);
  const double exponent = scale / lapse - 1.0;
  const double t = t0 - lapse * std::min(h, tropopause_m);
  const double here = at_ground * std::pow(t / t0, exponent);
  if (h < tropopause_m) return {1.0 + here, -here * exponent * lapse / t};
  const double above = here * std::exp(-scale / t * (h - tropopause_m));
  return {1.0 + above, -above * scale / t};
}

/// R = - integral of r n' / (n + r n') over the local zenith distance (L. H. Auer and E. M.
/// Standish, AJ 119, 2472, 2000), midpoint rule in each part of the air; arcmin.
double traced(double apparent_deg, const AirAtSite& air) {
  const double invariant =
      refractivity(earth_m, air).index * earth_m * std::cos(degrees(apparent_deg).value);
  double sum = 0.0;
  for (const auto& [from, to] : {std::pair{earth_m, earth_m + tropopause_m},
                                 std::pair{earth_m + tropopause_m, earth_m + 80e3}}) {
    const auto zenith = [&](double r) {
      return std::asin(std::min(1.0, invariant / (refractivity(r, air).index * r)));
    };
    constexpr int points = 300;
    const double z0 = zenith(from + 1e-6), step = (zenith(to - 1e-6) - z0) / points;
    double r = from;
    for (int i = 0; i < points; ++i) {
      const double target = invariant / std::sin(z0 + (i + 0.5) * step);
      for (int round = 0; round < 30; ++round) {
        const Refractivity n = refractivity(r, air);
        r = std::clamp(r - (n.index * r - target) / (n.index + r * n.slope), from, to - 1e-7);
      }
      const Refractivity n = refractivity(r, air);
      sum += r * n.slope / (n.index + r * n.slope) * step;
    }
  }
  return to_degrees(Angle{sum}) * 60.0;
}

}  // namespace

// Pulkovo tables, 15 C, 1013.25 hPa, 0.59 um: 1977.97 arcsec on the horizon; above 20 degrees
// 57.085" cot h - 0.0666" cot^3 h (both as hp41programs.yolasite.com quotes them). The formula is
// their fit to 0.3 arcsec, for 0.55 um where air refracts more by 1.00253.
TEST_CASE("refraction is the Pulkovo tables'", "[ephemeris][refraction]") {
  constexpr double dispersion = 1.00253;
  CHECK(at_apparent(0.0) * 60.0 / dispersion == Approx(1977.97).epsilon(0).margin(0.3));
  for (double h_deg = 20.0; h_deg < 90.0; h_deg += 5.0) {
    const double cot = 1.0 / std::tan(degrees(h_deg).value);
    CAPTURE(h_deg);
    CHECK(at_apparent(h_deg) * 60.0 / dispersion ==
          Approx(57.085 * cot - 0.0666 * std::pow(cot, 3)).epsilon(0).margin(0.3));
  }
}

// Mean refraction at 760 mm and 10 C from the Populaere astronomische Encyclopaedie (19th century),
// in whole seconds. The promise is 0.05 arcmin down to 5 degrees.
TEST_CASE("refraction at 10 C is that of the old tables", "[ephemeris][refraction]") {
  const AirAtSite air{1013.25, 10.0};
  const double table[][2] = {{85, 5},   {60, 34},  {50, 49},  {45, 58},  {40, 69},
                             {30, 101}, {20, 159}, {15, 214}, {10, 320}, {5, 594}};
  for (const auto& [h_deg, arcsec] : table) {
    CAPTURE(h_deg);
    CHECK(at_apparent(h_deg, air) == Approx(arcsec / 60.0).epsilon(0).margin(0.05));
  }
}

// Bessel's exponents (Tabulae Regiomontanae): of the air's density by temperature 1.0018 at 45
// degrees and 1.7304 on the horizon, by pressure 1.0026 at 13 degrees. The horizon's differ from
// model to model.
TEST_CASE("refraction follows temperature and pressure with Bessel's exponents",
          "[ephemeris][refraction]") {
  const auto by_temperature = [](double h_deg) {
    const double ratio = at_apparent(h_deg, {1013.25, 5.0}) / at_apparent(h_deg, {1013.25, 15.0});
    return std::log(ratio) / std::log(288.15 / 278.15);
  };
  const auto by_pressure = [](double h_deg) {
    return std::log(at_apparent(h_deg, {900.0, 15.0}) / at_apparent(h_deg)) /
           std::log(900.0 / 1013.25);
  };
  CHECK(by_temperature(45.0) == Approx(1.0018).epsilon(0).margin(0.003));
  CHECK(by_temperature(0.0) == Approx(1.7304).epsilon(0).margin(0.06));
  CHECK(by_pressure(13.0) == Approx(1.0026).epsilon(0).margin(0.001));
}

TEST_CASE("refraction is that of a ray through a standard atmosphere", "[ephemeris][refraction]") {
  for (const AirAtSite& air : {AirAtSite{}, AirAtSite{1010.0, 10.0}, AirAtSite{1030.0, -30.0},
                               AirAtSite{700.0, 0.0}, AirAtSite{1000.0, 40.0}}) {
    for (const double h_deg : {5.0, 7.0, 10.0, 15.0, 25.0, 45.0, 70.0}) {
      CAPTURE(air.pressure_hpa, air.temperature_c, h_deg);
      // arcmin; measured 0.008, the fit to the Pulkovo tables and that of the exponents
      CHECK(at_apparent(h_deg, air) == Approx(traced(h_deg, air)).epsilon(0).margin(0.015));
    }
    for (const double h_deg : {0.0, 1.0, 2.0, 3.0}) {
      CHECK(at_apparent(h_deg, air) == Approx(traced(h_deg, air)).epsilon(0.02));
    }
  }
}

TEST_CASE("the lift of a true elevation leads to the apparent one", "[ephemeris][refraction]") {
  for (const double h_deg : {-0.99, -0.5, 0.0, 1.0, 10.0, 60.0, 89.0}) {
    for (const AirAtSite& air : {AirAtSite{}, AirAtSite{1040.0, -40.0}}) {
      const double lift = arcminutes(h_deg, air);
      // the rounds leave 1e-8 of a degree
      CHECK(at_apparent(h_deg + lift / 60.0, air) == Approx(lift).epsilon(0).margin(1e-5));
    }
  }
}

TEST_CASE("refraction vanishes in the zenith and far below the horizon",
          "[ephemeris][refraction]") {
  CHECK(arcminutes(90.0) == Approx(0.0).margin(1e-5));
  CHECK(arcminutes(-2.0) == 0.0);
  CHECK(arcminutes(-45.0) == 0.0);
  CHECK(arcminutes(-90.0) == 0.0);
}

TEST_CASE("refraction is continuous and falls with elevation", "[ephemeris][refraction]") {
  constexpr double step_deg = 0.01;
  double previous = arcminutes(-3.0);
  for (double h_deg = -3.0 + step_deg; h_deg < 90.0; h_deg += step_deg) {
    const double here = arcminutes(h_deg);
    CAPTURE(h_deg);
    // steepest on the fade: 38.8' in one degree
    REQUIRE(std::abs(here - previous) < 40.0 * step_deg);
    if (h_deg > -1.0 + step_deg) REQUIRE(here <= previous);
    // a higher body appears higher
    REQUIRE(here / 60.0 + step_deg > previous / 60.0);
    REQUIRE(here >= 0.0);
    previous = here;
  }
}

TEST_CASE("without air there is no refraction, high up it follows the density",
          "[ephemeris][refraction]") {
  CHECK(arcminutes(10.0, {0.0, 10.0}) == 0.0);
  // exponents within 3e-4 of 1 up there
  CHECK(at_apparent(70.0, {506.625, 15.0}) == Approx(at_apparent(70.0) / 2.0).epsilon(5e-4));
}
