#include "radiometry/generic_solver.hpp"

#include <algorithm>
#include <limits>

#include "radiometry/generic_solver_state.hpp"
#include "radiometry/thresholds.hpp"
#include "radiometry/visibility.hpp"

namespace nadir::radiometry {

using namespace generic;  // NOLINT(google-build-using-namespace): names of this folder alone
using geometry::Hit;
using geometry::Ray;
using spectral::Spectrum;
using spectral::SpectrumSum;

namespace {

// Of the budget of full samples this share goes to lamps: one of them drawn from ten thousand says
// little, and what the others would find are mostly surfaces that the same lamps light.
constexpr int samples_per_lamp_draw = 4;

}  // namespace

GenericSolver::GenericSolver(const LitScene& scene) : scene_{&scene} {
  int bounces = 0;
  for (std::size_t i = 0; i < scene.description().materials.size(); ++i) {
    const GenericPlan& plan = scene.plan(static_cast<std::uint32_t>(i));
    bounces = std::max(bounces, plan.settings().max_bounces);
    if (plan.importance()) {
      row_ = std::max(row_, static_cast<std::size_t>(plan.importance()->quads()));
    }
  }
  importance_.resize(row_ * static_cast<std::size_t>(bounces + 1));
}

Spectrum GenericSolver::surface_radiance(const Ray& ray, const Hit& hit, const Sampler& sampler,
                                         double ray_weight) {
  const SurfacePoint point{*scene_, ray, hit};
  Spectrum radiance = scattered_radiance(Visit{*scene_, point, ray_weight, 0, sampler});
  return radiance += emission(*scene_, point);
}

Spectrum GenericSolver::aperture_radiance(const Ray& ray, const std::optional<Hit>& hit,
                                          const Sampler& sampler) {
  ++counters_.primary_rays;
  SpectrumSum sum{scene_->lanes().count()};
  Arrival arrival{Spectrum{scene_->lanes().count(), 1.0F}};
  arrival.lights.seen = true;
  arrival.at_sensor = true;
  if (hit) {
    const atmosphere::PathTerms path = scene_->air().path(ray.origin, ray.direction, hit->distance);
    sum.add(path.radiance);
    arrival.factor = path.transmittance;
  }
  receive(ray, hit, arrival, sampler, sum);
  return sum.spectrum();
}

Spectrum GenericSolver::scattered_radiance(const Visit& visit) {
  SpectrumSum sum{scene_->lanes().count()};
  if (visit.weight < thresholds::current_weight) {
    ++counters_.current_weight_stops;
    return sum.spectrum();
  }
  // How many lobe samples there will be decides how lights share with them; that they come out of
  // one budget with the rays to the lights is settled by what each of those would cost.
  const int all = full_samples(visit);
  const int draws = scene_->lamps().empty() ? 0 : std::clamp(all / samples_per_lamp_draw, 1, 8);
  const int rays_to_lights = static_cast<int>(scene_->targets().size()) + draws;
  const int lobe_samples =
      visit.by_lobes() ? std::max(all - rays_to_lights, visit.minimum(scene_->interreflects())) : 0;
  // Direct-only samples end at a clear sheet, through which shadow rays pass: where they are all
  // that is left the lights are the shadow rays' alone.
  const int sharing = all == 0 && scene_->has_sheets() ? 0 : lobe_samples;
  const int spent = add_targets(visit, sharing, sum) + add_lamps(visit, draws, sharing, sum);
  const int budget = std::max(0, all - spent);
  if (budget == 0 && all > 0) ++counters_.budget_stops;
  if (visit.by_lobes()) {
    add_lobes(visit, {lobe_samples, std::min(budget, lobe_samples), draws, sharing > 0}, sum);
  } else {
    add_quads(visit, budget, sum);
  }
  return sum.spectrum();
}

int GenericSolver::full_samples(const Visit& visit) {
  const materials::SolverSettings& settings = visit.plan.settings();
  // Without interreflection nothing is asked of what a sample hits but what it emits. Behind a
  // clear sheet all is as before it.
  if (!scene_->interreflects() && !visit.point.material().traits.straight) return 0;
  if (visit.generation >= settings.max_bounces) {
    ++counters_.bounce_limit_stops;
    return 0;
  }
  return full_sample_count(settings.initial_sample_count, settings.sample_decay_rate,
                           visit.generation);
}

// ---- lights -----------------------------------------------------------------------------------

int GenericSolver::add_targets(const Visit& visit, int lobe_samples, SpectrumSum& sum) {
  const bool shadows = scene_->shadows();
  int sampled = 0;
  for (const Target& target : scene_->targets()) {
    const std::uint32_t number = first_target + target.number;
    const Sampler shadow = visit.sampler.child(number);
    const Vec3 towards = direction_in_disc(target, visit.sampler.point(number));
    if (towards.z <= 0.0) continue;  // set behind the horizon
    Sample sample{visit, towards};
    if (!sample.possible) continue;
    if (sample.weight < thresholds::target_weight) {
      ++counters_.target_weight_skips;
      continue;
    }
    ++sampled;
    sample.factor *= target.irradiance;
    if (!shadows) {
      sum.add(sample.factor, 1.0);
      continue;
    }
    ++counters_.target_rays;
    if (!passes(*scene_, visit.point.leaving(towards), shadow, sample.factor)) continue;
    sum.add(sample.factor,
            1.0 / (1.0 + lobe_samples * lobe_density(visit, towards) * target.solid_angle));
  }
  return sampled;
}

int GenericSolver::add_lamps(const Visit& visit, int draws, int lobe_samples, SpectrumSum& sum) {
  const double first_choice = visit.sampler.number(Dimension::lamp_choice);
  const Vec2 first_place = visit.sampler.point(Dimension::lamp_place);
  int sampled = 0;
  for (int n = 0; n < draws; ++n) {
    const auto lamp = scene_->lamps().sample(visit.point.hit().position, visit.point.lit_normal(),
                                             spread(first_choice, n), spread(first_place, n));
    if (!lamp) continue;
    Sample sample{visit, lamp->direction};
    if (!sample.possible) continue;
    if (sample.weight < thresholds::target_weight) {
      ++counters_.target_weight_skips;
      continue;
    }
    ++sampled;
    sample.factor *= lamp->irradiance;
    if (!scene_->shadows()) {
      sum.add(sample.factor, 1.0 / draws);
      continue;
    }
    ++counters_.lamp_rays;
    const Ray ray =
        ray_to_lamp(visit.point.leaving(lamp->direction).origin, visit.point.hit().position, *lamp);
    const Sampler numbers =
        visit.sampler.child(Dimension::lamp_choice).child(static_cast<std::uint32_t>(n));
    if (!passes(*scene_, ray, numbers, sample.factor)) continue;
    const double own = draws * lamp->pdf;
    const double other = lobe_samples * lobe_density(visit, lamp->direction);
    sum.add(sample.factor, (own > 0.0 ? own / (own + other) : 1.0) / draws);
  }
  return sampled;
}

double GenericSolver::lobe_density(const Visit& visit, Vec3 towards) {
  return visit.by_lobes() ? visit.point.pdf(towards) : 0.0;
}

// ---- the hemisphere of quads ------------------------------------------------------------------

void GenericSolver::add_quads(const Visit& visit, int budget, SpectrumSum& sum) {
  const ImportanceTable& table = *visit.plan.importance();
  const int quads = table.quads();
  if (budget == 0) {  // the top-up alone: nothing to deal out
    if (visit.minimum(scene_->interreflects()) == 0) return;
    for (int quad = 0; quad < quads; ++quad) add_quad(visit, quad, {0, 0.0}, sum);
    return;
  }
  double* const importance = &importance_[row_ * static_cast<std::size_t>(visit.generation)];
  table.importance(visit.point.wo(), importance);
  double total = 0.0;
  for (int quad = 0; quad < quads; ++quad) total += importance[quad];
  SystematicAllocation allocation{budget, total, visit.sampler.number(Dimension::allocation)};
  for (int quad = 0; quad < quads; ++quad) {
    add_quad(visit, quad, allocation.next(importance[quad]), sum);
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
  const QuadHemisphere& quads = visit.plan.quads();
  const int minimum = visit.minimum(scene_->interreflects());
  const int count = std::max(share.count, minimum);
  if (count == 0) return;
  const double scattered_share = share.expected > 0.0 ? quads.solid_angle() / share.expected : 0.0;
  // Without a guaranteed minimum the direct part, too, must be weighed by the expected number.
  const double direct_share = minimum > 0 ? quads.solid_angle() / count : scattered_share;
  const Sampler numbers = visit.sampler.child(first_quad + static_cast<std::uint32_t>(quad));
  const Vec2 first = numbers.point(0);
  for (int n = 0; n < count; ++n) {
    const auto branch = static_cast<std::uint32_t>(n);
    const Vec3 wi = visit.turn(quads.direction(quad, spread(first, n)));
    const Sample sample = Sample::of_quad(visit, wi);
    const Kind kind = admitted(sample, n < share.count);
    if (kind == Kind::none) continue;
    Arrival arrival{sample.factor, direct_share,  scattered_share,
                    kind,          sample.weight, visit.generation + 1};
    gather(visit.point.leaving(visit.point.outgoing(wi)), arrival, numbers.child(branch), sum);
  }
}

// ---- lobes narrower than a quad ---------------------------------------------------------------

void GenericSolver::add_lobes(const Visit& visit, const LobeSamples& samples, SpectrumSum& sum) {
  const auto [count, full, lamp_draws, share_lights] = samples;
  const Sampler numbers = visit.sampler.child(first_quad);
  const double first_choice = numbers.number(0);
  const Vec2 first = numbers.point(1);
  for (int n = 0; n < count; ++n) {
    const Sampler own = numbers.child(static_cast<std::uint32_t>(n));
    const auto drawn = materials::sample(visit.point.material().scattering, visit.point.wo(),
                                         {spread(first_choice, n), spread(first, n)});
    if (!drawn) continue;
    const Vec3 towards = visit.point.outgoing(drawn->wi);
    const double weight = largest(drawn->weight);
    const bool straight = drawn->delta && visit.goes_straight(drawn->wi);
    const bool solved = n < full && (straight || scene_->interreflects());
    const Kind kind = admitted(Sample{drawn->weight, weight, visit.weight * weight}, solved);
    if (kind == Kind::none) continue;
    Arrival arrival{drawn->weight, 1.0 / count,           full > 0 ? 1.0 / full : 0.0,
                    kind,          visit.weight * weight, visit.generation + 1};
    const double density = visit.point.folds() ? visit.point.pdf(towards) : drawn->pdf;
    arrival.lights = {share_lights || drawn->delta, drawn->delta ? 0.0 : count * density,
                      visit.point.hit().position, visit.point.lit_normal(), lamp_draws};
    // Shadow rays go straight through sheets, too: behind one lights count as before it.
    if (straight && visit.came != nullptr) arrival.lights = visit.came->lights;
    gather(visit.point.leaving(towards), arrival, own, sum);
  }
}

// ---- what a ray brings ------------------------------------------------------------------------

void GenericSolver::gather(const Ray& ray, Arrival& arrival, const Sampler& numbers,
                           SpectrumSum& sum) {
  receive(ray, scene_->intersect(ray, numbers), arrival, numbers, sum);
}

void GenericSolver::receive(const Ray& ray, const std::optional<Hit>& hit, Arrival& arrival,
                            const Sampler& numbers, SpectrumSum& sum) {
  const double distance = hit ? hit->distance : std::numeric_limits<double>::infinity();
  if (!scene_->volumes().empty() && scene_->volumes().crossed(ray, distance)) {
    cross_volumes(ray, distance, arrival, numbers, sum);
  }
  if (!hit) {
    add_sky(ray, arrival, sum);
    return;
  }
  const bool emits = scene_->emits();
  Spectrum scratch;
  const Spectrum* even = emits ? scene_->even_emission(*hit, scratch) : nullptr;
  if (even != nullptr) sum.add_product(arrival.factor, *even, arrival.direct_share);
  if (arrival.lights.seen && !scene_->lamps().empty()) add_lamp_surface(ray, *hit, arrival, sum);
  const bool reflects =
      arrival.kind == Kind::full && (!arrival.of_volume || scene_->interreflects());
  const bool by_direction = emits && even == nullptr;
  if (!by_direction && !reflects) return;
  const SurfacePoint point{*scene_, ray, *hit};
  if (by_direction) {
    sum.add_product(arrival.factor, emission(*scene_, point), arrival.direct_share);
  }
  if (!reflects) return;
  Visit next{*scene_, point, arrival.weight, arrival.generation, numbers};
  next.came = &arrival;
  sum.add_product(arrival.factor, scattered_radiance(next), arrival.scattered_share);
}

void GenericSolver::add_sky(const Ray& ray, const Arrival& arrival, SpectrumSum& sum) const {
  const atmosphere::BoundAtmosphere& air = scene_->air();
  sum.add_product(
      arrival.factor,
      arrival.at_sensor ? air.beyond(ray.origin, ray.direction) : air.sky(ray.direction),
      arrival.direct_share);
  if (!arrival.lights.seen) return;
  for (const Target& target : scene_->targets()) {
    if (!target.covers(ray.direction)) continue;
    const double share = share_of_lobes(arrival.lights.density, 1.0 / target.solid_angle);
    if (!(share > 0.0)) continue;
    const Spectrum disc = arrival.at_sensor
                              ? target.outside * air.disc_transmittance(ray.origin, ray.direction)
                              : target.radiance;
    sum.add_product(arrival.factor, disc, share * arrival.direct_share);
  }
}

void GenericSolver::add_lamp_surface(const Ray& ray, const Hit& hit, const Arrival& arrival,
                                     SpectrumSum& sum) const {
  const auto lamp = scene_->lamps().radiance(ray, hit);
  if (!lamp) return;
  const LightsAlong& from = arrival.lights;
  double other = 0.0;
  if (from.density > 0.0) {
    other = from.lamp_draws * scene_->lamps().pdf(from.origin, from.normal, ray, hit);
  }
  sum.add_product(arrival.factor, *lamp,
                  share_of_lobes(from.density, other) * arrival.direct_share);
}

/// Of a light that a lobe's sample meets, beside the rays that are sent to it with the density
/// `other`: without shadows those, which nothing stops, bring all of it.
double GenericSolver::share_of_lobes(double density, double other) const noexcept {
  if (!(density > 0.0)) return 1.0;
  return scene_->shadows() || !(other > 0.0) ? density / (density + other) : 0.0;
}

}  // namespace nadir::radiometry
