#include "thermal/solve/heat_model.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "thermal/conduction/temperature_range.hpp"
#include "thermal/solve/time_grid.hpp"

namespace nadir::thermal {
namespace {

void refuse_heat(const std::string& what, double value, const std::string& expected) {
  throw InputError{what + " is " + number_text(value) + ", expected " + expected};
}
struct Limits {
  double least, most;
};
void within_limits(const std::string& what, double value, Limits limits) {
  if (value >= limits.least && value <= limits.most) return;  // a NaN does not
  refuse_heat(what, value, number_text(limits.least) + " to " + number_text(limits.most));
}

void check_heat_settings(const HeatSettings& settings) {
  within_limits("heat balance: the step in seconds", settings.step_s, {1.0, 21600.0});
  within_limits("heat balance: the resolution in metres", settings.resolution_m, {1e-3, 1e6});
  within_limits("heat balance: the factor of cells seen indirectly", settings.indirect_factor,
                {1.0, 1e6});
  // A century; longer ones are typing errors.
  within_limits("heat balance: the history in seconds", settings.history_s,
                {0.0, 36525.0 * seconds_per_day});
  within_limits("heat balance: what a day may change in K", settings.spin_up_k, {1e-9, 100.0});
  within_limits("heat balance: days of spin-up", settings.spin_up_days, {1.0, 100000.0});
  within_limits("heat balance: rays to the sky", settings.exposure.sky_rays, {1.0, 1e6});
  within_limits("heat balance: surroundings followed", settings.exposure.surroundings, {0.0, 1e6});
  within_limits("heat balance: interval of the surroundings' sun in seconds",
                settings.exposure.surroundings_interval_s, {1.0, seconds_per_day});
}

void check_cover(const HeatModel& model) {
  // Times come from calendars by way of doubles: a second is as good as on time.
  constexpr double slack_s = 1.0;
  const double history_s = std::max(model.settings.history_s, seconds_per_day);
  const double first_s = model.weather.first_s(), last_s = model.weather.last_s();
  if (first_s > slack_s - history_s) {
    throw InputError{"the weather begins " + number_text(-first_s / 3600.0) +
                     " h before the picture, expected at least " + number_text(history_s / 3600.0) +
                     " h"};
  }
  if (last_s < -slack_s) {
    throw InputError{"the weather ends " + number_text(-last_s / 3600.0) +
                     " h before the picture, expected weather up to the picture"};
  }
}

void check_moment(const SunTrack& sun, std::size_t i) {
  const std::string which = "the sun's track: moment " + std::to_string(i + 1);
  const std::size_t last = sun.time_s.size() - 1;
  const double interval_s = -sun.time_s.front() / static_cast<double>(last);
  const double even_s = -interval_s * static_cast<double>(last - i);
  if (!(std::abs(sun.time_s[i] - even_s) <= 1e-6 * interval_s)) {
    refuse_heat(which, sun.time_s[i], number_text(even_s) + " s: even intervals up to the picture");
  }
  if (!(std::abs(length(sun.direction[i]) - 1.0) <= 1e-6)) {
    refuse_heat(which + ": length of the direction", length(sun.direction[i]), "1");
  }
  const std::uint32_t bits = sun.epoch[i];
  if (bits == 0 || (bits & (bits - 1)) != 0) {
    refuse_heat(which + ": epoch", static_cast<double>(bits), "a single bit");
  }
}

void check_track(const SunTrack& sun) {
  const std::size_t moments = sun.time_s.size();
  if (moments < 2 || sun.direction.size() != moments || sun.epoch.size() != moments) {
    throw InputError{"the sun's track: " + std::to_string(moments) + " times, " +
                     std::to_string(sun.direction.size()) + " directions, " +
                     std::to_string(sun.epoch.size()) +
                     " epochs, expected as many of each and at least 2"};
  }
  if (!(sun.time_s.back() == 0.0)) {
    refuse_heat("the sun's track: its last moment in seconds", sun.time_s.back(), "0, the picture");
  }
  for (std::size_t i = 0; i < moments; ++i) check_moment(sun, i);
  // 24 hours and no whole number of intervals: the last one may be cut short.
  const double interval_s = -sun.time_s.front() / static_cast<double>(moments - 1);
  if (!(-sun.time_s.front() > seconds_per_day - interval_s)) {
    refuse_heat("the sun's track: its length in seconds", -sun.time_s.front(), "at least 86400");
  }
  within_limits("the sun's track: sine of the sun's radius", sun.sin_radius, {0.0, 0.1});
}

/// Without emission, film and anything behind it no temperature balances the sun.
bool keeps_all(const HeatMaterial& material) {
  const auto* film = std::get_if<FixedFilm>(&material.surface.convection);
  const bool closed = std::holds_alternative<AdiabaticBack>(material.layers.back) ||
                      std::holds_alternative<OpenBack>(material.layers.back);
  return material.surface.emissivity == 0.0 && film != nullptr && film->film_w_m2_k <= 0.0 &&
         closed;
}

void check_material(const HeatModel& model, std::size_t i) {
  if (!model.materials[i]) return;
  try {
    check(*model.materials[i], model.settings.grid);
  } catch (const InputError& error) {
    throw InputError{"material " + std::to_string(i) + ": " + error.issues().front().message};
  }
}

void check_surrounding(const SurroundingSurface& surface, const std::string& name) {
  within_limits(name + ": solar reflectance", surface.solar_reflectance, {0.0, 1.0});
  within_limits(name + ": emissivity", surface.emissivity, {0.0, 1.0});
  if (const auto* fixed = std::get_if<Kelvin>(&surface.temperature)) {
    within_limits(name + ": temperature in K", fixed->value, {0.0, 1e5});
  }
  if (const auto* air = std::get_if<FollowsAir>(&surface.temperature)) {
    within_limits(name + ": offset to the air in K", air->offset_k, {-150.0, 1000.0});
  }
}

void check_whose(const HeatModel& model, std::size_t i, const std::string& name) {
  const auto* own = std::get_if<OfItsHeatBalance>(&model.surroundings[i].temperature);
  if (own == nullptr) return;
  const std::size_t whose = own->whose.value_or(static_cast<std::uint32_t>(i));
  if (whose < model.materials.size() && model.materials[whose]) return;
  throw InputError{name + " has the temperature of the heat balance of material " +
                   std::to_string(whose) + ", which has none"};
}

/// What the sun alone makes of a surface, to the fourth power. 400 K is a black one that has
/// 1450 W m^-2 and nothing but its own radiation to cool it. One that takes more of sunlight than
/// it emits becomes warmer unless air cools it: every law of convection does, a given film may not.
double warmest_by_sun_k4(const SurfaceProperties& surface) {
  constexpr double sunlit_k = 400.0;
  constexpr double cools_w_m2_k = 5.0;  // 100 K over the air: 500 W m^-2, half the sun
  const double k4 = std::pow(sunlit_k, 4);
  const auto* given = std::get_if<FixedFilm>(&surface.convection);
  if (given == nullptr || given->film_w_m2_k >= cools_w_m2_k) return k4;
  if (surface.solar_absorptance <= surface.emissivity) return k4;
  return k4 * surface.solar_absorptance / surface.emissivity;  // infinite without emission
}

double behind_k(const Back& back) {
  constexpr double warmest_air_k = 350.0;  // that check(Weather) lets pass
  if (const auto* fixed = std::get_if<FixedBack>(&back)) return fixed->temperature.value;
  const auto* room = std::get_if<RoomBack>(&back);
  if (room == nullptr) return 0.0;
  return room->temperature ? room->temperature->value : warmest_air_k + room->offset_k;
}

}  // namespace

Kelvin warmest_of(const HeatMaterial& material) {
  double released_w_m2 = 0.0;
  for (const Layer& layer : material.layers.layers) {
    released_w_m2 += std::max(0.0, layer.heat_w_m2);
  }
  double k4 = warmest_by_sun_k4(material.surface);
  if (released_w_m2 > 0.0) {
    k4 += released_w_m2 / (material.surface.emissivity * si::stefan_boltzmann);
  }
  const double k = std::max(std::pow(k4, 0.25), behind_k(material.layers.back));
  return Kelvin{std::min(k, greatest_temperature.value)};
}

void check(const HeatMaterial& material, const GridSettings& grid) {
  static_cast<void>(make_grid(material.layers, grid));
  const SurfaceProperties& surface = material.surface;
  within_limits("solar absorptance", surface.solar_absorptance, {0.0, 1.0});
  within_limits("emissivity", surface.emissivity, {0.0, 1.0});
  within_limits("wind factor", surface.wind_factor, {0.0, 100.0});
  within_limits("wetness", surface.wetness, {0.0, 1.0});
  if (const auto* given = std::get_if<FixedFilm>(&surface.convection)) {
    within_limits("film of air in W m^-2 K^-1", given->film_w_m2_k, {0.0, 1e6});
  }
  if (keeps_all(material)) {
    throw InputError{
        "nothing takes heat away, expected an emissivity or a film above 0, or a back with a "
        "temperature"};
  }
}

void check(const HeatModel& model) {
  check_heat_settings(model.settings);
  check(model.weather);
  check_cover(model);
  check_track(model.sun);
  for (std::size_t i = 0; i < model.materials.size(); ++i) check_material(model, i);
  if (model.surroundings.size() < model.materials.size()) {
    throw InputError{"heat balance: " + std::to_string(model.materials.size()) +
                     " materials, but only " + std::to_string(model.surroundings.size()) +
                     " as others see them"};
  }
  for (std::size_t i = 0; i < model.surroundings.size(); ++i) {
    const std::string name = "surroundings of material " + std::to_string(i);
    check_surrounding(model.surroundings[i], name);
    check_whose(model, i, name);
  }
  check_surrounding(model.ground_about, "ground about the scene");
  if (std::holds_alternative<OfItsHeatBalance>(model.ground_about.temperature)) {
    throw InputError{
        "the ground about the scene cannot have a heat balance, expected a "
        "temperature or an offset to the air"};
  }
}

}  // namespace nadir::thermal
