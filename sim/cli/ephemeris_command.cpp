#include "sim/cli/ephemeris_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "ephemeris/eclipse.hpp"
#include "ephemeris/lunar_reflectance.hpp"
#include "ephemeris/rise_set.hpp"
#include "ephemeris/sun_moon.hpp"
#include "sim/files/data_directory.hpp"
#include "sim/files/lunar_table.hpp"
#include "sim/files/spectrum_file.hpp"

namespace nadir::sim {
namespace {

using ephemeris::BodyPosition;
using ephemeris::Instant;
using ephemeris::SkyBody;
using ephemeris::SunAndMoon;

constexpr Micrometres green{0.55};

struct EphemerisOptions {
  std::string time;
  ephemeris::Site site;
  double ut1_utc_s = 0.0;
  std::string format = "text";
};

/// Something that happens in the sky, ready to print.
struct Event {
  Instant time;
  std::string what;   ///< such as "sunrise"
  std::string angle;  ///< "azimuth" or "elevation"
  double deg = 0.0;
};

/// What the 24 hours after the instant bring, in the order of time.
struct Day {
  bool sun_up = false, moon_up = false;  ///< at the start
  std::vector<Event> events;
};

struct Light {
  double sun = 0.0, moon = 0.0;  ///< W m^-2 um^-1 outside the air, at 0.55 um, eclipses included
  double sun_left = 1.0, moon_left = 1.0;  ///< by eclipses
};

struct View {
  Instant instant;
  ephemeris::Site site;
  SunAndMoon seen;
  Light light;
  std::optional<Day> day;  ///< none where it leaves the years of the ephemeris
};

Light light_of(const Instant& instant, const SunAndMoon& seen) {
  const auto library = data_directory() / "library" / "illumination";
  const spectral::Curve sun = read_curve(library / "solar.csv", "", SpectrumQuantity::irradiance,
                                         spectral::Outside::reject);
  const ephemeris::LunarModel moon = read_lunar_model(library / "moon.csv");
  Light light;
  light.sun_left = ephemeris::solar_eclipse(seen).factor(green);
  light.moon_left = ephemeris::lunar_eclipse(ephemeris::earth_shadow(instant)).factor(green);
  const double sun_au = seen.sun.distance.value / astro::astronomical_unit_m;
  light.sun = sun.at(green) / (sun_au * sun_au) * light.sun_left;
  light.moon =
      ephemeris::lunar_irradiance(moon, seen.lunar, sun).irradiance.at(green) * light.moon_left;
  return light;
}

void add(Day& day, const ephemeris::Crossings& crossings, const std::string& up,
         const std::string& down) {
  for (const ephemeris::Crossing& event : crossings.events) {
    day.events.push_back(
        {event.time, event.rises ? up : down, "azimuth", to_degrees(event.azimuth)});
  }
}

Day day_after(const Instant& instant, const ephemeris::Site& site) {
  const ephemeris::SkyDay sky{instant, site};
  const auto sun = sky.rise_and_set(SkyBody::sun), moon = sky.rise_and_set(SkyBody::moon);
  Day day{sun.above_at_start, moon.above_at_start, {}};
  add(day, sun, "sunrise", "sunset");
  add(day, moon, "moonrise", "moonset");
  const std::array<std::pair<const char*, double>, 3> twilights{
      {{"civil", ephemeris::civil_twilight_deg},
       {"nautical", ephemeris::nautical_twilight_deg},
       {"astronomical", ephemeris::astronomical_twilight_deg}}};
  for (const auto& [name, elevation_deg] : twilights) {
    add(day, sky.sun_through(degrees(elevation_deg)), fmt::format("{} dawn", name),
        fmt::format("{} dusk", name));
  }
  for (const auto& [body, name] : {std::pair{SkyBody::sun, "sun"}, {SkyBody::moon, "moon"}}) {
    for (const ephemeris::Transit& transit : sky.transits(body)) {
      day.events.push_back({transit.time, fmt::format("{} in transit", name), "elevation",
                            to_degrees(transit.elevation)});
    }
  }
  std::stable_sort(day.events.begin(), day.events.end(), [&](const Event& a, const Event& b) {
    return a.time - instant < b.time - instant;
  });
  return day;
}

std::string to_the_second(const Instant& time) {
  return (time + Seconds{0.5}).to_string().substr(0, 19) + "Z";
}

nlohmann::ordered_json json_of(const BodyPosition& body) {
  return {{"azimuth_deg", to_degrees(body.azimuth)},
          {"elevation_deg", to_degrees(body.elevation)},
          {"apparent_elevation_deg", to_degrees(body.apparent_elevation)},
          {"distance_m", body.distance.value},
          {"angular_radius_deg", to_degrees(body.angular_radius)}};
}

nlohmann::ordered_json json_of(const ephemeris::Selenographic& point) {
  return {{"longitude_deg", to_degrees(point.longitude)},
          {"latitude_deg", to_degrees(point.latitude)}};
}

nlohmann::ordered_json json_of(const Day& day, const Instant& start) {
  nlohmann::ordered_json events = nlohmann::ordered_json::array();
  for (const Event& event : day.events) {
    events.push_back({{"time_utc", event.time.to_string()},
                      {"seconds_after", (event.time - start).value},
                      {"event", event.what},
                      {event.angle + "_deg", event.deg}});
  }
  return {{"sun_up_at_start", day.sun_up},
          {"moon_up_at_start", day.moon_up},
          {"events", std::move(events)}};
}

std::string json_text(const View& view) {
  const SunAndMoon& seen = view.seen;
  nlohmann::ordered_json json;
  json["time_utc"] = view.instant.to_string();
  json["ut1_utc_s"] = view.instant.ut1_utc().value;
  json["site"] = {{"latitude_deg", view.site.latitude_deg},
                  {"longitude_deg", view.site.longitude_deg},
                  {"height_m", view.site.height_m}};
  json["sun"] = json_of(seen.sun);
  json["sun"]["irradiance_550nm"] = view.light.sun;
  json["sun"]["eclipse_factor_550nm"] = view.light.sun_left;
  json["moon"] = json_of(seen.moon);
  json["moon"]["phase_angle_deg"] = to_degrees(seen.phase.phase_angle);
  json["moon"]["illuminated_fraction"] = seen.phase.illuminated_fraction;
  json["moon"]["sun_overhead"] = json_of(seen.lunar.sun);
  json["moon"]["observer_overhead"] = json_of(seen.lunar.observer);
  json["moon"]["irradiance_550nm"] = view.light.moon;
  json["moon"]["eclipse_factor_550nm"] = view.light.moon_left;
  if (view.day) json["next_24_hours"] = json_of(*view.day, view.instant);
  return json.dump(2) + "\n";
}

std::string row(const char* name, double sun, double moon, int decimals, const char* unit) {
  return fmt::format("{:<22}{:>16.{}f}{:>16.{}f}  {}\n", name, sun, decimals, moon, decimals, unit);
}

std::string moon_row(const char* name, const std::string& value, const char* unit = "") {
  return fmt::format("{:<22}{:>16}{:>16}{}\n", name, "", value, unit);
}

std::string point_row(const char* name, const ephemeris::Selenographic& point) {
  return moon_row(
      name,
      fmt::format("{:.3f} {} {:.3f} {}", std::abs(to_degrees(point.longitude)),
                  point.longitude.value < 0.0 ? "W" : "E", std::abs(to_degrees(point.latitude)),
                  point.latitude.value < 0.0 ? "S" : "N"),
      "  deg on the moon");
}

std::string positions_text(const View& view) {
  const BodyPosition &sun = view.seen.sun, &moon = view.seen.moon;
  std::string text = fmt::format("{:<22}{:>16}{:>16}\n", "", "sun", "moon");
  text += row("azimuth", to_degrees(sun.azimuth), to_degrees(moon.azimuth), 5, "deg");
  text += row("elevation", to_degrees(sun.elevation), to_degrees(moon.elevation), 5, "deg");
  text += row("apparent elevation", to_degrees(sun.apparent_elevation),
              to_degrees(moon.apparent_elevation), 5, "deg");
  text += row("distance", sun.distance.value / 1e3, moon.distance.value / 1e3, 1, "km");
  text += row("angular radius", to_degrees(sun.angular_radius), to_degrees(moon.angular_radius), 5,
              "deg");
  text += fmt::format("{:<22}{:>16.1f}{:>16.4g}  W m^-2 um^-1, outside the air\n",
                      "light at 0.55 um", view.light.sun, view.light.moon);
  if (view.light.sun_left < 1.0 || view.light.moon_left < 1.0) {
    text += fmt::format("{:<22}{:>16.4g}{:>16.4g}  of the light at 0.55 um\n", "left by an eclipse",
                        view.light.sun_left, view.light.moon_left);
  }
  text += moon_row("phase angle", fmt::format("{:.4f}", to_degrees(view.seen.phase.phase_angle)),
                   "  deg");
  text +=
      moon_row("illuminated fraction", fmt::format("{:.5f}", view.seen.phase.illuminated_fraction));
  text += point_row("sun overhead", view.seen.lunar.sun);
  text += point_row("observer overhead", view.seen.lunar.observer);
  return text;
}

std::string always_text(const Day& day, const char* name, bool up) {
  const std::string rise = std::string{name} + "rise", set = std::string{name} + "set";
  const bool none = std::none_of(day.events.begin(), day.events.end(), [&](const Event& event) {
    return event.what == rise || event.what == set;
  });
  if (!none) return "";
  return fmt::format("{:<22}the {} stays {} the horizon\n", "", name, up ? "above" : "below");
}

std::string day_text(const Day& day) {
  std::string text = "\nthe next 24 hours\n";
  text += always_text(day, "sun", day.sun_up) + always_text(day, "moon", day.moon_up);
  for (const Event& event : day.events) {
    text += fmt::format("{:<22}{:<20}{} {:.2f} deg\n", to_the_second(event.time), event.what,
                        event.angle, event.deg);
  }
  return text;
}

std::string plain_text(const View& view) {
  const ephemeris::Site& site = view.site;
  std::string text = fmt::format("{:<22}{}\n", "time", view.instant.to_string());
  text += fmt::format("{:<22}latitude {:.6f} deg, longitude {:.6f} deg, height {:.1f} m\n\n",
                      "site", site.latitude_deg, site.longitude_deg, site.height_m);
  text += positions_text(view);
  return view.day ? text + day_text(*view.day) : text;
}

void report_ephemeris(const EphemerisOptions& options) {
  if (options.format != "text" && options.format != "json") {
    throw InputError{fmt::format("--format is \"{}\", expected text or json", options.format)};
  }
  const Instant instant = Instant::parse_utc(options.time, Seconds{options.ut1_utc_s});
  const SunAndMoon seen = ephemeris::sun_and_moon(instant, options.site);
  View view{instant, options.site, seen, light_of(instant, seen), std::nullopt};
  try {
    view.day = day_after(instant, options.site);
  } catch (const InputError&) {
    fmt::print(stderr, "warning: the next 24 hours leave the years of the ephemeris\n");
  }
  if (const auto caution = instant.caution()) fmt::print(stderr, "warning: {}\n", *caution);
  fmt::print("{}", options.format == "json" ? json_text(view) : plain_text(view));
}

}  // namespace

void add_ephemeris_command(CLI::App& app) {
  auto options = std::make_shared<EphemerisOptions>();
  CLI::App* command = app.add_subcommand(
      "ephemeris", "Sun and moon in the sky of a site: places, light, rise, set");
  command->add_option("--time", options->time, "UTC, ISO 8601, such as 2026-06-21T16:00:00Z")
      ->required();
  command->add_option("--latitude", options->site.latitude_deg, "Geodetic, north positive [deg]")
      ->required();
  command->add_option("--longitude", options->site.longitude_deg, "East positive [deg]")
      ->required();
  command->add_option("--height", options->site.height_m, "Above the WGS84 ellipsoid [m]");
  command->add_option("--ut1-utc", options->ut1_utc_s, "UT1 - UTC, from IERS bulletins [s]");
  command->add_option("--format", options->format, "text or json");
  command->callback([options] { report_ephemeris(*options); });
}

}  // namespace nadir::sim
