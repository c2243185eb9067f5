#include "thermal/weather/weather.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "support/catch.hpp"

namespace nadir::thermal {
namespace {

Weather mild_weather() {
  return {.air_temperature_k = {{-7200.0, -3600.0, 0.0}, {280.0, 290.0, 286.0}},
          .vapour_pressure_hpa = {{-7200.0, 0.0}, {8.0, 12.0}},
          .pressure_hpa = {{0.0}, {1000.0}},
          .wind_speed_m_s = {{-7000.0, 600.0}, {1.0, 1.0}},
          .direct_normal_w_m2 = {{-7200.0, -600.0}, {0.0, 660.0}},
          .diffuse_horizontal_w_m2 = {{-7200.0, 0.0}, {0.0, 72.0}},
          .sky_long_wave_w_m2 = {{-7200.0, 0.0}, {300.0, 310.0}}};
}

std::string complaint(const Weather& weather) {
  try {
    check(weather);
  } catch (const InputError& error) {
    return error.issues().front().message;
  }
  return {};
}

TEST_CASE("a series runs linearly between its times and stands still outside", "[thermal]") {
  const TimeSeries series{{-10.0, 0.0, 40.0}, {1.0, 3.0, -5.0}};
  CHECK(series.at(-10.0) == 1.0);
  CHECK(series.at(0.0) == 3.0);
  CHECK(series.at(40.0) == -5.0);
  // Two roundings of a weighted mean.
  CHECK(series.at(-2.5) == Approx(2.5).epsilon(1e-15));
  CHECK(series.at(30.0) == Approx(-3.0).epsilon(1e-15));
  CHECK(series.at(-1e9) == 1.0);
  CHECK(series.at(1e9) == -5.0);
  CHECK(TimeSeries{{7.0}, {4.0}}.at(-3.0) == 4.0);
  CHECK(TimeSeries{{7.0}, {4.0}}.at(7.0) == 4.0);
}

// What is linear in time is met exactly wherever its times lie: a search that takes the wrong
// interval extrapolates, which a bent series then shows.
TEST_CASE("a long series of uneven times finds every interval", "[thermal]") {
  TimeSeries series;
  double time = -1000.0;
  for (int i = 0; i < 500; ++i) {
    series.time_s.push_back(time);
    series.value.push_back(i % 2 == 0 ? 0.0 : 1.0);
    time += 1.0 + 3.0 * std::abs(std::sin(i));
  }
  for (std::size_t i = 0; i + 1 < series.time_s.size(); ++i) {
    const double quarter = 0.75 * series.time_s[i] + 0.25 * series.time_s[i + 1];
    const double expected = i % 2 == 0 ? 0.25 : 0.75;
    CHECK(series.at(quarter) == Approx(expected).epsilon(1e-10));  // times of 1e3 s to 1e-13
  }
}

TEST_CASE("weather at a moment is what each quantity is then", "[thermal]") {
  const WeatherState state = mild_weather().at(-1800.0);
  CHECK(state.air_temperature_k == Approx(288.0).epsilon(1e-14));
  CHECK(state.vapour_pressure_hpa == Approx(11.0).epsilon(1e-14));
  CHECK(state.pressure_hpa == 1000.0);
  CHECK(state.wind_speed_m_s == 1.0);
  CHECK(state.direct_normal_w_m2 == Approx(540.0).epsilon(1e-14));
  CHECK(state.diffuse_horizontal_w_m2 == Approx(54.0).epsilon(1e-14));
  CHECK(state.sky_long_wave_w_m2 == Approx(307.5).epsilon(1e-14));
}

TEST_CASE("weather covers what all its series cover, a single value every moment", "[thermal]") {
  CHECK(mild_weather().first_s() == -7000.0);
  CHECK(mild_weather().last_s() == -600.0);
  const TimeSeries still{{0.0}, {1.0}};
  const Weather always{still, still, still, still, still, still, still};
  CHECK(always.first_s() == -std::numeric_limits<double>::infinity());
  CHECK(always.last_s() == std::numeric_limits<double>::infinity());
}

TEST_CASE("weather that the earth can have is accepted", "[thermal]") {
  CHECK_NOTHROW(check(mild_weather()));
}

TEST_CASE("impossible weather is refused by name, value, time and range", "[thermal]") {
  Weather weather = mild_weather();
  weather.air_temperature_k.value[1] = 17.0;  // Celsius taken for kelvin
  CHECK(complaint(weather) ==
        "weather: air temperature is 17 K at -3600 s from the picture, allowed range is [150, 350] "
        "K");
  weather = mild_weather();
  weather.wind_speed_m_s.value[0] = -0.5;
  CHECK(complaint(weather) ==
        "weather: wind speed is -0.5 m/s at -7000 s from the picture, allowed range is [0, 120] "
        "m/s");
  weather = mild_weather();
  weather.direct_normal_w_m2.value[1] = std::numeric_limits<double>::quiet_NaN();
  CHECK(complaint(weather) ==
        "weather: direct sunlight is nan W/m2 at -600 s from the picture, allowed range is [0, "
        "1500] W/m2");
  weather = mild_weather();
  weather.pressure_hpa.value[0] = 101325.0;  // Pa
  CHECK(complaint(weather).find("air pressure is 101325 hPa at 0 s") != std::string::npos);
}

TEST_CASE("times of the weather that do not ascend are refused", "[thermal]") {
  Weather weather = mild_weather();
  weather.air_temperature_k.time_s[2] = -3600.0;
  CHECK(complaint(weather) ==
        "weather: air temperature: the time -3600 s follows -3600 s, expected ascending times");
  weather = mild_weather();
  weather.vapour_pressure_hpa.time_s.pop_back();
  CHECK(complaint(weather) == "weather: vapour pressure has 1 times, but 2 values");
  weather = mild_weather();
  weather.sky_long_wave_w_m2 = {};
  CHECK(complaint(weather) == "weather: long-wave radiation of the sky has no values");
  weather = mild_weather();
  weather.diffuse_horizontal_w_m2.time_s[1] = std::numeric_limits<double>::infinity();
  CHECK(complaint(weather) == "weather: diffuse sunlight: time 2 is not a finite number");
}

TEST_CASE("every quantity of the weather that is wrong is told", "[thermal]") {
  Weather weather = mild_weather();
  weather.air_temperature_k.value[0] = 1.0;
  weather.diffuse_horizontal_w_m2.value[0] = -1.0;
  try {
    check(weather);
    FAIL("accepted");
  } catch (const InputError& error) {
    CHECK(error.issues().size() == 2);
  }
}

}  // namespace
}  // namespace nadir::thermal
