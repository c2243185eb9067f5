#include "sim/run/pixel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/run/brightness.hpp"

namespace nadir::sim {
namespace {

std::size_t pixel_number(int samples, int sample, int line) {
  return static_cast<std::size_t>(line) * static_cast<std::size_t>(samples) +
         static_cast<std::size_t>(sample);
}

bool depends_on_band(const sensor::DetectorArray& array) {
  return array.spread && array.spread->depends_on_band();
}

int replicates_of(const RenderOptions& options) {
  return options.goal != nullptr ? options.goal->replicates : options.sampling.replicates;
}

TruthOptions truth_of(const ArrayJob& job, const PixelRound& round) {
  return round.truth ? job.truth : TruthOptions{.planes = false};
}

std::size_t pixel_in(const ArrayImage& image, int sample, int line) {
  return pixel_number(image.samples, sample - image.first_sample, line - image.first_line);
}

}  // namespace

Sampler path_numbers(std::uint64_t array_key, const sensor::DetectorArray& array,
                     const PathNumber& number) {
  const std::size_t pixel = pixel_number(array.samples, number.sample, number.line);
  return {mix(mix(array_key, pixel), static_cast<std::uint64_t>(number.replicate)),
          static_cast<std::uint32_t>(number.path)};
}

std::uint64_t round_key(std::uint64_t seed, std::size_t array, std::uint32_t round) {
  // Beyond the number of any pixel, with which keys of pixels are made from the same one.
  constexpr std::uint64_t beyond_pixels = 0x726F756E64730000ULL;
  const std::uint64_t key = mix(seed, array);
  return round == 0 ? key : mix(mix(key, beyond_pixels), round);
}

PixelRenderer::PixelRenderer(const ArrayJob& job, const RenderOptions& options,
                             const PixelRound& round)
    : job_{&job},
      options_{&options},
      round_{round},
      replicates_{replicates_of(options)},
      weighted_{depends_on_band(*job.array)},
      weights_(job.array->bands.size()),
      means_(job.array->bands.size()),
      bands_{job.array->bands.size(), replicates_, weighted_},
      truth_{*job.scene, truth_of(job, round)},
      found_(job.array->bands.size()),
      errors_(job.array->bands.size(), ErrorStatement{replicates_}) {
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

void PixelRenderer::begin_pixel(int sample, int line) {
  sample_ = sample;
  line_ = line;
  samples_ = 0;
  truth_.begin_pixel();
  bands_.begin_pixel();
  for (ErrorStatement& error : errors_) error.begin_pixel();
  for (auto* sums : {&path_, &emission_}) {
    for (auto& sum : *sums) sum = spectral::SpectrumSum{sum.count()};
  }
  std::fill(found_.begin(), found_.end(), Estimate{0.0, 0.0});
}

void PixelRenderer::render(int sample, int line, ArrayImage& strip, const PixelOrder& order) {
  begin_pixel(sample, line);
  if (!order.samples) {
    sample_as_asked(order);
  } else if (*order.samples > 0) {
    sample_to(*order.samples);
    judge();
  }
  store(strip);
}

void PixelRenderer::measure(int sample, int line, PixelMeasure& found) {
  begin_pixel(sample, line);
  sample_as_asked({});
  found.bands = found_;
  found.replicates.resize(found_.size());
  for (std::size_t band = 0; band < found_.size(); ++band) {
    found.replicates[band].resize(static_cast<std::size_t>(replicates_));
    bands_.estimates(band, found.replicates[band]);
  }
  found.paths = paths();
}

void PixelRenderer::sample_as_asked(const PixelOrder& order) {
  if (options_->goal != nullptr) return sample_to_goal(order);
  sample_to(options_->sampling.samples_per_replicate);
  judge();
}

void PixelRenderer::sample_to_goal(const PixelOrder& order) {
  const SamplingGoal& goal = *options_->goal;
  const int most = order.most_samples > 0 ? order.most_samples : goal.most_samples;
  // The first look comes at half the least number, so that two agree when a pixel is done with it.
  int next = std::max(1, goal.first_samples / 2);
  while (samples_ < most) {
    sample_to(std::min(next, most));
    judge();
    next = 2 * samples_;
    if (samples_ < goal.first_samples || paths() < order.least_paths || !meets_goal()) continue;
    // Where all replicates are equal, either nothing is random or something rare was not seen yet.
    if (!all_equal() || samples_ >= 2 * goal.first_samples) return;
  }
}

bool PixelRenderer::all_equal() const {
  return std::all_of(found_.begin(), found_.end(),
                     [](const Estimate& e) { return e.standard_error == 0.0; });
}

bool PixelRenderer::meets_goal() const {
  const auto& goals = options_->goal->bands[job_->number];
  for (std::size_t band = 0; band < found_.size(); ++band) {
    const Estimate& found = found_[band];
    if (!std::isfinite(found.mean)) continue;  // what is no number gets none by more samples
    if (!(found.standard_error <= goals[band].error_of(found.mean))) return false;
  }
  return true;
}

void PixelRenderer::judge() {
  for (std::size_t band = 0; band < found_.size(); ++band) {
    found_[band] = bands_.estimate(band);
    if (options_->goal == nullptr) continue;
    found_[band].standard_error = errors_[band].add(samples_, found_[band].standard_error);
  }
}

void PixelRenderer::sample_to(int samples) {
  const sensor::DetectorArray& array = *job_->array;
  // Truth planes need no more paths than the least that a pixel gets, but cost a ray each.
  const int with_truth = options_->goal != nullptr ? std::max(2, options_->goal->first_samples)
                                                   : std::numeric_limits<int>::max();
  bands_.begin_round();
  for (int replicate = 0; replicate < replicates_; ++replicate) {
    for (auto& sum : lane_sums_) sum = spectral::SpectrumSum{sum.count()};
    for (int path = samples_; path < samples; ++path) {
      const Sampler numbers =
          path_numbers(round_.array_key, array, {sample_, line_, replicate, path});
      trace(sensor::path_view(array, *job_->platform, sample_, line_, numbers), numbers,
            path < with_truth);
    }
    close_replicate(samples - samples_);
  }
  samples_ = samples;
}

void PixelRenderer::trace(const sensor::PathView& view, const Sampler& numbers, bool truth) {
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
  if (truth) truth_.add(ray, hit ? &*hit : nullptr, numbers);
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

void PixelRenderer::close_replicate(int samples) {
  for (std::size_t band = 0; band < means_.size(); ++band) {
    means_[band] = of_band(band, lane_sums_) / samples;
  }
  bands_.close_replicate(means_, samples);
}

void PixelRenderer::store(ArrayImage& strip) const {
  const std::size_t pixel = pixel_in(strip, sample_, line_);
  const double all_paths = std::max(1U, paths());
  if (!strip.pixel_paths.empty()) strip.pixel_paths[pixel] = paths();
  for (std::size_t band = 0; band < strip.bands.size(); ++band) {
    const Estimate& estimate = found_[band];
    BandImage& image = strip.bands[band];
    image.radiance[pixel] = static_cast<float>(estimate.mean);
    image.standard_error[pixel] = static_cast<float>(estimate.standard_error);
    if (!image.brightness_temperature.empty() && samples_ > 0) {
      const Estimate kelvin = brightness_temperature(job_->plan.quadratures[band], estimate);
      image.brightness_temperature[pixel] = static_cast<float>(kelvin.mean);
      image.brightness_temperature_error[pixel] = static_cast<float>(kelvin.standard_error);
    }
    if (!options_->shares) continue;
    image.shares.path[pixel] = static_cast<float>(of_band(band, path_) / all_paths);
    image.shares.emission[pixel] = static_cast<float>(of_band(band, emission_) / all_paths);
  }
  if (!round_.truth) return;
  truth_.store(pixel, strip.truth);
  if (!strip.truth.time_s.empty()) {
    strip.truth.time_s[pixel] = sensor::image_time_s(*job_->array, {sample_ + 0.5, line_ + 0.5});
  }
}

}  // namespace nadir::sim
