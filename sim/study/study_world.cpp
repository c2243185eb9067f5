#include "sim/study/study_world.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <string_view>
#include <utility>

#include "sim/files/hash.hpp"
#include "sim/run/check_view.hpp"
#include "sim/run/heat_ahead.hpp"
#include "sim/run/stage_clock.hpp"
#include "sim/run/tiles.hpp"
#include "sim/scenario/read_scenario.hpp"
#include "sim/study/study_pixels.hpp"

namespace nadir::sim {
namespace {

// Of a hyperspectral camera some bands stand for all: what is kept of a pixel grows with them.
constexpr std::size_t most_bands = 16;
// A lane of air in layers with eight streams on one processor, where it came from the cache and
// its own time is not known. [s]
constexpr double lane_s = 0.25;

double now_s() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

/// From here on the process's peak of memory counts anew, where the system allows it.
void forget_memory_peak() { std::ofstream{"/proc/self/clear_refs"} << "5"; }

/// The peak since then; since the process began where the system does not tell. [bytes]
double memory_peak() {
  std::ifstream status{"/proc/self/status"};
  for (std::string line; std::getline(status, line);) {
    constexpr std::string_view key = "VmHWM:";
    if (line.starts_with(key)) return 1024.0 * std::stod(line.substr(key.size()));
  }
  return static_cast<double>(peak_memory_bytes());
}

std::string processor_name() {
  std::ifstream info{"/proc/cpuinfo"};
  for (std::string line; std::getline(info, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

std::vector<StudyBand> choose_study_bands(const Camera& camera, const AccuracyInput& accuracy) {
  std::vector<StudyBand> all;
  for (std::size_t a = 0; a < camera.arrays.size(); ++a) {
    const sensor::DetectorArray& array = camera.arrays[a];
    for (std::size_t b = 0; b < array.bands.size(); ++b) {
      all.push_back({array.name, array.bands[b].name, a, b,
                     spectral::centre(array.bands[b].response).value,
                     accuracy.floor_radiance.value_or(0.0)});
    }
  }
  if (all.size() <= most_bands) return all;
  std::vector<StudyBand> some;
  for (std::size_t i = 0; i < most_bands; ++i) {
    some.push_back(all[i * (all.size() - 1) / (most_bands - 1)]);
  }
  return some;
}

/// The replicates' mean and the variance between them.
Welford spread_of(const std::vector<double>& replicates) {
  Welford all;
  for (const double value : replicates) all.add(value);
  return all;
}

/// Of each array `few` of its places, evenly through their list (0: all).
std::vector<PixelPlace> some_places(const std::vector<PixelPlace>& places, int few) {
  if (few <= 0) return places;
  std::map<int, std::vector<PixelPlace>> by_array;
  for (const PixelPlace& place : places) by_array[place.array].push_back(place);
  std::vector<PixelPlace> some;
  for (const auto& [array, all] : by_array) {
    const std::size_t count = std::min(all.size(), static_cast<std::size_t>(few));
    for (std::size_t i = 0; i < count; ++i)
      some.push_back(all[(2 * i + 1) * all.size() / (2 * count)]);
  }
  return some;
}

}  // namespace

std::vector<StudyInput> digests_of(const std::vector<std::string>& paths) {
  std::vector<StudyInput> inputs;
  for (const std::string& path : paths) inputs.push_back({path, digest_file(path).sha256});
  return inputs;
}

StudyWorld::StudyWorld(const StudySource& source, Diagnostics& diagnostics)
    : scenario_{read_scenario(source.scenario, diagnostics)},
      diagnostics_{&diagnostics},
      seed_{source.seed},
      threads_{source.threads > 0 ? source.threads : available_threads()},
      world_{load_world(scenario_, inputs_, diagnostics, source.seed)},
      bands_{choose_study_bands(world_.camera, scenario_.accuracy)} {
  // Zero nodes leave their number to a planner that answers for one accuracy; a study varies it.
  BandNodes& nodes = scenario_.sampling.wavelengths_per_band;
  if (nodes.by_array.empty() && nodes.everywhere <= 0) nodes = BandNodes{};
  check_spectra(world_, scenario_.sampling, diagnostics);
  check_memory(world_.camera);
  check_view(world_, diagnostics);
  if (world_.heat) solve_heat_ahead(world_, source.seed);
  const double start_s = now_s();
  ReportValues report = finish_air(world_, scenario_.sampling, diagnostics);
  air_s_ = now_s() - start_s;
  for (const auto& [name, value] : report) {
    if (name != "from_cache" || !std::get<bool>(value)) continue;
    const auto* air = std::get_if<atmosphere::Tabulated>(&world_.scene.atmosphere);
    if (air != nullptr) {
      air_s_ += lane_s * static_cast<double>(air->table->lanes.size()) / threads_;
    }
  }
  if (world_.air) bending_ = camera_bending(world_, report);
  variants_.insert_or_assign(
      key_of(reference_settings(own_settings())),
      Variant{world_.scene.atmosphere, plan_camera(world_, scenario_.sampling)});
  for (const sensor::DetectorArray& array : world_.camera.arrays) {
    image_pixels_.push_back(ImageSize{array.samples, array.lines}.pixels());
  }
}

const LayeredTask* StudyWorld::layered() const {
  return world_.air && world_.air->layered ? &*world_.air->layered : nullptr;
}

StudySettings StudyWorld::own_settings() const {
  return {scenario_.method, scenario_.path_max_bounces, scenario_.solver,
          scenario_.sampling.wavelengths_per_band, 0};
}

StudyHeader StudyWorld::header() const {
  StudyHeader header;
  header.version = NADIR_VERSION;
  header.scenario = scenario_.file.string();
  header.title = scenario_.title.empty() ? scenario_.name : scenario_.title;
  header.time_utc = scenario_.time.to_string();
  std::vector<std::string> paths;
  for (const auto& file : inputs_.all()) paths.push_back(file.string());
  header.inputs = digests_of(paths);
  header.bands = bands_;
  header.image_pixels = image_pixels_;
  header.seed = seed_;
  header.replicates = scenario_.sampling.replicates;
  header.samples = scenario_.sampling.samples_per_replicate;
  header.threads = threads_;
  header.processor = processor_name();
  header.scope.scenario = own_settings();
  header.scope.lights =
      static_cast<int>(world_.scene.illumination.size()) + (world_.scene.lamps.empty() ? 0 : 1);
  if (const LayeredTask* air = layered()) {
    header.scope.layered_air = true;
    header.scope.streams =
        air->settings.mode == atmosphere::AirMode::fast ? 2 : air->settings.streams;
  }
  return header;
}

std::vector<ImageSize> StudyWorld::image_sizes() const {
  std::vector<ImageSize> sizes;
  for (const auto& array : world_.camera.arrays) sizes.push_back({array.samples, array.lines});
  return sizes;
}

void StudyWorld::choose_pixels(const StudyHeader& header) {
  places_.clear();
  const auto sizes = image_sizes();
  for (std::size_t a = 0; a < sizes.size(); ++a) {
    const int array = static_cast<int>(a);
    for (const StudyPixel& place :
         stratified_pixels(sizes[a], header.pixels_of_array.at(a), mix(header.seed, a))) {
      places_.push_back({array, place.sample, place.line});
    }
  }
}

double StudyWorld::preparation_s(const StudySettings& settings) const {
  StudySettings key = reference_settings(settings);
  if (layered() == nullptr || variants_.contains(key_of(key))) return 0.0;
  const auto nodes = [](const BandNodes& n) {
    double sum = n.by_array.empty() ? n.everywhere : 0.0;
    for (const auto& array : n.by_array) {
      for (const int count : array) sum += count;
    }
    return sum;
  };
  const double more = nodes(settings.wavelengths) / nodes(scenario_.sampling.wavelengths_per_band);
  // The doubling-adding of a lane grows with the cube of its streams.
  const double own =
      layered()->settings.mode == atmosphere::AirMode::fast ? 2.0 : layered()->settings.streams;
  const double streams = settings.air_streams > 0 ? settings.air_streams / own : 1.0;
  return air_s_ * more * std::max(0.1, streams * streams * streams);
}

StudyWorld::Variant StudyWorld::make_variant(const StudySettings& settings) {
  SamplingInput sampling = scenario_.sampling;
  sampling.wavelengths_per_band = settings.wavelengths;
  const auto air = world_.scene.atmosphere;
  std::optional<atmosphere::AirSettings> before;
  if (layered() != nullptr && settings.air_streams > 0) {
    before = world_.air->layered->settings;
    world_.air->layered->settings.mode =
        settings.air_streams == 2 ? atmosphere::AirMode::fast : atmosphere::AirMode::accurate;
    if (settings.air_streams > 2) world_.air->layered->settings.streams = settings.air_streams;
  }
  const auto restore = [&] {
    world_.scene.atmosphere = air;
    if (before) world_.air->layered->settings = *before;
  };
  try {
    finish_air(world_, sampling, *diagnostics_);
    Variant made{world_.scene.atmosphere, plan_camera(world_, sampling)};
    restore();
    return made;
  } catch (...) {
    restore();
    throw;
  }
}

const StudyWorld::Variant& StudyWorld::variant(const StudySettings& settings) {
  const std::string key = key_of(reference_settings(settings));  // the solver does not matter
  const auto known = variants_.find(key);
  if (known != variants_.end()) return known->second;
  return variants_.emplace(key, make_variant(settings)).first->second;
}

ProbeResult StudyWorld::probe(const StudySettings& settings, const SamplingRequest& request,
                              const std::vector<PixelPlace>& places) {
  const Variant& with = variant(settings);
  world_.scene.atmosphere = with.air;
  world_.scene.method = settings.method;
  world_.scene.path_max_bounces = settings.path_max_bounces;
  world_.scene.solver = settings.generic;
  RenderOptions options;
  options.sampling = {request.replicates, request.samples, settings.wavelengths};
  options.seed = request.seed;
  options.threads = threads_;
  options.truth = false;
  options.plan = &with.plan;
  options.bending = bending_ ? &*bending_ : nullptr;
  options.asks_for_heat = &world_.asks_for_heat;
  return probe_pixels(world_, options, places, *diagnostics_);
}

StudySample StudyWorld::sample(const StudySettings& settings, const SamplingRequest& request) {
  forget_memory_peak();
  const double start_s = now_s();
  const auto places = some_places(places_, request.pixels);
  const ProbeResult found = probe(settings, request, places);
  StudySample sample;
  sample.request = request;
  sample.mean.resize(bands_.size());
  sample.variance.resize(bands_.size());
  double pixels_cpu_s = 0.0;
  std::vector<Welford> array_cpu_s(image_pixels_.size());
  const double paths = static_cast<double>(request.replicates) * request.samples;
  for (const ProbedPixel& pixel : found.pixels) {
    pixels_cpu_s += pixel.cpu_s;
    const auto array = static_cast<std::size_t>(pixel.place.array);
    array_cpu_s[array].add(pixel.cpu_s / paths);
    for (std::size_t b = 0; b < bands_.size(); ++b) {
      if (bands_[b].array_number != array) continue;
      const Welford spread = spread_of(pixel.replicates[bands_[b].band_number]);
      sample.mean[b].push_back(spread.mean());
      sample.variance[b].push_back(spread.variance());
    }
  }
  SampleCost& cost = sample.cost;
  const double all_paths = std::max(1.0, paths * static_cast<double>(found.pixels.size()));
  cost.path_cpu_s = pixels_cpu_s / all_paths;
  cost.setup_s = std::max(0.0, found.cpu_s - pixels_cpu_s);
  cost.path_wall_s = std::max(pixels_cpu_s / threads_, found.wall_s - cost.setup_s) / all_paths;
  for (std::size_t a = 0; a < array_cpu_s.size(); ++a) {
    cost.picture_cpu_s += array_cpu_s[a].mean() * static_cast<double>(image_pixels_[a]);
  }
  cost.rays_per_path = static_cast<double>(found.counters.rays()) / all_paths;
  cost.peak_memory_bytes = memory_peak();
  cost.wall_s = now_s() - start_s;
  return sample;
}

}  // namespace nadir::sim
