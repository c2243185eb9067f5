#include "sim/study/record_json.hpp"

namespace nadir::sim {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const materials::SolverSettings& s) {
  return {{"initial_sample_count", s.initial_sample_count},
          {"sample_decay_rate", s.sample_decay_rate},
          {"max_bounces", s.max_bounces},
          {"mu_samples", s.mu_samples},
          {"phi_samples", s.phi_samples},
          {"min_quad_samples", s.min_quad_samples}};
}

materials::SolverSettings solver_from(const Json& j) {
  return {j.at("initial_sample_count"), j.at("sample_decay_rate"), j.at("max_bounces"),
          j.at("mu_samples"),           j.at("phi_samples"),       j.at("min_quad_samples")};
}

StudySettings settings_from(const Json& j) {
  StudySettings settings;
  const bool path = j.at("method") == "path";
  settings.method = path ? radiometry::Method::path : radiometry::Method::generic;
  settings.path_max_bounces = j.at("path_max_bounces");
  settings.generic = solver_from(j.at("generic"));
  settings.wavelengths.everywhere = j.at("wavelengths_per_band");
  settings.wavelengths.by_array = j.at("wavelengths_by_band").get<std::vector<std::vector<int>>>();
  settings.air_streams = j.at("air_streams");
  return settings;
}

Json json_of(const StudyBand& band) {
  return {{"array", band.array},
          {"name", band.name},
          {"array_number", band.array_number},
          {"band_number", band.band_number},
          {"centre_um", band.centre_um},
          {"floor_radiance", band.floor_radiance}};
}

StudyBand band_from(const Json& j) {
  return {j.at("array"),       j.at("name"),      j.at("array_number"),
          j.at("band_number"), j.at("centre_um"), j.at("floor_radiance")};
}

}  // namespace

Json json_of(const StudySettings& settings) {
  const bool path = settings.method == radiometry::Method::path;
  return {{"method", path ? "path" : "generic"},
          {"path_max_bounces", settings.path_max_bounces},
          {"generic", json_of(settings.generic)},
          {"wavelengths_per_band", settings.wavelengths.everywhere},
          {"wavelengths_by_band", settings.wavelengths.by_array},
          {"air_streams", settings.air_streams}};
}

Json json_of(const StudyHeader& header) {
  Json inputs = Json::array(), bands = Json::array();
  for (const StudyInput& input : header.inputs) {
    inputs.push_back({{"path", input.path}, {"sha256", input.sha256}});
  }
  for (const StudyBand& band : header.bands) bands.push_back(json_of(band));
  return {{"version", header.version},
          {"scenario", header.scenario},
          {"title", header.title},
          {"time_utc", header.time_utc},
          {"inputs", std::move(inputs)},
          {"bands", std::move(bands)},
          {"pixels_of_array", header.pixels_of_array},
          {"pixels_asked", header.pixels_asked},
          {"image_pixels", header.image_pixels},
          {"seed", header.seed},
          {"replicates", header.replicates},
          {"samples", header.samples},
          {"threads", header.threads},
          {"processor", header.processor},
          {"scope",
           {{"scenario", json_of(header.scope.scenario)},
            {"lights", header.scope.lights},
            {"layered_air", header.scope.layered_air},
            {"streams", header.scope.streams}}},
          {"reference_samples", header.reference_samples}};
}

StudyHeader header_from(const Json& j) {
  StudyHeader header;
  header.version = j.at("version");
  header.scenario = j.at("scenario");
  header.title = j.at("title");
  header.time_utc = j.at("time_utc");
  for (const Json& input : j.at("inputs")) {
    header.inputs.push_back({input.at("path"), input.at("sha256")});
  }
  for (const Json& band : j.at("bands")) header.bands.push_back(band_from(band));
  header.pixels_of_array = j.at("pixels_of_array").get<std::vector<int>>();
  header.pixels_asked = j.at("pixels_asked");
  header.image_pixels = j.at("image_pixels").get<std::vector<std::uint64_t>>();
  header.seed = j.at("seed");
  header.replicates = j.at("replicates");
  header.samples = j.at("samples");
  header.threads = j.at("threads");
  header.processor = j.at("processor");
  const Json& scope = j.at("scope");
  header.scope = {settings_from(scope.at("scenario")), scope.at("lights"), scope.at("layered_air"),
                  scope.at("streams")};
  header.reference_samples = j.at("reference_samples");
  return header;
}

Json json_of(const StudySample& sample) {
  const SampleCost& cost = sample.cost;
  return {{"replicates", sample.request.replicates},
          {"samples", sample.request.samples},
          {"seed", sample.request.seed},
          {"pixels", sample.request.pixels},
          {"path_cpu_s", cost.path_cpu_s},
          {"path_wall_s", cost.path_wall_s},
          {"picture_cpu_s", cost.picture_cpu_s},
          {"setup_s", cost.setup_s},
          {"wall_s", cost.wall_s},
          {"rays_per_path", cost.rays_per_path},
          {"peak_memory_bytes", cost.peak_memory_bytes},
          {"mean", sample.mean},
          {"variance", sample.variance}};
}

StudySample sample_from(const Json& j) {
  StudySample sample;
  sample.request = {j.at("replicates"), j.at("samples"), j.at("seed"), j.at("pixels")};
  sample.cost = {j.at("path_cpu_s"),       j.at("path_wall_s"), j.at("picture_cpu_s"),
                 j.at("setup_s"),          j.at("wall_s"),      j.at("rays_per_path"),
                 j.at("peak_memory_bytes")};
  sample.mean = j.at("mean").get<std::vector<std::vector<double>>>();
  sample.variance = j.at("variance").get<std::vector<std::vector<double>>>();
  return sample;
}

Json json_of(const StudyPicture& picture) {
  return {{"label", picture.label},         {"settings", picture.settings},
          {"width", picture.width},         {"height", picture.height},
          {"step", picture.step},           {"paths", picture.paths},
          {"error", picture.error},         {"wall_s", picture.wall_s},
          {"picture_s", picture.picture_s}, {"png_base64", picture.png_base64}};
}

StudyPicture picture_from(const Json& j) {
  return {j.at("label"), j.at("settings"), j.at("width"),  j.at("height"),    j.at("step"),
          j.at("paths"), j.at("error"),    j.at("wall_s"), j.at("picture_s"), j.at("png_base64")};
}

}  // namespace nadir::sim
