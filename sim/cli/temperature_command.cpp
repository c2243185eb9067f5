#include "sim/cli/temperature_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "sim/files/atomic_file.hpp"
#include "sim/products/heat_curve.hpp"

namespace nadir::sim {
namespace {

struct TemperatureOptions {
  std::filesystem::path scenario, plot, csv;
  std::vector<double> point, look;
};

void check_finite(const std::vector<double>& values, const char* option) {
  for (const double value : values) {
    if (!std::isfinite(value)) {
      throw InputError{fmt::format("{} holds {}, expected finite numbers", option, value)};
    }
  }
}

PlaceQuestion question_of(const TemperatureOptions& options) {
  check_finite(options.point, "--point");
  check_finite(options.look, "--look");
  if (options.point.size() < 2 || options.point.size() > 3) {
    throw InputError{fmt::format(
        "--point has {} numbers, expected east,north or east,north,up in m", options.point.size())};
  }
  PlaceQuestion question{options.point[0], options.point[1], {}, {0.0, 0.0, -1.0}};
  if (options.point.size() == 3) question.up_m = options.point[2];
  if (options.look.empty()) return question;
  if (options.look.size() != 2 || !question.up_m) {
    throw InputError{"--look takes azimuth,elevation in degrees and needs a --point with its up"};
  }
  const double azimuth = options.look[0] * radians_per_degree;
  const double elevation = options.look[1] * radians_per_degree;
  question.direction = {std::sin(azimuth) * std::cos(elevation),
                        std::cos(azimuth) * std::cos(elevation), std::sin(elevation)};
  return question;
}

void report_temperature(const TemperatureOptions& options) {
  const TemperatureAt at = temperature_at(options.scenario, question_of(options));
  for (const std::string& warning : at.warnings) fmt::print(stderr, "warning: {}\n", warning);
  fmt::print("{}", heat_text(at));
  if (!at.record && !(options.plot.empty() && options.csv.empty())) {
    throw InputError{
        fmt::format("material \"{}\" has a temperature without a history: there is "
                    "nothing to plot or write",
                    at.material)};
  }
  if (!options.plot.empty()) write_file(options.plot, to_svg(heat_plot(at)));
  if (!options.csv.empty()) write_file(options.csv, heat_csv(at));
}

}  // namespace

void add_temperature_command(CLI::App& app) {
  auto options = std::make_shared<TemperatureOptions>();
  CLI::App* command =
      app.add_subcommand("temperature", "How warm a place of a scene is, through the day and why");
  command->add_option("scenario", options->scenario, "Scenario file (XML)")->required();
  command
      ->add_option("--point", options->point,
                   "east,north[,up] [m]: the first surface below it, from above everything without "
                   "its up")
      ->delimiter(',')
      ->required();
  command
      ->add_option("--look", options->look,
                   "azimuth,elevation [deg]: the first surface in that direction instead of below")
      ->delimiter(',');
  command->add_option("--plot", options->plot, "Write the curves as a picture (SVG)");
  command->add_option("--csv", options->csv, "Write every step of the curves (CSV)");
  command->callback([options] { report_temperature(*options); });
}

}  // namespace nadir::sim
