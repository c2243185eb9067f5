#include "sim/cli/project_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "sim/run/project.hpp"

namespace nadir::sim {
namespace {

struct ProjectOptions {
  std::filesystem::path scenario, file;
  std::string array, band, format = "text";
  std::vector<double> ground, local, image;
  std::optional<double> height_m;
};

void check_numbers(const std::vector<double>& values, std::size_t count, const char* what) {
  const bool finite =
      std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  if (values.size() == count && finite) return;
  throw InputError{fmt::format("{} expected, {} numbers found", what, values.size())};
}

std::vector<ProjectionPoint> points_of_file(const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary};
  if (!stream) throw InputError{InputIssue{{file.string(), 0, 0}, "cannot be read", {}, {}}};
  const std::string text{std::istreambuf_iterator<char>{stream}, {}};
  return read_projection_points(text, file.string());
}

std::vector<ProjectionPoint> points_of(const ProjectOptions& options) {
  const int given = int{!options.ground.empty()} + int{!options.local.empty()} +
                    int{!options.image.empty()} + int{!options.file.empty()};
  if (given != 1) throw InputError{"one of --ground, --local, --image and --file is wanted"};
  if (options.height_m && options.image.empty()) {
    throw InputError{"--height goes with --image"};
  }
  if (!options.file.empty()) return points_of_file(options.file);
  if (!options.ground.empty()) {
    check_numbers(options.ground, 3, "--ground latitude,longitude,height");
    return {geometry::Geodetic{options.ground[0], options.ground[1], options.ground[2]}};
  }
  if (!options.local.empty()) {
    check_numbers(options.local, 3, "--local east,north,up");
    return {LocalPlace{{options.local[0], options.local[1], options.local[2]}}};
  }
  check_numbers(options.image, 2, "--image sample,line");
  return {ImagePlace{{options.image[0], options.image[1]}, options.height_m}};
}

void report_projections(const ProjectOptions& options) {
  static const std::map<std::string, ProjectionFormat> formats{{"text", ProjectionFormat::text},
                                                               {"json", ProjectionFormat::json},
                                                               {"csv", ProjectionFormat::csv}};
  const std::vector<ProjectionPoint> points = points_of(options);
  Diagnostics diagnostics;
  const CameraScene scene = load_camera_scene(options.scenario, diagnostics);
  const sensor::DetectorArray& array = find_array(scene.camera, options.array, options.band);
  std::vector<Projection> found;
  for (const ProjectionPoint& point : points) found.push_back(project(scene, array, point));
  for (const std::string& warning : diagnostics.messages()) {
    fmt::print(stderr, "warning: {}\n", warning);
  }
  fmt::print("{}", to_text(found, formats.at(options.format), scene.scenario.time));
}

}  // namespace

void add_project_command(CLI::App& app) {
  auto options = std::make_shared<ProjectOptions>();
  CLI::App* command = app.add_subcommand(
      "project", "Where places appear in a scenario's image, and what the image shows where");
  command->add_option("scenario", options->scenario, "Scenario file (XML)")->required();
  command->add_option("--array", options->array, "Detector array; the only one if left out");
  command->add_option("--band", options->band, "Band; stands for the array that has it");
  command->add_option("--ground", options->ground, "latitude,longitude,height [deg, deg, m; WGS84]")
      ->delimiter(',');
  command->add_option("--local", options->local, "east,north,up in scene axes [m]")->delimiter(',');
  command
      ->add_option("--image", options->image,
                   "sample,line [pixels; 0.5,0.5 is the centre of the first]")
      ->delimiter(',');
  command->add_option("--height", options->height_m,
                      "Height above the ellipsoid where the line of sight ends, instead of the "
                      "first surface [m]");
  command->add_option("--file", options->file, "Points from a CSV file");
  command->add_option("--format", options->format, "text, json or csv")
      ->check(CLI::IsMember({"text", "json", "csv"}));
  command->callback([options] { report_projections(*options); });
}

}  // namespace nadir::sim
