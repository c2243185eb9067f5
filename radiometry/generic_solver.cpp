#include "radiometry/generic_solver.hpp"

#include <algorithm>
#include <numbers>

#include "core/frame.hpp"
#include "radiometry/quad_hemisphere.hpp"
#include "radiometry/sample_allocation.hpp"
#include "radiometry/thresholds.hpp"

namespace nadir::radiometry {

using geometry::Hit;
using geometry::Ray;
using spectral::Spectrum;
using spectral::SpectrumSum;

namespace {

// Purposes of the random numbers at one hit. Quads have children of their own from there on.
enum Dimension : std::uint32_t { allocation = 0, first_target = 16 };
constexpr std::uint32_t first_quad = 1024;

}  // namespace

/// A hit that is being solved.
struct GenericSolver::Visit {
  const Hit& hit;
  const materials::BoundMaterial& material;
  const materials::SolverSettings& settings;
  Frame frame;    // about the normal
  Vec3 wo;        // towards the ray that asked, local
  double weight;  // of that ray
  int generation;
  Sampler sampler;

  Visit(const LitScene& scene, const Ray& ray, const Hit& at, double ray_weight, int g,
        const Sampler& numbers)
      : hit{at},
        material{scene.material(at)},
        settings{scene.settings(at)},
        frame{frame_about(at.normal)},
        wo{frame.to_local(-ray.direction)},
        weight{ray_weight},
        generation{g},
        sampler{numbers} {}

  /// What the surface does with light from a direction (local), for unit reflectance: f cos.
  [[nodiscard]] double reflected(Vec3 wi) const {
    return materials::eval(material.scattering, wi, wo) * wi.z;
  }
  /// The same with the weights that the thresholds look at.
  [[nodiscard]] Sample sample(Vec3 wi) const {
    const double shape = materials::eval(material.scattering, wi, wo);
    const double reflectance =
        std::numbers::pi * shape * static_cast<double>(material.max_reflectance);
    return {shape * wi.z, reflectance, weight * reflectance * wi.z};
  }
  [[nodiscard]] Ray leaving(Vec3 direction) const {
    return {geometry::leaving_origin(hit, direction), direction};
  }
};

Spectrum GenericSolver::surface_radiance(const Ray& ray, const Hit& hit, const Sampler& sampler,
                                         double ray_weight) {
  const Visit visit{*scene_, ray, hit, ray_weight, 0, sampler};
  return scene_->self_emission(hit) + scattered_radiance(visit);
}

Spectrum GenericSolver::aperture_radiance(const Ray& ray, const std::optional<Hit>& hit,
                                          const Sampler& sampler) {
  ++counters_.primary_rays;
  if (!hit) return scene_->air().sky(ray.direction);
  const atmosphere::PathTerms path = scene_->air().path(-ray.direction, hit->distance);
  return surface_radiance(ray, *hit, sampler) * path.transmittance + path.radiance;
}

Spectrum GenericSolver::scattered_radiance(const Visit& visit) {
  if (visit.weight < thresholds::current_weight) {
    ++counters_.current_weight_stops;
    return Spectrum{scene_->lanes().count()};
  }
  SpectrumSum sum{scene_->lanes().count()};
  const int targets_sampled = add_targets(visit, sum);
  add_background(visit, targets_sampled, sum);
  return sum.spectrum() * visit.material.reflectance;
}

// The sums below leave out the material's reflectance: it is the same for all their terms.

int GenericSolver::add_targets(const Visit& visit, SpectrumSum& sum) {
  int sampled = 0;
  std::uint32_t number = first_target;
  for (const Target& target : scene_->targets()) {
    const Vec3 direction = direction_in_disc(target, visit.sampler.point(number++));
    const Vec3 wi = visit.frame.to_local(direction);
    if (direction.z <= 0.0 || wi.z <= 0.0) continue;  // set behind the horizon or the surface
    const Sample sample = visit.sample(wi);
    if (sample.weight < thresholds::target_weight) {
      ++counters_.target_weight_skips;
      continue;
    }
    ++sampled;
    ++counters_.target_rays;
    if (scene_->geometry().occluded(visit.leaving(direction))) continue;
    sum.add(target.irradiance, sample.reflected);
  }
  return sampled;
}

void GenericSolver::add_background(const Visit& visit, int targets_sampled, SpectrumSum& sum) {
  const materials::SolverSettings& settings = visit.settings;
  const QuadHemisphere quads{settings.mu_samples, settings.phi_samples};
  int budget = 0;
  if (visit.generation < settings.max_bounces) {
    const int all = full_sample_count(settings.initial_sample_count, settings.sample_decay_rate,
                                      visit.generation);
    budget = std::max(0, all - targets_sampled);
    if (budget == 0 && all > 0) ++counters_.budget_stops;
  } else {
    ++counters_.bounce_limit_stops;
  }
  if (budget == 0) {  // the top-up alone: nothing to deal out
    for (int quad = 0; quad < quads.count(); ++quad) add_quad(visit, quad, {0, 0.0}, sum);
    return;
  }
  // Importance of a quad: what it would reflect of a uniform sky, from its centre.
  const auto importance = [&](int quad) { return visit.reflected(quads.centre(quad)); };
  double total = 0.0;
  for (int quad = 0; quad < quads.count(); ++quad) total += importance(quad);
  SystematicAllocation allocation{budget, total, visit.sampler.number(Dimension::allocation)};
  for (int quad = 0; quad < quads.count(); ++quad) {
    add_quad(visit, quad, allocation.next(importance(quad)), sum);
  }
}

// What the thresholds leave of a sample.
GenericSolver::Kind GenericSolver::admitted(const Sample& sample, bool full) {
  if (sample.reflectance < thresholds::raw_weight) {
    ++counters_.raw_weight_skips;
    return Kind::none;
  }
  if (sample.weight < thresholds::quick_weight) {
    ++counters_.quick_weight_skips;
    return Kind::none;
  }
  if (full && sample.weight < thresholds::full_background_weight) {
    ++counters_.full_weight_downgrades;
    full = false;
  }
  ++(full ? counters_.full_samples : counters_.direct_only_samples);
  return full ? Kind::full : Kind::direct_only;
}

void GenericSolver::add_quad(const Visit& visit, int quad, const SystematicAllocation::Share& share,
                             SpectrumSum& sum) {
  const QuadHemisphere quads{visit.settings.mu_samples, visit.settings.phi_samples};
  const int count = std::max(share.count, visit.settings.min_quad_samples);
  if (count == 0) return;
  const double scattered_share = share.expected > 0.0 ? quads.solid_angle() / share.expected : 0.0;
  // Without a guaranteed minimum the direct part, too, must be weighed by the expected number.
  const double direct_share =
      visit.settings.min_quad_samples > 0 ? quads.solid_angle() / count : scattered_share;
  const Sampler numbers = visit.sampler.child(first_quad + static_cast<std::uint32_t>(quad));
  for (int n = 0; n < count; ++n) {
    const auto branch = static_cast<std::uint32_t>(n);
    const Vec3 wi = quads.direction(quad, numbers.point(branch));
    const Sample sample = visit.sample(wi);
    const Kind kind = admitted(sample, n < share.count);
    if (kind == Kind::none) continue;
    const Ray ray = visit.leaving(visit.frame.to_world(wi));
    const auto hit = scene_->geometry().intersect(ray);
    sum.add(hit ? scene_->self_emission(*hit) : scene_->air().sky(ray.direction),
            direct_share * sample.reflected);
    if (kind == Kind::full && hit) {
      const Visit next{
          *scene_, ray, *hit, sample.weight, visit.generation + 1, numbers.child(branch)};
      sum.add(scattered_radiance(next), scattered_share * sample.reflected);
    }
  }
}

}  // namespace nadir::radiometry
