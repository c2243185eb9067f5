#include "sim/run/heat_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "ephemeris/sun_moon.hpp"
#include "sim/files/data_directory.hpp"
#include "sim/files/substance_table.hpp"
#include "sim/run/error_list.hpp"
#include "sim/run/load_air.hpp"
#include "sim/run/load_weather.hpp"
#include "sim/run/read_curves.hpp"
#include "thermal/surface/broadband_optics.hpp"

namespace nadir::sim {
namespace {

using thermal::BroadbandOptics;
using thermal::HeatMaterial;
using thermal::HeatModel;
using thermal::SurroundingSurface;

constexpr double seconds_of_day = 86400.0;
/// A day's wave has fallen to exp(-4), 2 %, and what is below no longer matters.
constexpr double deep_enough = 4.0;
/// Less known of sunlight, or of a black body's radiance, is worth a word: spectra that end at 14
/// um hold half of the latter, the window of 8 to 14 um alone 0.38.
constexpr double sunlight_enough = 0.8, long_wave_enough = 0.35;

/// In ten days the sun's noon height changes by up to 4 degrees, and layers have forgotten what
/// stood on them: a track of one day must not stand for more, and what came or went before no
/// longer shows.
constexpr double days_alike = 10.0;

/// From a day before objects first come or go, so that the days before that, which are those of
/// the first 24 hours again, hold nothing that was not there.
double since_changes_s(const Epochs& epochs) {
  const double change_s = epochs.first_change_s(days_alike * seconds_of_day);
  return change_s > 0.0 ? (std::ceil(change_s / seconds_of_day) + 1.0) * seconds_of_day : 0.0;
}

/// Where the sun stood at even steps up to the picture.
thermal::SunTrack sun_track(const Scenario& scenario, double history_s, const Epochs& epochs) {
  thermal::SunTrack track;
  const HeatInput& heat = *scenario.heat;
  const double own_s = history_s > days_alike * seconds_of_day ? history_s : seconds_of_day;
  const double track_s =
      std::max({heat.shadow_days * seconds_of_day, own_s, since_changes_s(epochs)});
  const ephemeris::Site site{scenario.origin.latitude_deg, scenario.origin.longitude_deg,
                             scenario.origin.height_m};
  const double interval_s = heat.shadow_interval_s;
  const auto count = static_cast<int>(std::llround(track_s / interval_s));
  std::optional<ephemeris::CelestialPole> pole;
  double pole_s = 0.0;
  for (int i = -count; i <= 0; ++i) {
    const double time_s = i * interval_s;
    const ephemeris::Instant moment = scenario.time + Seconds{time_s};
    if (!pole || time_s - pole_s >= seconds_of_day) {  // it hardly moves within a day
      pole = ephemeris::celestial_pole(moment.tt());
      pole_s = time_s;
    }
    const auto seen = ephemeris::sun_and_moon(moment, site, {}, *pole);
    track.time_s.push_back(time_s);
    track.direction.push_back(seen.sun.direction_enu);
    track.epoch.push_back(epochs.at(time_s));
    track.sin_radius = std::sin(seen.sun.angular_radius.value);
  }
  return track;
}

/// Layers, surface and optics of the scenario's materials.
class HeatMaterials {
 public:
  HeatMaterials(const Scenario& scenario, const HeatScene& scene, InputFiles& files,
                Diagnostics& diagnostics)
      : scenario_{scenario},
        scene_{scene},
        files_{files},
        diagnostics_{diagnostics},
        sunlight_{read_curve(
            files.note(data_directory() / "library" / "illumination" / "sunlight_at_ground.csv"),
            "", SpectrumQuantity::irradiance, spectral::Outside::zero)} {}

  /// Variants of a material differ in their temperature alone.
  [[nodiscard]] const BroadbandOptics& optics(std::size_t variant) {
    const std::size_t material = scene_.materials[variant].shown_as.value_or(variant);
    const auto found = optics_.find(material);
    if (found != optics_.end()) return found->second;
    const auto made = thermal::broadband_optics(scene_.materials[material], sunlight_);
    return optics_.emplace(material, made).first->second;
  }

  [[nodiscard]] HeatMaterial read(std::size_t material, const HeatBalanceInput& input) {
    const BroadbandOptics& from_spectra = optics(material);
    HeatMaterial made;
    made.layers = layers(input);
    made.surface = {value(input, input.solar_absorptance, from_spectra.solar_absorptance,
                          {"sunlight", "solar_absorptance", from_spectra.solar_covered,
                           sunlight_enough, material}),
                    value(input, input.emissivity, from_spectra.emissivity,
                          {"long-wave radiation", "emissivity", from_spectra.long_wave_covered,
                           long_wave_enough, material}),
                    input.convection, input.wind_factor, input.wetness};
    at_element(input.where, [&] { thermal::check(made, scenario_.heat->settings.grid); });
    return made;
  }

 private:
  struct Wanted {
    const char* light;
    const char* attribute;
    double covered, enough;
    std::size_t material;
  };

  [[nodiscard]] double value(const HeatBalanceInput& input, std::optional<double> stated,
                             double from_spectra, const Wanted& wanted) {
    if (stated) return *stated;
    const std::string& name = scene_.materials[wanted.material].name;
    if (!(wanted.covered > 0.0)) {
      throw InputError{InputIssue{
          input.where,
          fmt::format("the spectra of material \"{}\" say nothing of {}", name, wanted.light),
          fmt::format("give <heat_balance> the attribute {}", wanted.attribute),
          {}}};
    }
    if (wanted.covered < wanted.enough) {
      warn_at(
          input.where,
          fmt::format("the spectra of material \"{}\" cover {:.0f} % of {}: its {} is their "
                      "mean, {:.2f}",
                      name, 100.0 * wanted.covered, wanted.light, wanted.attribute, from_spectra),
          diagnostics_);
    }
    return from_spectra;
  }

  [[nodiscard]] thermal::LayerStack layers(const HeatBalanceInput& input) {
    thermal::LayerStack stack;
    stack.back = input.back;
    for (const LayerInput& given : input.layers) {
      thermal::Layer layer = given.layer;
      if (!given.substance.empty()) {
        layer.substance = find_substance(substances(), given.substance, given.where).substance;
      }
      const double deep_m =
          deep_enough * thermal::damping_depth(layer.substance, Seconds{seconds_of_day}).value;
      layer.thickness_m = given.thickness_m.value_or(deep_m);
      stack.layers.push_back(layer);
    }
    return stack;
  }

  [[nodiscard]] const SubstanceTable& substances() {
    if (!substances_) {
      const auto own = scenario_.heat->substances;
      substances_ =
          read_substances(files_.note(own.value_or(data_directory() / "library" / "thermal.csv")));
    }
    return *substances_;
  }

  const Scenario& scenario_;
  const HeatScene& scene_;
  InputFiles& files_;
  Diagnostics& diagnostics_;
  spectral::Curve sunlight_;
  std::map<std::size_t, BroadbandOptics> optics_;
  std::optional<SubstanceTable> substances_;
};

/// A map of materials as its neighbours see it: what its materials reflect on the average, with the
/// temperature of the one that covers most of it.
SurroundingSurface seen_of(const materials::MaterialMap& map,
                           const std::vector<SurroundingSurface>& materials) {
  std::vector<double> share(map.materials.size(), 0.0);
  for (const std::uint16_t layer : map.choice) share[layer] += 1.0;
  for (std::size_t i = 0; i < map.cumulative.size(); ++i) {
    const std::size_t layer = i % share.size();
    share[layer] += static_cast<double>(map.cumulative[i]) -
                    (layer > 0 ? static_cast<double>(map.cumulative[i - 1]) : 0.0);
  }
  double all = 0.0;
  for (const double one : share) all += one;
  SurroundingSurface mean{0.0, 0.0, thermal::FollowsAir{}};
  for (std::size_t i = 0; i < share.size(); ++i) {
    const SurroundingSurface& part = materials[map.materials[i]];
    mean.solar_reflectance += share[i] / all * part.solar_reflectance;
    mean.emissivity += share[i] / all * part.emissivity;
  }
  const auto most = std::max_element(share.begin(), share.end()) - share.begin();
  const std::uint32_t whose = map.materials[static_cast<std::size_t>(most)];
  mean.temperature = materials[whose].temperature;
  if (auto* solved = std::get_if<thermal::OfItsHeatBalance>(&mean.temperature)) {
    solved->whose = whose;
  }
  return mean;
}

double remembered_s(const std::vector<thermal::LayerStack>& stacks) {
  constexpr double longest_days = 5.0;  // older weather changes temperatures by tenths of a kelvin
  double longest_s = seconds_of_day;
  for (const auto& stack : stacks) {
    longest_s = std::max(longest_s, thermal::memory_of(stack).value);
  }
  return std::min(longest_days, std::ceil(longest_s / seconds_of_day)) * seconds_of_day;
}

/// How much weather counts where the scenario does not say.
double history_for(const Scenario& scenario, const std::vector<thermal::LayerStack>& stacks,
                   InputFiles& files, Diagnostics& diagnostics) {
  const HeatInput& heat = *scenario.heat;
  // The days of a clear sky are much alike: the first one, repeated, stands for those before it.
  if (std::holds_alternative<ClearSkyInput>(heat.weather)) return seconds_of_day;
  const double wanted_s = remembered_s(stacks);
  const double days_there = std::floor(weather_reaches_back_s(scenario, files) / seconds_of_day);
  if (days_there >= wanted_s / seconds_of_day) return wanted_s;
  warn_at(heat.where,
          fmt::format("the layers remember {:.0f} days, the weather file reaches back {:.0f}: the "
                      "first 24 hours that it has stand for those before",
                      wanted_s / seconds_of_day, days_there),
          diagnostics);
  return std::max(days_there, 1.0) * seconds_of_day;
}

}  // namespace

HeatWeather load_heat_weather(const Scenario& scenario, double least_s, InputFiles& files,
                              Diagnostics& diagnostics,
                              const std::vector<thermal::LayerStack>& stacks) {
  const HeatInput& heat = *scenario.heat;
  double history_s =
      heat.history_h ? *heat.history_h * 3600.0 : history_for(scenario, stacks, files, diagnostics);
  if (history_s < least_s) {
    if (heat.history_h) {
      warn_at(heat.where,
              fmt::format("history_h is {:g}, but objects come or go in the days before the image: "
                          "{:g} hours count",
                          *heat.history_h, least_s / 3600.0),
              diagnostics);
    }
    history_s = least_s;
  }
  return {load_weather(scenario, history_s, files, diagnostics), history_s};
}

HeatModel load_heat_model(const Scenario& scenario, const HeatScene& scene,
                          const std::vector<SurroundingSurface>& known, InputFiles& files,
                          Diagnostics& diagnostics) {
  const HeatInput& heat = *scenario.heat;
  HeatModel model;
  HeatMaterials reader{scenario, scene, files, diagnostics};
  std::vector<thermal::LayerStack> stacks;
  ErrorList errors;
  for (std::size_t i = 0; i < scenario.materials.size(); ++i) {
    model.materials.emplace_back();
    model.surroundings.push_back(known[i]);
    errors.attempt([&] {
      const auto& source = scenario.materials[i].temperature;
      if (const auto* input = std::get_if<HeatBalanceInput>(&source)) {
        model.materials[i] = reader.read(i, *input);
        stacks.push_back(model.materials[i]->layers);
        model.surroundings[i].temperature = thermal::OfItsHeatBalance{};
        model.surroundings[i].emissivity = model.materials[i]->surface.emissivity;
      } else if (reader.optics(i).long_wave_covered > 0.0) {
        model.surroundings[i].emissivity = reader.optics(i).emissivity;
      }
      if (reader.optics(i).solar_covered > 0.0) {
        model.surroundings[i].solar_reflectance = reader.optics(i).solar_reflectance;
      }
    });
  }
  HeatWeather weather;
  errors.attempt([&] {
    weather =
        load_heat_weather(scenario, since_changes_s(scene.epochs), files, diagnostics, stacks);
  });
  errors.throw_if_any();
  for (const auto& map : scene.maps) {
    model.surroundings.push_back(seen_of(map, model.surroundings));
  }
  if (heat.ground_reflectance) model.ground_about.solar_reflectance = *heat.ground_reflectance;
  model.weather = std::move(weather.weather);
  model.settings = heat.settings;
  model.settings.history_s = weather.history_s;
  model.sun = sun_track(scenario, weather.history_s, scene.epochs);
  return model;
}

}  // namespace nadir::sim
