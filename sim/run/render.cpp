#include "sim/run/render.hpp"

#include <mutex>
#include <utility>

#include "sim/run/pixel.hpp"
#include "sim/run/tiles.hpp"

namespace nadir::sim {
namespace {

// Small enough to keep all processors busy to the end, large enough that a tile outweighs its
// solvers' construction a thousand times.
constexpr int tile_edge = 16;
// Bands centred beyond this see more emission than sun in an ordinary scene, so that a brightness
// temperature says something.
constexpr double emissive_beyond_um = 3.0;

ArrayJob prepare(const radiometry::SceneDescription& scene, const sensor::Pose& pose,
                 const sensor::DetectorArray& array, ArrayPlan plan, Diagnostics& diagnostics) {
  ArrayJob job{&scene, &pose, &array, std::move(plan), {}};
  for (const spectral::Lanes& lanes : job.plan.lanes.blocks) {
    job.blocks.emplace_back(scene, lanes, diagnostics);
  }
  return job;
}

ArrayImage blank_image(const sensor::DetectorArray& array,
                       const radiometry::SceneDescription& scene, bool truth) {
  ArrayImage image;
  image.name = array.name;
  image.samples = array.samples;
  image.lines = array.lines;
  const std::size_t pixels = image.pixels();
  for (const sensor::Band& band : array.bands) {
    const double centre_um = spectral::centre(band.response).value;
    image.bands.push_back({band.name, centre_um, spectral::fwhm(band.response).value,
                           std::vector<float>(pixels), std::vector<float>(pixels),
                           std::vector<float>(centre_um > emissive_beyond_um ? pixels : 0)});
  }
  if (!truth) return image;
  for (const materials::Material& material : scene.materials) {
    image.truth.material_names.push_back(material.name);
  }
  image.truth.material.resize(pixels);
  for (auto* plane : {&image.truth.range_m, &image.truth.temperature_k,
                      &image.truth.sun_elevation_deg, &image.truth.shadow_fraction}) {
    plane->resize(pixels);
  }
  return image;
}

}  // namespace

RenderResult render(const radiometry::SceneDescription& scene, const Camera& camera,
                    const RenderOptions& options, Diagnostics& diagnostics) {
  RenderResult result;
  std::vector<ArrayJob> jobs;
  std::vector<Tile> tiles;
  const CameraPlan plan = options.plan != nullptr
                              ? *options.plan
                              : plan_camera(camera.arrays, options.sampling.wavelengths_per_band);
  for (const sensor::DetectorArray& array : camera.arrays) {
    const auto cut =
        cut_into_tiles(static_cast<int>(jobs.size()), array.samples, array.lines, tile_edge);
    tiles.insert(tiles.end(), cut.begin(), cut.end());
    jobs.push_back(prepare(scene, camera.pose, array, plan.arrays[jobs.size()], diagnostics));
    if (options.asks_for_heat != nullptr) {
      jobs.back().solves_heat = (*options.asks_for_heat)[jobs.size() - 1];
    }
    result.images.push_back(blank_image(array, scene, options.truth));
  }

  std::mutex mutex;  // guards the counters and the progress display
  std::size_t done = 0;
  for_each_tile(tiles, options.threads, [&](const Tile& tile) {
    const auto index = static_cast<std::size_t>(tile.array);
    PixelRenderer pixels{jobs[index], options, mix(options.seed, index)};
    for (int line = tile.first_line; line < tile.first_line + tile.lines; ++line) {
      for (int sample = tile.first_sample; sample < tile.first_sample + tile.samples; ++sample) {
        pixels.render(sample, line, result.images[index]);
      }
    }
    const std::scoped_lock lock{mutex};
    result.counters += pixels.counters();
    if (options.progress) options.progress(++done, tiles.size());
  });
  return result;
}

}  // namespace nadir::sim
