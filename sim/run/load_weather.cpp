#include "sim/run/load_weather.hpp"

#include <limits>
#include <variant>

#include "sim/run/clear_sky_weather.hpp"
#include "sim/run/file_weather.hpp"

namespace nadir::sim {

thermal::Weather load_weather(const Scenario& scenario, double history_s, InputFiles& files,
                              Diagnostics& diagnostics) {
  // A scenario that says nothing of heat has a clear sky.
  const HeatInput heat = scenario.heat.value_or(HeatInput{});
  if (const auto* file = std::get_if<WeatherFileInput>(&heat.weather)) {
    return file_weather(scenario, *file, history_s, files, diagnostics);
  }
  return clear_sky_weather_of(scenario, std::get<ClearSkyInput>(heat.weather), history_s, files,
                              diagnostics);
}

double weather_reaches_back_s(const Scenario& scenario, InputFiles& files, double longest_s) {
  const HeatInput heat = scenario.heat.value_or(HeatInput{});
  if (const auto* file = std::get_if<WeatherFileInput>(&heat.weather)) {
    return file_weather_reaches_back_s(scenario, *file, longest_s, files);
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace nadir::sim
