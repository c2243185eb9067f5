#include "sim/run/render.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

#include "sim/run/pixel.hpp"
#include "sim/run/strips.hpp"
#include "sim/run/tiles.hpp"

namespace nadir::sim {
namespace {

// Small enough to keep all processors busy to the end, large enough that a tile outweighs its
// solvers' construction a thousand times.
constexpr int tile_edge = 16;
// Bands centred beyond this see more emission than sun in an ordinary scene, so that a brightness
// temperature says something.
constexpr double emissive_beyond_um = 3.0;

ArrayJob prepare(const radiometry::SceneDescription& scene, const Camera& camera,
                 std::size_t number, ArrayPlan plan, const RenderOptions& options,
                 Diagnostics& diagnostics) {
  ArrayJob job{&scene, &camera.platform, &camera.arrays[number], std::move(plan), {}, {}};
  for (const spectral::Lanes& lanes : job.plan.lanes.blocks) {
    job.blocks.emplace_back(scene, lanes, diagnostics);
  }
  const bool heat = options.asks_for_heat == nullptr || (*options.asks_for_heat)[number];
  job.truth = {options.truth, options.sky_view, options.fractions, heat, options.frame};
  return job;
}

BandImage blank_band(const sensor::Band& band, std::size_t pixels, bool shares) {
  BandImage image;
  image.name = band.name;
  image.centre_um = spectral::centre(band.response).value;
  image.fwhm_um = spectral::fwhm(band.response).value;
  image.radiance.resize(pixels);
  image.standard_error.resize(pixels);
  if (image.centre_um > emissive_beyond_um) {
    image.brightness_temperature.resize(pixels);
    image.brightness_temperature_error.resize(pixels);
  }
  if (shares) {
    image.shares.path.resize(pixels);
    image.shares.emission.resize(pixels);
  }
  return image;
}

ArrayImage blank_strip(const ArrayJob& job, const Strip& strip, const RenderOptions& options) {
  const sensor::DetectorArray& array = *job.array;
  ArrayImage image;
  image.name = array.name;
  image.samples = array.samples;
  image.lines = strip.lines;
  image.first_line = strip.first_line;
  image.all_lines = array.lines;
  image.paths = static_cast<std::uint32_t>(options.sampling.replicates *
                                           options.sampling.samples_per_replicate);
  for (const sensor::Band& band : array.bands) {
    image.bands.push_back(blank_band(band, image.pixels(), options.shares));
  }
  static const std::vector<std::string> nameless;
  const auto& names = options.object_names != nullptr ? *options.object_names : nameless;
  prepare(image.truth, image.pixels(), *job.scene, names, job.truth);
  return image;
}

/// Tells of progress and adds up what threads have done.
struct Tally {
  std::mutex mutex;
  std::size_t done = 0, all = 0;
  radiometry::Counters counters;

  void add(const PixelRenderer& pixels, const RenderOptions& options) {
    const std::scoped_lock lock{mutex};
    counters += pixels.counters();
    if (options.progress) options.progress(++done, all);
  }
};

ArrayImage render_strip(const ArrayJob& job, const Strip& strip, std::uint64_t array_key,
                        const RenderOptions& options, Tally& tally) {
  ArrayImage image = blank_strip(job, strip, options);
  const auto tiles = cut_into_tiles(0, image.samples, image.lines, tile_edge);
  for_each_tile(tiles, options.threads, [&](const Tile& tile) {
    PixelRenderer pixels{job, options, array_key};
    for (int line = tile.first_line; line < tile.first_line + tile.lines; ++line) {
      for (int sample = tile.first_sample; sample < tile.first_sample + tile.samples; ++sample) {
        pixels.render(sample, strip.first_line + line, image);
      }
    }
    tally.add(pixels, options);
  });
  return image;
}

}  // namespace

radiometry::Counters render_strips(const radiometry::SceneDescription& scene, const Camera& camera,
                                   const RenderOptions& options, Diagnostics& diagnostics,
                                   const StripSink& sink) {
  const CameraPlan plan = options.plan != nullptr
                              ? *options.plan
                              : plan_camera(camera.arrays, options.sampling.wavelengths_per_band);
  Tally tally;
  for (const sensor::DetectorArray& array : camera.arrays) {
    for (const Strip& strip : cut_into_strips(array.samples, array.lines, tile_edge)) {
      tally.all += cut_into_tiles(0, array.samples, strip.lines, tile_edge).size();
    }
  }
  for (std::size_t i = 0; i < camera.arrays.size(); ++i) {
    const ArrayJob job = prepare(scene, camera, i, plan.arrays[i], options, diagnostics);
    const sensor::DetectorArray& array = camera.arrays[i];
    for (const Strip& strip : cut_into_strips(array.samples, array.lines, tile_edge)) {
      sink(i, render_strip(job, strip, mix(options.seed, i), options, tally));
    }
  }
  return tally.counters;
}

RenderResult render(const radiometry::SceneDescription& scene, const Camera& camera,
                    const RenderOptions& options, Diagnostics& diagnostics) {
  RenderResult result;
  result.counters = render_strips(scene, camera, options, diagnostics,
                                  [&](std::size_t array, ArrayImage&& strip) {
                                    if (array == result.images.size()) {
                                      result.images.push_back(std::move(strip));
                                    } else {
                                      append(result.images[array], strip);
                                    }
                                  });
  for (ArrayImage& image : result.images) image.all_lines = 0;
  return result;
}

}  // namespace nadir::sim
