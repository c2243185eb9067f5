#include "sim/run/imaging.hpp"

#include <fstream>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "sim/files/modules.hpp"

namespace nadir::sim {
namespace {

ProductContext context_of(const Scenario& scenario, const ProductGeometry& geometry,
                          const DetectorStage& detectors, Diagnostics& diagnostics) {
  ProductContext context;
  context.scenario_name = scenario.name;
  context.title = scenario.title;
  context.time_utc = scenario.time.to_string();
  context.version = NADIR_VERSION;
  context.wanted = scenario.products;
  context.diagnostics = &diagnostics;
  context.geometry = &geometry;
  context.calibrations = detectors.calibrations();
  return context;
}

/// How the products place themselves on the earth.
ProductGeometry geometry_of(const Scenario& scenario, const World& world) {
  const geometry::Scene& scene = world.scene.geometry;
  const geometry::Bounds box = scene.bounds();
  const double middle_up_m = 0.5 * (box.lo.z + box.hi.z);
  const auto surface = [&scene](const geometry::Ray& ray) -> std::optional<Vec3> {
    const auto hit = scene.intersect(ray);
    return hit ? std::optional{hit->position} : std::nullopt;
  };
  return {&world.camera, world.frame,
          scenario.time, world.scene.illumination,
          surface,       world.frame.geodetic({0.0, 0.0, middle_up_m}).height_m};
}

/// What a file that was read is to the run.
std::string role_of(const std::filesystem::path& file, const Scenario& scenario) {
  const std::string ending = file.extension().string();
  if (file == scenario.file) return "scenario";
  if (ending == ".xml") return "material library";
  if (ending == ".csv" || ending == ".txt") return "table";
  if (ending == ".air") return "table of the air";
  for (const GeometryInput& input : scenario.geometry) {
    const auto* terrain = std::get_if<TerrainInput>(&input);
    if (terrain != nullptr && terrain->raster == file) return "terrain";
  }
  return "mesh";
}

}  // namespace

Imaging::Imaging(const Scenario& scenario, const World& world, const ImagingOptions& options,
                 Diagnostics& diagnostics)
    : geometry_{geometry_of(scenario, world)},
      detectors_{world.camera, scenario.products, options.noise_seed},
      writer_{context_of(scenario, geometry_, detectors_, diagnostics), options.output} {}

void Imaging::take(const StripSource& source) {
  source([&](std::size_t array, ArrayImage&& strip) {
    detectors_.apply(array, strip);
    writer_.take(strip);
  });
}

ProductWriter::Written Imaging::finish() { return writer_.finish(); }

void prepare_output(const std::filesystem::path& folder, const ProductsInput& wanted) {
  if (wanted.quick_look) static_cast<void>(module_symbol("nadir_images", "nadir_image_module"));
  if (wanted.geotiff || wanted.netcdf) {
    static_cast<void>(module_symbol("nadir_rasters", "nadir_raster_module"));
  }
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const std::filesystem::path probe = folder / ".nadir-probe";
  const bool writable = !error && std::ofstream{probe}.good();
  std::filesystem::remove(probe, error);
  if (!writable) {
    throw InputError{InputIssue{{folder.string(), 0, 0},
                                "this folder cannot be made or written to",
                                "name another with --output",
                                {}}};
  }
}

std::vector<FileRecord> record_inputs(const InputFiles& inputs, const Scenario& scenario) {
  std::vector<FileRecord> records;
  for (const auto& file : inputs.all()) {
    records.push_back(record_file(role_of(file, scenario), file));
  }
  return records;
}

}  // namespace nadir::sim
