#include "sim/cli/ephemeris_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "ephemeris/sun_moon.hpp"

namespace nadir::sim {
namespace {

using ephemeris::BodyPosition;
using ephemeris::Instant;
using ephemeris::SunAndMoon;

struct Options {
  std::string time;
  ephemeris::Site site;
  double ut1_utc_s = 0.0;
  std::string format = "text";
};

nlohmann::ordered_json json_of(const BodyPosition& body) {
  return {{"azimuth_deg", to_degrees(body.azimuth)},
          {"elevation_deg", to_degrees(body.elevation)},
          {"apparent_elevation_deg", to_degrees(body.apparent_elevation)},
          {"distance_m", body.distance.value},
          {"angular_radius_deg", to_degrees(body.angular_radius)}};
}

std::string json_text(const Instant& instant, const Options& options, const SunAndMoon& seen) {
  nlohmann::ordered_json json;
  json["time_utc"] = instant.to_string();
  json["ut1_utc_s"] = instant.ut1_utc().value;
  json["site"] = {{"latitude_deg", options.site.latitude_deg},
                  {"longitude_deg", options.site.longitude_deg},
                  {"height_m", options.site.height_m}};
  json["sun"] = json_of(seen.sun);
  json["moon"] = json_of(seen.moon);
  json["moon"]["phase_angle_deg"] = to_degrees(seen.phase.phase_angle);
  json["moon"]["illuminated_fraction"] = seen.phase.illuminated_fraction;
  return json.dump(2) + "\n";
}

std::string row(const char* name, double sun, double moon, int decimals, const char* unit) {
  return fmt::format("{:<22}{:>16.{}f}{:>16.{}f}  {}\n", name, sun, decimals, moon, decimals, unit);
}

std::string plain_text(const Instant& instant, const Options& options, const SunAndMoon& seen) {
  const BodyPosition &sun = seen.sun, &moon = seen.moon;
  const ephemeris::Site& site = options.site;
  std::string text = fmt::format("{:<22}{}\n", "time", instant.to_string());
  text += fmt::format("{:<22}latitude {:.6f} deg, longitude {:.6f} deg, height {:.1f} m\n\n",
                      "site", site.latitude_deg, site.longitude_deg, site.height_m);
  text += fmt::format("{:<22}{:>16}{:>16}\n", "", "sun", "moon");
  text += row("azimuth", to_degrees(sun.azimuth), to_degrees(moon.azimuth), 5, "deg");
  text += row("elevation", to_degrees(sun.elevation), to_degrees(moon.elevation), 5, "deg");
  text += row("apparent elevation", to_degrees(sun.apparent_elevation),
              to_degrees(moon.apparent_elevation), 5, "deg");
  text += row("distance", sun.distance.value / 1e3, moon.distance.value / 1e3, 1, "km");
  text += row("angular radius", to_degrees(sun.angular_radius), to_degrees(moon.angular_radius), 5,
              "deg");
  text += fmt::format("{:<22}{:>16}{:>16.4f}  deg\n", "phase angle", "",
                      to_degrees(seen.phase.phase_angle));
  text += fmt::format("{:<22}{:>16}{:>16.5f}\n", "illuminated fraction", "",
                      seen.phase.illuminated_fraction);
  return text;
}

void run(const Options& options) {
  if (options.format != "text" && options.format != "json") {
    throw InputError{fmt::format("--format is \"{}\", expected text or json", options.format)};
  }
  const Instant instant = Instant::parse_utc(options.time, Seconds{options.ut1_utc_s});
  const SunAndMoon seen = ephemeris::sun_and_moon(instant, options.site);
  if (const auto caution = instant.caution()) fmt::print(stderr, "warning: {}\n", *caution);
  const bool json = options.format == "json";
  fmt::print("{}", json ? json_text(instant, options, seen) : plain_text(instant, options, seen));
}

}  // namespace

void add_ephemeris_command(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("ephemeris", "Sun and moon in the sky of a site");
  command->add_option("--time", options->time, "UTC, ISO 8601, such as 2026-06-21T16:00:00Z")
      ->required();
  command->add_option("--latitude", options->site.latitude_deg, "Geodetic, north positive [deg]")
      ->required();
  command->add_option("--longitude", options->site.longitude_deg, "East positive [deg]")
      ->required();
  command->add_option("--height", options->site.height_m, "Above the WGS84 ellipsoid [m]");
  command->add_option("--ut1-utc", options->ut1_utc_s, "UT1 - UTC, from IERS bulletins [s]");
  command->add_option("--format", options->format, "text or json");
  command->callback([options] { run(*options); });
}

}  // namespace nadir::sim
