// Weather of a clear day: the law of its temperature, and what follows the sun.
#include "thermal/weather/clear_sky.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.hpp"
#include "support/catch.hpp"
#include "thermal/surface/humidity.hpp"

namespace nadir::thermal {
namespace {

using std::numbers::pi;

constexpr double hour_s = 3600.0;
const double horizon = std::sin(-0.8333 * pi / 180.0);

/// A sun that culminates at noon (0, 24 h, ...) and is above the horizon for so many hours; `sharp`
/// is how fast it rises.
std::vector<SunMoment> even_sun(double from_h, double to_h, double day_h,
                                double distance_au = 1.0) {
  const double edge = std::cos(pi * day_h / 24.0);
  std::vector<SunMoment> sun;
  for (double t_h = from_h; t_h <= to_h + 1e-9; t_h += 1.0 / 6.0) {
    const double height = 0.5 * (std::cos(2.0 * pi * t_h / 24.0) - edge);
    sun.push_back({t_h * hour_s, height + horizon, distance_au});
  }
  return sun;
}

ClearSkyLight plain_light() {
  ClearSkyLight light;
  light.cos_zenith = {0.0, 0.5, 1.0};
  light.direct_normal_w_m2 = {50.0, 600.0, 800.0};
  light.diffuse_horizontal_w_m2 = {10.0, 100.0, 150.0};
  light.sky_long_wave_w_m2 = 300.0;
  light.profile_k = 290.0;
  return light;
}

const DayOfAir plain_day{285.0, 300.0, 282.0, 3.0, 1000.0};

double at(const TimeSeries& series, double hour) { return series.at(hour * hour_s); }

}  // namespace

// Ten minutes between values: a sine of 15.7 h half period and an amplitude of 15 K bends by
// 15 (pi / 15.7)^2 (1/6)^2 / 8 = 0.002 K within them.
constexpr double kinks_k = 0.01;

TEST_CASE("air is coldest at sunrise and warmest 1.86 hours after noon", "[thermal][weather]") {
  const Weather weather = clear_sky_weather(plain_day, plain_light(), even_sun(-36.0, 36.0, 12.0));
  const auto& series = weather.air_temperature_k;
  CHECK(at(series, -6.0) == Approx(285.0).margin(kinks_k));
  CHECK(at(series, 18.0) == Approx(285.0).margin(kinks_k));
  CHECK(at(series, 1.86) == Approx(300.0).margin(kinks_k));
  const double most = *std::max_element(series.value.begin(), series.value.end());
  const double least = *std::min_element(series.value.begin(), series.value.end());
  CHECK(most <= 300.0 + 1e-9);
  CHECK(least >= 285.0 - 1e-9);
}

TEST_CASE("the day follows Parton and Logan's sine, the night their exponential",
          "[thermal][weather]") {
  const double day_h = GENERATE(8.0, 12.0, 16.0);
  CAPTURE(day_h);
  const Weather weather = clear_sky_weather(plain_day, plain_light(), even_sun(-48.0, 48.0, day_h));
  const auto& series = weather.air_temperature_k;
  // The published law: T = low + (high - low) sin(pi m / (Y + 2 a)) by day,
  const double full = day_h + 2.0 * 1.86;
  const double middle = 285.0 + 15.0 * std::sin(pi * 0.25 * day_h / full);
  CHECK(at(series, -0.25 * day_h) == Approx(middle).margin(kinks_k));
  // and by night low + (T_sunset - low) exp(-b n / Z), taken to the low itself at its end. In the
  // middle of the night the bare law would leave exp(-b / 2) = 0.333, this leaves 0.250.
  const double dusk = 15.0 * std::sin(pi * day_h / full);
  const double end = std::exp(-2.2), left = (std::exp(-1.1) - end) / (1.0 - end);
  CHECK(at(series, 12.0) == Approx(285.0 + dusk * left).margin(kinks_k));
  CHECK(at(series, -12.0) == Approx(285.0 + dusk * left).margin(kinks_k));
}

TEST_CASE("a day of air has no jumps and repeats where the sun does", "[thermal][weather]") {
  const Weather weather = clear_sky_weather(plain_day, plain_light(), even_sun(-48.0, 48.0, 13.0));
  const auto& series = weather.air_temperature_k;
  for (std::size_t i = 1; i < series.value.size(); ++i) {
    CAPTURE(series.time_s[i]);
    // The steepest moment is dusk: 2.2 (T_dusk - low) / 11 h, 0.5 K in ten minutes.
    CHECK(std::abs(series.value[i] - series.value[i - 1]) < 0.6);
  }
  for (double h = -48.0; h < 24.0; h += 0.7) {
    CHECK(at(series, h) == Approx(at(series, h + 24.0)).margin(1e-6));
  }
}

TEST_CASE("what the sun did before and after its record is as a day apart", "[thermal][weather]") {
  const double from_h = GENERATE(-30.0, -8.0, -2.0, 9.0);
  CAPTURE(from_h);
  const auto light = plain_light();
  const Weather whole = clear_sky_weather(plain_day, light, even_sun(-72.0, 72.0, 12.0));
  const Weather piece = clear_sky_weather(plain_day, light, even_sun(from_h, from_h + 25.0, 12.0));
  for (double h = from_h; h < from_h + 24.5; h += 0.5) {
    CAPTURE(h);
    // The crossings are found between moments that differ: a few seconds.
    CHECK(at(piece.air_temperature_k, h) ==
          Approx(at(whole.air_temperature_k, h)).margin(2.0 * kinks_k));
  }
}

TEST_CASE("polar night keeps the mean, polar day swings about it", "[thermal][weather]") {
  auto sun = even_sun(-48.0, 48.0, 12.0);
  SECTION("night") {
    for (SunMoment& moment : sun) moment.cos_zenith -= 0.8;
    const Weather weather = clear_sky_weather(plain_day, plain_light(), sun);
    for (const double t : weather.air_temperature_k.value) CHECK(t == 292.5);
    for (const double w : weather.direct_normal_w_m2.value) CHECK(w == 0.0);
  }
  SECTION("day") {
    for (SunMoment& moment : sun) moment.cos_zenith = 0.4 * moment.cos_zenith + 0.3;
    const Weather weather = clear_sky_weather(plain_day, plain_light(), sun);
    CHECK(at(weather.air_temperature_k, 1.86) == Approx(300.0).margin(kinks_k));
    CHECK(at(weather.air_temperature_k, 13.86) == Approx(285.0).margin(kinks_k));
  }
}

TEST_CASE("sunlight follows the sun's height and distance", "[thermal][weather]") {
  const std::vector<SunMoment> sun{
      {0.0, 0.25, 1.0}, {600.0, 0.5, 1.0}, {1200.0, 0.5, 2.0}, {1800.0, 1.0, 1.0}};
  const Weather weather = clear_sky_weather(plain_day, plain_light(), sun);
  CHECK(weather.direct_normal_w_m2.value[0] == Approx(325.0).epsilon(1e-12));
  CHECK(weather.diffuse_horizontal_w_m2.value[0] == Approx(55.0).epsilon(1e-12));
  CHECK(weather.direct_normal_w_m2.value[1] == Approx(600.0).epsilon(1e-12));
  CHECK(weather.direct_normal_w_m2.value[2] == Approx(150.0).epsilon(1e-12));
  CHECK(weather.diffuse_horizontal_w_m2.value[3] == Approx(150.0).epsilon(1e-12));
}

TEST_CASE("light fades through twilight without a step", "[thermal][weather]") {
  std::vector<SunMoment> sun;
  for (int i = 0; i <= 2400; ++i) {  // from 24 degrees below to the horizon
    sun.push_back({1.0 * i, std::sin((-24.0 + 0.01 * i) * pi / 180.0), 1.0});
  }
  const Weather weather = clear_sky_weather(plain_day, plain_light(), sun);
  const auto& direct = weather.direct_normal_w_m2.value;
  const auto& diffuse = weather.diffuse_horizontal_w_m2.value;
  CHECK(direct[2300] == 0.0);    // 1 degree below
  CHECK(diffuse[0] == 0.0);      // 24 degrees below
  CHECK(diffuse[2400] == 10.0);  // the horizon
  CHECK(direct[2400] == Approx(50.0).epsilon(1e-9));
  // Civil twilight ends 6 degrees below with some 3.4 lx of the horizon's 600 to 800 (USNO).
  CHECK(diffuse[1800] / diffuse[2400] == Approx(3.4 / 700.0).epsilon(0.3));
  for (std::size_t i = 1; i < diffuse.size(); ++i) {
    // The law of twilight is of six pieces, which miss each other by up to 1 % where they meet.
    CHECK(diffuse[i] >= 0.99 * diffuse[i - 1]);
    CHECK(diffuse[i] - diffuse[i - 1] < 0.1);
    CHECK(direct[i] >= direct[i - 1]);
    CHECK(direct[i] - direct[i - 1] < 1.0);
  }
}

TEST_CASE("the sky's heat goes with the fourth power of the air's temperature",
          "[thermal][weather]") {
  const Weather weather = clear_sky_weather(plain_day, plain_light(), even_sun(-24.0, 0.0, 12.0));
  for (std::size_t i = 0; i < weather.air_temperature_k.value.size(); ++i) {
    const double ratio = weather.air_temperature_k.value[i] / 290.0;
    CHECK(weather.sky_long_wave_w_m2.value[i] ==
          Approx(300.0 * ratio * ratio * ratio * ratio).epsilon(1e-12));
  }
}

TEST_CASE("vapour is that of the dew point, but never above saturation", "[thermal][weather]") {
  DayOfAir day = plain_day;
  day.dew_point_k = 290.0;  // warmer than the night's air
  const Weather weather = clear_sky_weather(day, plain_light(), even_sun(-24.0, 0.0, 12.0));
  bool capped = false;
  for (std::size_t i = 0; i < weather.air_temperature_k.value.size(); ++i) {
    const double air_k = weather.air_temperature_k.value[i];
    const double expected =
        air_k < 290.0 ? saturation_over_water_hpa(air_k) : vapour_pressure_of_dew_point_hpa(290.0);
    CHECK(weather.vapour_pressure_hpa.value[i] == Approx(expected).epsilon(1e-9));
    capped = capped || air_k < 290.0;
  }
  CHECK(capped);
  CHECK(weather.wind_speed_m_s.value.front() == 3.0);
  CHECK(weather.pressure_hpa.value.back() == 1000.0);
}

TEST_CASE("what cannot be a clear day is refused", "[thermal][weather]") {
  const auto sun = even_sun(-24.0, 0.0, 12.0);
  const auto light = plain_light();
  SECTION("no sun") { CHECK_THROWS_AS(clear_sky_weather(plain_day, light, {}), InputError); }
  SECTION("times that do not ascend") {
    CHECK_THROWS_AS(clear_sky_weather(plain_day, light, {{0.0, 0.5, 1.0}, {0.0, 0.6, 1.0}}),
                    InputError);
  }
  SECTION("low above high") {
    DayOfAir day = plain_day;
    day.low_k = 301.0;
    CHECK_THROWS_AS(clear_sky_weather(day, light, sun), InputError);
  }
  SECTION("a dew point that is no number") {
    DayOfAir day = plain_day;
    day.dew_point_k = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(clear_sky_weather(day, light, sun), InputError);
  }
  SECTION("light of another size") {
    ClearSkyLight wrong = light;
    wrong.direct_normal_w_m2.pop_back();
    CHECK_THROWS_AS(clear_sky_weather(plain_day, wrong, sun), InputError);
  }
  SECTION("negative light") {
    ClearSkyLight wrong = light;
    wrong.diffuse_horizontal_w_m2[1] = -1.0;
    CHECK_THROWS_AS(clear_sky_weather(plain_day, wrong, sun), InputError);
  }
}

}  // namespace nadir::thermal
