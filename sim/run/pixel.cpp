#include "sim/run/pixel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nadir::sim {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint32_t pixel_area = 0;  // the random number that places a path inside its pixel

std::size_t pixel_number(int samples, int sample, int line) {
  return static_cast<std::size_t>(line) * static_cast<std::size_t>(samples) +
         static_cast<std::size_t>(sample);
}

Sampler path_numbers(std::uint64_t array_key, std::size_t pixel, int replicate, int path) {
  return {mix(mix(array_key, pixel), static_cast<std::uint64_t>(replicate)),
          static_cast<std::uint32_t>(path)};
}

float mean_or_missing(double sum, std::uint32_t count) {
  return count > 0 ? static_cast<float>(sum / count) : missing;
}

}  // namespace

Sampler first_path(std::uint64_t array_key, const sensor::DetectorArray& array, int sample,
                   int line) {
  return path_numbers(array_key, pixel_number(array.samples, sample, line), 0, 0);
}

geometry::Ray pixel_ray(const sensor::DetectorArray& array, const sensor::Pose& pose,
                        const Sampler& numbers, int sample, int line) {
  const Vec2 inside = numbers.point(pixel_area);
  return sensor::view_ray(array, pose, sample + inside.x, line + inside.y);
}

/// Sums over the paths of a pixel that hit something.
struct PixelRenderer::TruthSums {
  std::uint32_t hits = 0;
  std::uint32_t with_temperature = 0;  // fewer where nobody asked for some
  double range_m = 0.0, temperature_k = 0.0, sun_elevation_deg = 0.0, shadow = 0.0;
};

PixelRenderer::PixelRenderer(const ArrayJob& job, const RenderOptions& options,
                             std::uint64_t array_key)
    : job_{&job},
      options_{&options},
      array_key_{array_key},
      spread_(job.array->bands.size()),
      material_votes_(job.scene->materials.size() + 1) {
  for (const radiometry::LitScene& block : job.blocks) {
    if (job.scene->method == radiometry::Method::path) {
      solvers_.emplace_back(radiometry::PathSolver{block});
    } else {
      solvers_.emplace_back(radiometry::GenericSolver{block});
    }
    lane_sums_.emplace_back(block.lanes().count());
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
  all.truth_rays += truth_rays_;
  return all;
}

void PixelRenderer::render(int sample, int line, ArrayImage& image) {
  const std::size_t pixel = pixel_number(image.samples, sample, line);
  TruthSums truth;
  std::fill(material_votes_.begin(), material_votes_.end(), 0U);
  std::fill(spread_.begin(), spread_.end(), Welford{});
  for (int replicate = 0; replicate < options_->sampling.replicates; ++replicate) {
    for (auto& sum : lane_sums_) sum = spectral::SpectrumSum{sum.count()};
    for (int path = 0; path < options_->sampling.samples_per_replicate; ++path) {
      const Sampler numbers = path_numbers(array_key_, pixel, replicate, path);
      trace(pixel_ray(*job_->array, *job_->pose, numbers, sample, line), numbers, truth);
    }
    close_replicate();
  }
  store(pixel, truth, image);
}

void PixelRenderer::trace(const geometry::Ray& ray, const Sampler& numbers, TruthSums& truth) {
  const geometry::Scene& scene = job_->scene->geometry;
  const RayBending* bending = options_->bending;
  auto hit = bending != nullptr ? intersect_bent(scene, *bending, ray) : scene.intersect(ray);
  if (hit) radiometry::resolve_map(*job_->scene, *hit, numbers);
  for (std::size_t block = 0; block < solvers_.size(); ++block) {
    // Every block walks the same rays: its random numbers are the same.
    lane_sums_[block].add(std::visit(
        [&](auto& solver) { return solver.aperture_radiance(ray, hit, numbers.child(0)); },
        solvers_[block]));
  }
  ++material_votes_[hit ? shown_as(hit->material) + 1 : 0];
  if (hit && options_->truth) add_truth(*hit, truth);
}

void PixelRenderer::close_replicate() {
  for (std::size_t band = 0; band < spread_.size(); ++band) {
    double radiance = 0.0;
    for (const auto& term : job_->plan.lanes.bands[band]) {
      radiance += term.weight * lane_sums_[static_cast<std::size_t>(term.block)][term.lane];
    }
    spread_[band].add(radiance / options_->sampling.samples_per_replicate);
  }
}

std::uint32_t PixelRenderer::shown_as(std::uint32_t material) const {
  return job_->scene->materials[material].shown_as.value_or(material);
}

const ephemeris::LightSource* PixelRenderer::sun() const {
  const auto& bodies = job_->scene->illumination;
  const auto found = std::find_if(bodies.begin(), bodies.end(),
                                  [](const auto& body) { return body.name == "sun"; });
  return found == bodies.end() ? nullptr : &*found;
}

void PixelRenderer::add_truth(const geometry::Hit& hit, TruthSums& truth) {
  ++truth.hits;
  truth.range_m += hit.distance;
  const thermal::TemperatureField& temperature = job_->scene->temperature;
  if (job_->solves_heat || !temperature.solved(hit.material)) {
    const double kelvin = temperature.at(hit).value;
    truth.temperature_k += std::isfinite(kelvin) ? kelvin : 0.0;
    truth.with_temperature += std::isfinite(kelvin) ? 1 : 0;
  }
  const ephemeris::LightSource* body = sun();
  if (body == nullptr) return;
  const Vec3 towards = body->direction_enu;
  const double sine = std::clamp(dot(towards, hit.normal), -1.0, 1.0);
  truth.sun_elevation_deg += to_degrees(Angle{std::asin(sine)});
  bool dark = towards.z <= 0.0 || sine <= 0.0;
  if (!dark) {
    ++truth_rays_;
    dark = job_->scene->geometry.occluded({geometry::leaving_origin(hit, towards), towards});
  }
  if (dark) truth.shadow += 1.0;
}

void PixelRenderer::store(std::size_t pixel, const TruthSums& truth, ArrayImage& image) const {
  for (std::size_t band = 0; band < spread_.size(); ++band) {
    const Estimate estimate = spread_[band].estimate();
    image.bands[band].radiance[pixel] = static_cast<float>(estimate.mean);
    image.bands[band].standard_error[pixel] = static_cast<float>(estimate.standard_error);
    if (image.bands[band].brightness_temperature.empty()) continue;
    image.bands[band].brightness_temperature[pixel] =
        static_cast<float>(spectral::band_brightness_temperature(job_->plan.quadratures[band],
                                                                 SpectralRadiance{estimate.mean})
                               .value);
  }
  if (!options_->truth) return;
  TruthImage& planes = image.truth;
  const auto winner = std::max_element(material_votes_.begin(), material_votes_.end());
  planes.material[pixel] = static_cast<std::uint32_t>(winner - material_votes_.begin());
  planes.range_m[pixel] = mean_or_missing(truth.range_m, truth.hits);
  planes.temperature_k[pixel] = mean_or_missing(truth.temperature_k, truth.with_temperature);
  const std::uint32_t lit = sun() == nullptr ? 0 : truth.hits;
  planes.sun_elevation_deg[pixel] = mean_or_missing(truth.sun_elevation_deg, lit);
  planes.shadow_fraction[pixel] = mean_or_missing(truth.shadow, lit);
}

}  // namespace nadir::sim
