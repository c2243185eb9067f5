#include "atmosphere/profile.hpp"

#include <cmath>

#include "core/error.hpp"
#include "support/catch.hpp"

namespace nadir::atmosphere {
namespace {

/// Isothermal air of scale height 8 km at 273.15 K, water vapour 1000 ppmv, ozone 1 ppmv, from 0 to
/// 40 km.
Profile isothermal() {
  Profile profile{"isothermal", {}, 0.0};
  for (int km = 0; km <= 40; km += 2) {
    Level level{km * 1e3, standard_pressure_hpa * std::exp(-km / 8.0), 273.15, {}};
    level.mixing(Gas::h2o) = 1000.0;
    level.mixing(Gas::o3) = 1.0;
    level.mixing(Gas::co2) = 330.0;
    profile.levels.push_back(level);
  }
  return profile;
}

TEST_CASE("columns of isothermal air are those of its scale height", "[atmosphere][profile]") {
  const Profile air = isothermal();
  // Scale height 8 km, from 0 to 40 km: 8 (1 - e^-5) km of air at p0 and T0. Exponentials are
  // integrated exactly: only rounding is left.
  const double air_km = 8.0 * (1.0 - std::exp(-5.0));
  CHECK(ozone_column(air, 0.0) == Approx(100.0 * air_km).epsilon(1e-12));
  // 1e-3 of the molecules are water, 18.015 g mol^-1: 22,414 cm^3 mol^-1 at p0 and T0. LOWTRAN7's
  // molecules per gram are rounded: 2e-5.
  CHECK(water_column(air, 0.0) == Approx(1e-3 * 18.015 / 22414.0 * 1e5 * air_km).epsilon(5e-5));
  CHECK(water_column(air, 8000.0) / water_column(air, 0.0) ==
        Approx((std::exp(-1.0) - std::exp(-5.0)) / (1.0 - std::exp(-5.0))).epsilon(1e-12));
}

TEST_CASE("an exponential's integral is exact for any ratio", "[atmosphere][profile]") {
  const double ratio = GENERATE(1e-6, 0.5, 0.9995, 0.99999, 1.0, 1.0004, 3.0);
  // expm1 keeps all digits of the difference quotient.
  const double log_ratio = std::log(ratio);
  const double expected = log_ratio == 0.0 ? 1.0 : std::expm1(log_ratio) / log_ratio;
  CHECK(exponential_integral(2.0, 2.0 * ratio, 3.0) == Approx(6.0 * expected).epsilon(1e-12));
  CHECK(exponential_integral(0.0, 2.0, 3.0) == 3.0);  // linear where one end is 0
}

TEST_CASE("between levels temperature is linear and pressure logarithmic",
          "[atmosphere][profile]") {
  Profile air = isothermal();
  air.levels[1].temperature_k = 263.15;
  const Level level = level_at(air, 1000.0);
  CHECK(level.temperature_k == Approx(268.15).epsilon(1e-12));
  CHECK(level.pressure_hpa == Approx(standard_pressure_hpa * std::exp(-0.125)).epsilon(1e-12));
  CHECK(level.mixing(Gas::o3) == Approx(1.0).epsilon(1e-12));
  CHECK(level_at(air, 40000.0).height_m == 40000.0);
}

TEST_CASE("a profile reaches no further down than it says", "[atmosphere][profile]") {
  Profile air = isothermal();
  CHECK_THROWS_WITH(level_at(air, -1.0), Catch::Matchers::Contains("-1 m lies below the profile"));
  CHECK_THROWS_WITH(level_at(air, 40001.0), Catch::Matchers::Contains("lies above the profile"));
  CHECK_THROWS_AS(level_at(air, std::nan("")), InputError);
  air.reaches_below_m = 500.0;
  const Level below = level_at(air, -500.0);
  CHECK(below.pressure_hpa == Approx(standard_pressure_hpa * std::exp(0.0625)).epsilon(1e-12));
  CHECK(below.mixing(Gas::h2o) == 1000.0);  // held, not continued
  CHECK_THROWS_AS(level_at(air, -500.1), InputError);
}

TEST_CASE("saturation is that of Murphy and Koop", "[atmosphere][profile]") {
  // The triple point, 611.657 Pa (Guildner et al. 1976); 3169.9 Pa at 25 C (Wagner & Pruss 1993).
  // Murphy & Koop state 0.05 %.
  CHECK(saturation_pressure_hpa(273.16) == Approx(6.11657).epsilon(5e-4));
  CHECK(saturation_pressure_hpa(298.15) == Approx(31.699).epsilon(5e-4));
}

TEST_CASE("columns are scaled to what was asked for", "[atmosphere][profile]") {
  const Profile air = isothermal();
  const ScaledProfile ozone = scale_ozone_to(air, 300.0, 1000.0);
  CHECK(ozone.column == Approx(300.0).epsilon(1e-12));
  CHECK(ozone_column(ozone.profile, 1000.0) == Approx(300.0).epsilon(1e-12));
  const ScaledProfile half = scale_water(air, 0.5, 0.0);
  CHECK(half.capped_levels == 0);
  CHECK(half.column == Approx(0.5 * water_column(air, 0.0)).epsilon(1e-12));
  CHECK(scale_carbon_dioxide(air, 420.0).levels[7].mixing(Gas::co2) ==
        Approx(420.0).epsilon(1e-12));
  CHECK_THROWS_WITH(scale_water(air, -1.0, 0.0), Catch::Matchers::Contains("must not be negative"));
  CHECK_THROWS_AS(scale_ozone_to(scale_ozone(air, 0.0, 0.0).profile, 300.0, 0.0), InputError);
}

TEST_CASE("water vapour stops at saturation, and what fits elsewhere makes up for it",
          "[atmosphere][profile]") {
  const Profile air = isothermal();
  // At 273.15 K 6.11 hPa of 1013: about 6000 ppmv at the ground, more above.
  const ScaledProfile wet = scale_water(air, 10.0, 0.0);
  CHECK(wet.capped_levels > 0);
  for (const Level& level : wet.profile.levels) CHECK(relative_humidity(level) <= 1.0 + 1e-12);
  const double wanted = 8.0 * water_column(air, 0.0);
  const ScaledProfile reached = scale_water_to(air, wanted, 0.0);
  CHECK(reached.capped_levels > 0);
  CHECK(reached.column == Approx(wanted).epsilon(1e-9));  // 60 halvings
  const ScaledProfile too_much = scale_water_to(air, 1e3, 0.0);
  CHECK(too_much.column < 1e3);
  CHECK(too_much.capped_levels == static_cast<int>(air.levels.size()));
}

TEST_CASE("profiles out of order are refused", "[atmosphere][profile]") {
  const auto broken = [](auto change) {
    Profile air = isothermal();
    change(air);
    return air;
  };
  CHECK_THROWS_WITH(check(broken([](Profile& a) { a.levels[3].height_m = 1.0; })),
                    Catch::Matchers::Contains("heights must ascend"));
  CHECK_THROWS_WITH(check(broken([](Profile& a) { a.levels[3].pressure_hpa = 2e3; })),
                    Catch::Matchers::Contains("pressure must fall"));
  CHECK_THROWS_WITH(check(broken([](Profile& a) { a.levels[3].temperature_k = -1.0; })),
                    Catch::Matchers::Contains("temperature must be > 0"));
  CHECK_THROWS_WITH(check(broken([](Profile& a) { a.levels[3].ppmv[2] = -1.0; })),
                    Catch::Matchers::Contains("mixing ratio is negative"));
  CHECK_THROWS_WITH(check(broken([](Profile& a) { a.levels.resize(1); })),
                    Catch::Matchers::Contains("at least two levels"));
  CHECK_NOTHROW(check(isothermal()));
}

}  // namespace
}  // namespace nadir::atmosphere
