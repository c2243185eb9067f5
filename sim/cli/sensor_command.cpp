#include "sim/cli/sensor_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/diagnostics.hpp"
#include "core/error.hpp"
#include "sim/files/atomic_file.hpp"
#include "sim/products/sensor_sheet.hpp"
#include "sim/run/load_camera.hpp"
#include "sim/run/world.hpp"
#include "sim/scenario/read_scenario.hpp"
#include "sim/scenario/sensor_file.hpp"

namespace nadir::sim {
namespace {

struct SensorOptions {
  std::filesystem::path file, plot;
  std::optional<double> height_m, speed_m_s;
  std::string format = "text", band;
};

constexpr double largest_height_m = 1e10;  // six times as far as the sun's L1
constexpr double largest_speed_m_s = 1e6;

/// A finite number above 0 and up to a largest one. (CLI11's own checks let "nan" pass.)
CLI::Validator up_to(double largest, const std::string& unit) {
  const std::string range = fmt::format("above 0 and at most {:g} {}", largest, unit);
  const auto complaint = [largest, range](const std::string& text) -> std::string {
    double value = 0.0;
    const bool is_number = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
    if (is_number && value > 0.0 && value <= largest) return "";
    return fmt::format("expected a number {}, found {}", range, text);
  };
  return CLI::Validator{complaint, range};
}

/// Finds out before the work whether there is a folder for the picture.
void check_plot(const std::filesystem::path& plot) {
  if (plot.empty()) return;
  const std::filesystem::path folder = plot.has_parent_path() ? plot.parent_path() : ".";
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    throw InputError{"--plot " + plot.string() + ": there is no folder " + folder.string()};
  }
  if (std::filesystem::is_directory(plot, error)) {
    throw InputError{"--plot " + plot.string() + ": this is a folder, not a file"};
  }
}

void write_plot(const std::filesystem::path& plot, const std::string& picture) {
  try {
    write_file(plot, picture);
  } catch (const std::runtime_error& error) {
    throw InputError{"--plot: " + std::string{error.what()}};
  }
}

SensorSheet preset_sheet(const SensorOptions& options, Diagnostics& diagnostics) {
  InputFiles files;
  const SensorSheetInput input = load_sensor_file(options.file, files, diagnostics);
  SheetGround ground;
  ground.height_m = options.height_m.value_or(input.height_m);
  ground.ground_speed_m_s = options.speed_m_s.value_or(input.ground_speed_m_s);
  SensorSheet sheet = sensor_sheet(input.camera, ground);
  sheet.title = input.title;
  sheet.source = input.source;
  return sheet;
}

SensorSheet scenario_sheet(const SensorOptions& options, Diagnostics& diagnostics) {
  InputFiles files;
  const Scenario scenario = read_scenario(options.file, diagnostics);
  const World world = load_world(scenario, files, diagnostics);
  SheetGround ground;
  ground.frame = world.frame;
  const Vec3 camera = world.camera.platform.steady(world.camera.platform.first_s()).position;
  const double over_origin_m =
      world.frame.geodetic(camera).height_m - world.frame.origin().height_m;
  ground.height_m = options.height_m.value_or(over_origin_m);
  ground.ground_speed_m_s = options.speed_m_s.value_or(0.0);
  return sensor_sheet(world.camera, ground);
}

void report_sensor(const SensorOptions& options) {
  check_plot(options.plot);
  Diagnostics diagnostics;
  const SensorSheet sheet = is_sensor_file(options.file) ? preset_sheet(options, diagnostics)
                                                         : scenario_sheet(options, diagnostics);
  for (const std::string& warning : diagnostics.messages()) {
    fmt::print(stderr, "warning: {}\n", warning);
  }
  if (!options.plot.empty()) write_plot(options.plot, to_svg(mtf_plot(sheet, options.band)));
  fmt::print("{}", options.format == "json" ? sheet_json(sheet) : sheet_text(sheet));
}

}  // namespace

void add_sensor_command(CLI::App& app) {
  auto options = std::make_shared<SensorOptions>();
  CLI::App* command = app.add_subcommand(
      "sensor", "A sensor's data sheet: ground sampling, swath, noise, saturation, MTF");
  command->add_option("FILE", options->file, "Sensor file or scenario (XML)")->required();
  command
      ->add_option("--height", options->height_m,
                   "Height of the camera over the ground [m; the sensor's nominal one, or over the "
                   "scene's origin]")
      ->check(up_to(largest_height_m, "m"));
  command
      ->add_option("--speed", options->speed_m_s,
                   "Speed of the ground under a camera that stands still [m/s; the sensor's "
                   "nominal one, else lines of a pushbroom fit it]")
      ->check(up_to(largest_speed_m_s, "m/s"));
  command->add_option("--format", options->format, "text or json [text]")
      ->check(CLI::IsMember({"text", "json"}));
  command->add_option("--plot", options->plot, "Write the curves of the MTF as a picture (SVG)");
  command->add_option("--band", options->band, "Band whose terms the plot shows [the first]");
  command->callback([options] { report_sensor(*options); });
}

}  // namespace nadir::sim
