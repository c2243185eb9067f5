#include "sim/run/pixel.hpp"

#include <algorithm>
#include <cmath>

namespace nadir::sim {
namespace {

std::size_t pixel_number(int samples, int sample, int line) {
  return static_cast<std::size_t>(line) * static_cast<std::size_t>(samples) +
         static_cast<std::size_t>(sample);
}

bool depends_on_band(const sensor::DetectorArray& array) {
  return array.spread && array.spread->depends_on_band();
}

}  // namespace

Sampler path_numbers(std::uint64_t array_key, const sensor::DetectorArray& array,
                     const PathNumber& number) {
  const std::size_t pixel = pixel_number(array.samples, number.sample, number.line);
  return {mix(mix(array_key, pixel), static_cast<std::uint64_t>(number.replicate)),
          static_cast<std::uint32_t>(number.path)};
}

PixelRenderer::PixelRenderer(const ArrayJob& job, const RenderOptions& options,
                             std::uint64_t array_key)
    : job_{&job},
      options_{&options},
      array_key_{array_key},
      weighted_{depends_on_band(*job.array)},
      weights_(job.array->bands.size()),
      means_(job.array->bands.size()),
      bands_{job.array->bands.size(), options.sampling.replicates, weighted_},
      truth_{*job.scene, job.truth} {
  for (const radiometry::LitScene& block : job.blocks) {
    if (job.scene->method == radiometry::Method::path) {
      solvers_.emplace_back(radiometry::PathSolver{block});
    } else {
      solvers_.emplace_back(radiometry::GenericSolver{block});
    }
    const int lanes = block.lanes().count();
    lane_sums_.emplace_back(lanes);
    lanes_.emplace_back(lanes, 0.0F);
    path_.emplace_back(lanes);
    emission_.emplace_back(lanes);
  }
}

radiometry::Counters PixelRenderer::counters() const {
  radiometry::Counters all;
  const auto counted = [](const Solver& solver) {
    return std::visit([](const auto& s) { return s.counters(); }, solver);
  };
  for (const Solver& solver : solvers_) all += counted(solver);
  // The blocks of lanes share their primary rays.
  if (!solvers_.empty()) all.primary_rays = counted(solvers_.front()).primary_rays;
  all.truth_rays += truth_.rays();
  return all;
}

void PixelRenderer::render(int sample, int line, ArrayImage& strip) {
  const sensor::DetectorArray& array = *job_->array;
  const std::size_t pixel = pixel_number(strip.samples, sample, line - strip.first_line);
  truth_.begin_pixel();
  bands_.begin_pixel();
  for (auto* sums : {&path_, &emission_}) {
    for (auto& sum : *sums) sum = spectral::SpectrumSum{sum.count()};
  }
  for (int replicate = 0; replicate < options_->sampling.replicates; ++replicate) {
    for (auto& sum : lane_sums_) sum = spectral::SpectrumSum{sum.count()};
    for (int path = 0; path < options_->sampling.samples_per_replicate; ++path) {
      const Sampler numbers = path_numbers(array_key_, array, {sample, line, replicate, path});
      trace(sensor::path_view(array, *job_->platform, sample, line, numbers), numbers);
    }
    close_replicate();
  }
  store(pixel, strip);
  truth_.store(pixel, strip.truth);
  if (!strip.truth.time_s.empty()) {
    strip.truth.time_s[pixel] = sensor::image_time_s(array, {sample + 0.5, line + 0.5});
  }
}

void PixelRenderer::trace(const sensor::PathView& view, const Sampler& numbers) {
  const geometry::Scene& scene = job_->scene->geometry;
  const geometry::Ray& ray = view.ray;
  const RayBending* bending = options_->bending;
  auto hit = bending != nullptr ? intersect_bent(scene, *bending, ray) : scene.intersect(ray);
  if (hit) radiometry::resolve_map(*job_->scene, *hit, numbers);
  for (std::size_t block = 0; block < solvers_.size(); ++block) {
    // Every block walks the same rays: its random numbers are the same.
    lanes_[block] = std::visit(
        [&](auto& solver) { return solver.aperture_radiance(ray, hit, numbers.child(0)); },
        solvers_[block]);
    lane_sums_[block].add(lanes_[block]);
  }
  if (weighted_) add_weighted(view);
  if (options_->shares) add_shares(ray, hit);
  truth_.add(ray, hit ? &*hit : nullptr, numbers);
}

template <class Values>
double PixelRenderer::of_band(std::size_t band, const Values& by_block) const {
  double radiance = 0.0;
  for (const auto& term : job_->plan.lanes.bands[band]) {
    radiance += term.weight * by_block[static_cast<std::size_t>(term.block)][term.lane];
  }
  return radiance;
}

void PixelRenderer::add_weighted(const sensor::PathView& view) {
  job_->array->spread->weights(view.spread, weights_);
  for (std::size_t band = 0; band < weights_.size(); ++band) {
    bands_.add_weighted(band, weights_[band], of_band(band, lanes_));
  }
}

void PixelRenderer::add_shares(const geometry::Ray& ray, const std::optional<geometry::Hit>& hit) {
  for (std::size_t block = 0; block < path_.size(); ++block) {
    const auto known = radiometry::effect_shares(job_->blocks[block], ray, hit);
    path_[block].add(known.path);
    emission_[block].add(known.emission);
  }
}

void PixelRenderer::close_replicate() {
  for (std::size_t band = 0; band < means_.size(); ++band) {
    means_[band] = of_band(band, lane_sums_) / options_->sampling.samples_per_replicate;
  }
  bands_.close_replicate(means_, options_->sampling.samples_per_replicate);
}

void PixelRenderer::store_brightness(std::size_t pixel, std::size_t band, const Estimate& radiance,
                                     BandImage& image) const {
  const auto& quadrature = job_->plan.quadratures[band];
  const auto temperature_of = [&](double value) {
    return spectral::band_brightness_temperature(quadrature, SpectralRadiance{value}).value;
  };
  const double kelvin = temperature_of(radiance.mean);
  image.brightness_temperature[pixel] = static_cast<float>(kelvin);
  // The error carried through Planck's law: to first order, by a difference that stays in it.
  const double step = 1e-4 * radiance.mean;
  const double slope = (temperature_of(radiance.mean + step) - kelvin) / step;
  image.brightness_temperature_error[pixel] = static_cast<float>(slope * radiance.standard_error);
}

void PixelRenderer::store(std::size_t pixel, ArrayImage& strip) const {
  const double paths = options_->sampling.replicates * options_->sampling.samples_per_replicate;
  for (std::size_t band = 0; band < strip.bands.size(); ++band) {
    const Estimate estimate = bands_.estimate(band);
    BandImage& image = strip.bands[band];
    image.radiance[pixel] = static_cast<float>(estimate.mean);
    image.standard_error[pixel] = static_cast<float>(estimate.standard_error);
    if (!image.brightness_temperature.empty()) store_brightness(pixel, band, estimate, image);
    if (!options_->shares) continue;
    image.shares.path[pixel] = static_cast<float>(of_band(band, path_) / paths);
    image.shares.emission[pixel] = static_cast<float>(of_band(band, emission_) / paths);
  }
}

}  // namespace nadir::sim
