#include "sim/run/array_job.hpp"

namespace nadir::sim {
namespace {

// Bands centred beyond this see more emission than sun in an ordinary scene, so that a brightness
// temperature says something.
constexpr double emissive_beyond_um = 3.0;

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

}  // namespace

CameraPlan plan_of(const Camera& camera, const RenderOptions& options) {
  if (options.plan != nullptr) return *options.plan;
  return plan_camera(camera.arrays, options.sampling.wavelengths_per_band);
}

ArrayJob array_job(const radiometry::SceneDescription& scene, const Camera& camera,
                   std::size_t number, const ArrayPlan& plan, const RenderOptions& options,
                   Diagnostics& diagnostics) {
  ArrayJob job{&scene, &camera.platform, &camera.arrays[number], plan, {}, {}, number};
  const auto effects =
      options.effects != nullptr ? (*options.effects)[number] : radiometry::EffectSet::all();
  for (const spectral::Lanes& lanes : job.plan.lanes.blocks) {
    job.blocks.emplace_back(scene, lanes, diagnostics, effects);
  }
  const bool heat = options.asks_for_heat == nullptr || (*options.asks_for_heat)[number];
  job.truth = {options.truth, options.sky_view, options.fractions, heat, options.frame};
  return job;
}

ArrayImage blank_image(const ArrayJob& job, const ImagePart& part, const RenderOptions& options,
                       bool truth) {
  const sensor::DetectorArray& array = *job.array;
  ArrayImage image;
  image.name = array.name;
  image.samples = part.samples;
  image.lines = part.lines;
  image.first_sample = part.first_sample;
  image.first_line = part.first_line;
  image.all_lines = array.lines;
  if (options.goal != nullptr) {
    image.pixel_paths.resize(image.pixels());
  } else {
    image.paths = static_cast<std::uint32_t>(options.sampling.replicates *
                                             options.sampling.samples_per_replicate);
  }
  for (const sensor::Band& band : array.bands) {
    image.bands.push_back(blank_band(band, image.pixels(), options.shares));
  }
  if (!truth) return image;
  static const std::vector<std::string> nameless;
  const auto& names = options.object_names != nullptr ? *options.object_names : nameless;
  prepare(image.truth, image.pixels(), *job.scene, names, job.truth);
  return image;
}

}  // namespace nadir::sim
