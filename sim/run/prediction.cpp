#include "sim/run/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "sim/products/preview.hpp"
#include "sim/run/tiles.hpp"

namespace nadir::sim {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
// Tiles of which threads take the next one keep them busy to the last few.
constexpr double threads_efficiency = 0.95;

/// A pixel of the pilot and the pixels of the picture for which it stands.
struct PilotPixel {
  double weight = 0.0;  ///< pixels of the picture
  std::size_t array = 0;
  double seconds_per_path = 0.0;
  std::vector<double> noise;  ///< by band: deviation of one path, relative to max(radiance, floor)
  double paths = 0.0;         ///< that it is expected to get
  double truth_ray_s = 0.0;   ///< of the truth planes' rays of a path
  double most_truth = HUGE_VAL;  ///< paths that have those

  [[nodiscard]] double seconds() const {
    return weight * (paths * seconds_per_path + std::min(paths, most_truth) * truth_ray_s);
  }
};

/// Rays for the truth planes, which the pilot does not fill: one a path for shadows, one for the
/// share of the sky, each at the mean price of a ray.
double truth_ray_seconds(const PreparedRun& run, const Pilot& pilot) {
  const ProductsInput& wanted = run.scenario.products;
  const double rays = static_cast<double>(pilot.counters.rays());
  if (!wanted.truth || !(rays > 0.0)) return 0.0;
  return (wanted.sky_view ? 2.0 : 1.0) * pilot.cpu_s / rays;
}

std::vector<PilotPixel> pilot_pixels(const PreparedRun& run, const Pilot& pilot) {
  const World& world = run.world;
  const auto& arrays = world.camera.arrays;
  std::vector<double> seen(arrays.size(), 0.0);
  for (const ProbedPixel& pixel : pilot.pixels) seen[static_cast<std::size_t>(pixel.place.array)]++;
  std::vector<PilotPixel> pixels;
  for (const ProbedPixel& probed : pilot.pixels) {
    PilotPixel pixel;
    pixel.truth_ray_s = truth_ray_seconds(run, pilot);
    if (run.goal) pixel.most_truth = run.goal->replicates * run.goal->first_samples;
    pixel.array = static_cast<std::size_t>(probed.place.array);
    pixel.weight = static_cast<double>(arrays[pixel.array].samples) *
                   static_cast<double>(arrays[pixel.array].lines) / seen[pixel.array];
    pixel.seconds_per_path = probed.cpu_s / std::max(1U, probed.paths);
    for (std::size_t b = 0; b < probed.bands.size(); ++b) {
      const Estimate& estimate = probed.bands[b];
      const double unit = std::max(estimate.mean, world.effects.floor_radiance[pixel.array][b]);
      const double of_one = estimate.standard_error * std::sqrt(static_cast<double>(probed.paths));
      pixel.noise.push_back(unit > 0.0 ? of_one / unit : 0.0);
    }
    pixels.push_back(std::move(pixel));
  }
  return pixels;
}

/// Paths of a pixel that is sampled in doubling rounds until the greatest of its bands' errors is
/// `relative`: N = (noise / relative)^2, at the next end of a round.
double paths_needed(const PilotPixel& pixel, const SamplingGoal& goal, double relative) {
  double worst = 0.0;
  for (const double noise : pixel.noise) worst = std::max(worst, noise / relative);
  const double least = static_cast<double>(goal.replicates) * goal.first_samples;
  const double most = static_cast<double>(goal.replicates) * goal.most_samples;
  const double rounds = std::ceil(std::log2(std::max(1.0, worst * worst / least)));
  return std::min(most, least * std::exp2(rounds));
}

/// Processor time of all paths.
double path_seconds(const std::vector<PilotPixel>& pixels) {
  double seconds = 0.0;
  for (const PilotPixel& pixel : pixels) seconds += pixel.seconds();
  return seconds;
}

/// Paths as time allows: where every pixel has the error that the others have, in units of its
/// goal, as rounds that go where the error is largest come to.
void share_time(std::vector<PilotPixel>& pixels, const SamplingGoal& goal, double relative,
                double cpu_s) {
  const double least = static_cast<double>(goal.replicates) * std::max(1, goal.first_samples / 2);
  const auto spread = [&](double scale) {
    for (PilotPixel& pixel : pixels) {
      double worst = 0.0;
      for (const double noise : pixel.noise) worst = std::max(worst, noise / (scale * relative));
      pixel.paths = std::max(least, worst * worst);
    }
    return path_seconds(pixels);
  };
  double lo = 1e-6, hi = 1e6;  // of the goal's error; time falls with it
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(lo * hi);
    (spread(middle) > cpu_s ? lo : hi) = middle;
  }
  spread(hi);
}

double weighted_quantile(std::vector<std::pair<double, double>> values, double share) {
  if (values.empty()) return no_number;
  std::sort(values.begin(), values.end());
  double all = 0.0, below = 0.0;
  for (const auto& [value, weight] : values) all += weight;
  for (const auto& [value, weight] : values) {
    below += weight;
    if (below >= share * all) return value;
  }
  return values.back().first;
}

BandForecast forecast(const std::vector<PilotPixel>& pixels, std::size_t array, std::size_t band,
                      double relative) {
  std::vector<std::pair<double, double>> errors;
  double met = 0.0, all = 0.0;
  for (const PilotPixel& pixel : pixels) {
    if (pixel.array != array || !(pixel.paths > 0.0)) continue;
    const double error = pixel.noise[band] / std::sqrt(pixel.paths);
    errors.emplace_back(error, pixel.weight);
    all += pixel.weight;
    // At the end of a round the error is the goal's to rounding.
    if (error <= relative * (1.0 + 1e-9)) met += pixel.weight;
  }
  if (errors.empty()) return {};
  return {weighted_quantile(errors, 0.5), weighted_quantile(errors, 0.95), met / all};
}

int threads_of(const PredictionBasis& basis) {
  return basis.threads > 0 ? std::min(basis.threads, available_threads()) : available_threads();
}

/// What a pixel takes until it is written, by band and in all: measured, with the disk's cache, on
/// 1024 x 1024 pixels of 4 and of 16 bands (docs/plan-and-audit.md).
constexpr double envi_s = 90e-9, exr_s = 60e-9, geotiff_s = 170e-9, netcdf_s = 250e-9;
constexpr double truth_s = 0.1e-6, truth_exr_s = 0.5e-6, quick_look_s = 0.25e-6;
/// Likewise what is held of a whole image while its last products are made, in bytes.
constexpr double quick_look_bytes = 140.0;                   // a pixel of the preview
constexpr double geotiff_bytes = 16.0, netcdf_bytes = 26.0;  // a pixel and band

double product_seconds(const PreparedRun& run) {
  const ProductsInput& wanted = run.scenario.products;
  double seconds = 0.0;
  for (const sensor::DetectorArray& array : run.world.camera.arrays) {
    const double pixels = static_cast<double>(array.samples) * static_cast<double>(array.lines);
    const double planes = pixels * static_cast<double>(array.bands.size());
    seconds += planes * ((wanted.envi ? envi_s : 0.0) + (wanted.exr ? exr_s : 0.0) +
                         (wanted.geotiff ? geotiff_s : 0.0) + (wanted.netcdf ? netcdf_s : 0.0));
    if (wanted.truth) seconds += pixels * (truth_s + (wanted.exr ? truth_exr_s : 0.0));
    if (wanted.quick_look) seconds += pixels * quick_look_s;
  }
  return seconds;
}

/// Planes of two strips of the array, one that is rendered and one that is written, and what its
/// last products hold.
double array_bytes(const sensor::DetectorArray& array, const ProductsInput& wanted) {
  constexpr double strip_pixels = 1 << 17;
  constexpr double band_bytes = 5.0 * sizeof(float), truth_bytes = 16.0 * sizeof(float) + 32.0;
  const double bands = static_cast<double>(array.bands.size());
  const double all = static_cast<double>(array.samples) * static_cast<double>(array.lines);
  const double strip = std::min(all, std::max(strip_pixels, 16.0 * array.samples));
  const double preview = std::min(all, static_cast<double>(most_preview_pixels));
  return 2.0 * strip * (band_bytes * bands + (wanted.truth ? truth_bytes : 0.0)) +
         (wanted.quick_look ? quick_look_bytes * preview : 0.0) +
         all * bands *
             std::max(wanted.geotiff ? geotiff_bytes : 0.0, wanted.netcdf ? netcdf_bytes : 0.0);
}

/// Of the largest array: one is made after the other.
double image_bytes(const PreparedRun& run) {
  double most = 0.0;
  for (const sensor::DetectorArray& array : run.world.camera.arrays) {
    most = std::max(most, array_bytes(array, run.scenario.products));
  }
  return most;
}

void add_stages(const PredictionBasis& basis, Prediction& prediction) {
  for (const StageTime& stage : basis.stages) {
    (stage.name == "heat"  ? prediction.heat_s
     : stage.name == "air" ? prediction.air_s
                           : prediction.load_s) += stage.wall_s;
  }
}

void set_paths(const PredictionBasis& basis, double fixed_s, std::vector<PilotPixel>& pixels) {
  const PreparedRun& run = basis.run;
  const double relative = run.world.effects.relative;
  const double stated = static_cast<double>(run.sampling.replicates) *
                        static_cast<double>(run.sampling.samples_per_replicate);
  if (basis.time_s && run.goal) {
    const double left_s = std::max(0.0, *basis.time_s - fixed_s);
    share_time(pixels, *run.goal, relative, left_s * threads_of(basis) * threads_efficiency);
    return;
  }
  for (PilotPixel& pixel : pixels) {
    pixel.paths = run.goal ? paths_needed(pixel, *run.goal, relative) : stated;
  }
}

}  // namespace

Prediction predict(const PredictionBasis& basis, const Pilot& pilot) {
  const PreparedRun& run = basis.run;
  Prediction prediction;
  add_stages(basis, prediction);
  prediction.products_s = product_seconds(run);
  std::vector<PilotPixel> pixels = pilot_pixels(run, pilot);
  const double fixed_s =
      prediction.load_s + prediction.heat_s + prediction.air_s + prediction.products_s;
  set_paths(basis, fixed_s, pixels);
  double paths = 0.0, all = 0.0;
  for (const PilotPixel& pixel : pixels) {
    paths += pixel.weight * pixel.paths;
    all += pixel.weight;
  }
  prediction.render_cpu_s = path_seconds(pixels);
  prediction.render_s = prediction.render_cpu_s / (threads_of(basis) * threads_efficiency);
  prediction.seconds = fixed_s + prediction.render_s;
  prediction.memory_bytes = static_cast<double>(peak_memory_bytes()) + image_bytes(run);
  prediction.mean_paths = all > 0.0 ? paths / all : no_number;
  prediction.seconds_per_path = pilot.paths > 0.0 ? pilot.cpu_s / pilot.paths : no_number;
  prediction.pilot_pixels = pilot.pixels.size();
  prediction.pilot_paths = static_cast<std::uint64_t>(pilot.paths);
  prediction.pilot_s = pilot.wall_s;
  double reachable = 0.0;
  for (std::size_t i = 0; i < run.world.camera.arrays.size(); ++i) {
    auto& bands = prediction.bands.emplace_back();
    for (std::size_t b = 0; b < run.world.camera.arrays[i].bands.size(); ++b) {
      bands.push_back(forecast(pixels, i, b, run.world.effects.relative));
      if (std::isfinite(bands.back().p95_error)) {
        reachable = std::max(reachable, bands.back().p95_error);
      }
    }
  }
  prediction.reachable = pixels.empty() ? no_number : reachable;
  return prediction;
}

CameraNames camera_names(const Camera& camera) {
  CameraNames names;
  for (const sensor::DetectorArray& array : camera.arrays) {
    names.push_back({array.name, {}});
    for (const sensor::Band& band : array.bands) names.back().bands.push_back(band.name);
  }
  return names;
}

}  // namespace nadir::sim
