#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/scenario/build_temperature.hpp"

namespace nadir::sim {
namespace {

constexpr double minutes_per_day = 1440.0, seconds_per_day = 86400.0;

/// Nearest length of time of which 24 h are a whole number: whole minutes, then what suits a
/// second.
double nearest_share_of_day(double minutes) {
  double best = 0.25;
  for (const double candidate : {0.2, 0.5}) {
    if (std::abs(candidate - minutes) < std::abs(best - minutes)) best = candidate;
  }
  for (int candidate = 1; candidate <= 60; ++candidate) {
    if (1440 % candidate == 0 && std::abs(candidate - minutes) < std::abs(best - minutes)) {
      best = candidate;
    }
  }
  return best;
}

/// How many times the attribute's minutes fit into 24 h; something else than a whole number is a
/// mistake.
long parts_of_day(const BuildContext& context, const CheckedElement& element,
                  const std::string& attribute) {
  const auto minutes = element.find<double>(attribute);
  if (!minutes) return 144;  // refused already: 10 min
  const double parts = minutes_per_day / *minutes;
  const long whole = std::lround(parts);
  // 1e-9: decimals such as 0.2 are not exact in binary
  if (std::abs(parts - static_cast<double>(whole)) > 1e-9 * parts) {
    context.mistake(
        element.where(attribute),
        fmt::format("24 h are not a whole number of times {} = {} min", attribute, *minutes),
        fmt::format("{} would do", nearest_share_of_day(*minutes)));
  }
  return whole;
}

void build_clock(const BuildContext& context, const CheckedElement& element, HeatInput& heat) {
  const std::size_t before = context.issues.count();
  const long steps = parts_of_day(context, element, "step_min");
  const long shadows = parts_of_day(context, element, "shadow_interval_min");
  const bool fit = std::max(steps, shadows) % std::min(steps, shadows) == 0;
  if (!fit && context.issues.count() == before) {
    context.mistake(element.where("shadow_interval_min"),
                    fmt::format("shadow_interval_min, {}, is neither a multiple nor a whole "
                                "fraction of step_min, {}",
                                element.number("shadow_interval_min"), element.number("step_min")));
  }
  heat.settings.step_s = seconds_per_day / static_cast<double>(steps);
  heat.shadow_interval_s = seconds_per_day / static_cast<double>(shadows);
  // The surroundings' sun is looked up about every hour, at moments of the shadows.
  heat.settings.exposure.surroundings_interval_s =
      heat.shadow_interval_s * std::max(1.0, std::round(3600.0 / heat.shadow_interval_s));
  heat.history_h = element.find<double>("history_h");
  if (!heat.history_h) return;
  heat.settings.history_s = 3600.0 * *heat.history_h;
  const double history_steps = heat.settings.history_s / heat.settings.step_s;
  if (std::abs(history_steps - std::round(history_steps)) > 1e-9 * history_steps &&
      context.issues.count() == before) {
    context.mistake(element.where("history_h"),
                    fmt::format("history_h, {}, is not a whole number of steps of {} min",
                                *heat.history_h, element.number("step_min")));
  }
}

WeatherFileInput build_weather_file(const BuildContext& context, const CheckedElement& element) {
  const std::map<std::string, WeatherFormat> formats{{"auto", WeatherFormat::automatic},
                                                     {"csv", WeatherFormat::csv},
                                                     {"tmy3", WeatherFormat::tmy3},
                                                     {"epw", WeatherFormat::epw},
                                                     {"surfrad", WeatherFormat::surfrad}};
  const std::map<std::string, SkyLongWave> skies{{"from_air", SkyLongWave::from_air},
                                                 {"prata", SkyLongWave::prata},
                                                 {"brutsaert", SkyLongWave::brutsaert},
                                                 {"idso", SkyLongWave::idso},
                                                 {"swinbank", SkyLongWave::swinbank}};
  WeatherFileInput file;
  file.file = element.value<std::filesystem::path>("file");
  if (const auto format = element.find<std::string>("format")) file.format = formats.at(*format);
  if (const auto sky = element.find<std::string>("long_wave")) file.long_wave = skies.at(*sky);
  if (const auto any = element.find<std::string>("any_year")) file.any_year = *any == "true";
  file.where = context.source.locate(element.offset);
  return file;
}

/// What is not given follows what is.
ClearSkyInput build_clear_sky(const BuildContext& context, const CheckedElement& element) {
  ClearSkyInput sky;
  const double swing_k = sky.air_high_k - sky.air_low_k;
  const double depression_k = sky.air_low_k - sky.dew_point_k;
  const auto low = build_kelvin(context, element, "air_low");
  const auto high = build_kelvin(context, element, "air_high");
  const auto dew_point = build_kelvin(context, element, "dew_point");
  sky.air_low_k = low ? *low : high ? *high - swing_k : sky.air_low_k;
  sky.air_high_k = high.value_or(sky.air_low_k + swing_k);
  sky.dew_point_k = dew_point.value_or(sky.air_low_k - depression_k);
  sky.wind_m_s = element.number("wind_m_s");
  sky.where = context.source.locate(element.offset);
  if (sky.air_high_k < sky.air_low_k) {
    context.mistake(where_kelvin(element, "air_high"),
                    "the air's highest temperature is below its lowest");
  }
  if (sky.dew_point_k > sky.air_low_k) {
    context.mistake(where_kelvin(element, "dew_point"),
                    fmt::format("the dew point, {:.2f} K, is above the air's lowest temperature, "
                                "{:.2f} K",
                                sky.dew_point_k, sky.air_low_k));
  }
  return sky;
}

}  // namespace

std::optional<HeatInput> build_heat(const BuildContext& context, const CheckedElement& root) {
  const CheckedElement* element = root.child("heat");
  if (element == nullptr) return std::nullopt;
  HeatInput heat;
  build_clock(context, *element, heat);
  heat.shadow_days = element->value<int>("shadow_days");
  heat.settings.resolution_m = element->number("resolution_m");
  heat.settings.indirect_factor = element->number("indirect_factor");
  heat.settings.spin_up_k = element->number("spin_up_k");
  heat.settings.spin_up_days = element->value<int>("spin_up_days");
  heat.settings.grid.first_fraction = element->number("first_fraction");
  heat.settings.grid.growth = element->number("growth");
  heat.settings.exposure.sky_rays = element->value<int>("sky_rays");
  heat.settings.exposure.surroundings = element->value<int>("surroundings");
  heat.substances = element->find<std::filesystem::path>("substances");
  heat.ground_reflectance = element->find<double>("ground_reflectance");
  heat.where = context.source.locate(element->offset);
  if (element->children.empty()) return heat;
  const CheckedElement& weather = element->children.front();
  if (weather.type->name == "weather_file") {
    heat.weather = build_weather_file(context, weather);
  } else {
    heat.weather = build_clear_sky(context, weather);
  }
  return heat;
}

}  // namespace nadir::sim
