#include "radiometry/path_solver.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "radiometry/visibility.hpp"

namespace nadir::radiometry {

using geometry::Hit;
using geometry::Ray;
using spectral::Spectrum;
using spectral::SpectrumSum;

namespace {

// Purposes of the random numbers at one vertex of a walk.
enum Dimension : std::uint32_t {
  lobe = 0,
  direction = 1,
  roulette = 2,
  technique = 3,
  lamp_choice = 4,
  lamp_place = 5,
  first_target = 16
};
// Children: the next vertex, and the numbers of volumes and maps along the way.
enum Branch : std::uint32_t { next = 0, flight = 1, shadow = 2, split = 3 };

// A walk between surfaces that absorb nothing would never end: from here on it does, on average
// after another 1e7 bounces.
constexpr int endless = 10000;
constexpr double endless_survival = 1.0 - 1e-7;

}  // namespace

struct PathSolver::Walk {
  /// What has turned the light's way: straight passage through a sheet does not.
  enum class Turned : std::uint8_t { not_yet, in_volumes, at_surface };
  Ray ray;
  Spectrum throughput;
  SpectrumSum* radiance;
  Sampler numbers;   // of the present vertex
  Vec3 origin{};     // where the direction was drawn from a density,
  Vec3 normal{};     // the side that could be lit there (0: all),
  double pdf = 0.0;  // and that density, sr^-1; 0: lights are seen in no other way
  int bounces = 0;
  Turned turned = Turned::not_yet;
};

/// A direction in which a walk goes on.
struct PathSolver::Draw {
  Vec3 direction;         // scene axes
  Spectrum weight;        // f |cos| / pdf
  double pdf = 0.0;       // 0: from a delta
  bool straight = false;  // through a sheet: as if nothing had been there
};

Spectrum PathSolver::aperture_radiance(const Ray& ray, const std::optional<Hit>& hit,
                                       const Sampler& numbers) {
  ++counters_.primary_rays;
  SpectrumSum radiance{scene_->lanes().count()};
  Walk walk{ray, Spectrum{scene_->lanes().count(), 1.0F}, &radiance, numbers};
  if (hit) {
    const atmosphere::PathTerms path = scene_->air().path(ray.origin, ray.direction, hit->distance);
    radiance.add(path.radiance);
    walk.throughput = path.transmittance;
  }
  const double distance = hit ? hit->distance : std::numeric_limits<double>::infinity();
  const BoundVolumes& volumes = scene_->volumes();
  if (!volumes.empty() && volumes.crossed(ray, distance)) {
    // What the sensor sees first deserves both: the volume's own light and what is behind it.
    const BoundVolumes::Segment segment =
        volumes.segment(ray, distance, numbers.child(Branch::flight));
    radiance.add(segment.emission * walk.throughput);
    if (segment.event) {
      Walk side{ray, walk.throughput * segment.event->weight, &radiance,
                numbers.child(Branch::split)};
      if (scatter_in_volume(side, *segment.event)) follow(side);
    }
    walk.throughput *= segment.transmittance;
  }
  if (arrive(walk, hit)) follow(walk);
  return radiance.spectrum();
}

void PathSolver::follow(Walk& walk) {
  for (;;) {
    ++counters_.path_rays;
    const auto hit = scene_->intersect(walk.ray, walk.numbers);
    const double distance = hit ? hit->distance : std::numeric_limits<double>::infinity();
    const Flight flight = fly(walk, distance);
    if (flight == Flight::ends) return;
    if (flight == Flight::arrives && !arrive(walk, hit)) return;
  }
}

PathSolver::Flight PathSolver::fly(Walk& walk, double distance) {
  const BoundVolumes& volumes = scene_->volumes();
  if (volumes.empty() || !volumes.crossed(walk.ray, distance)) return Flight::arrives;
  const auto event = volumes.fly(walk.ray, distance, walk.numbers.child(Branch::flight),
                                 walk.throughput, *walk.radiance);
  if (!(walk.throughput.max() > 0.0F)) return Flight::ends;
  if (!event) return Flight::arrives;
  return scatter_in_volume(walk, *event) ? Flight::scatters : Flight::ends;
}

bool PathSolver::arrive(Walk& walk, const std::optional<Hit>& hit) {
  if (!hit) {
    add_sky(walk);
    return false;
  }
  const SurfacePoint point{*scene_, walk.ray, *hit};
  add_emission(walk, point);
  if (may_reflect(walk)) {
    add_surface_lights(walk, point);
  } else if (!point.material().traits.straight) {
    return false;
  }
  return bounce(walk, point);
}

/// Without interreflection light is turned once: at one surface, or by volumes alone.
bool PathSolver::may_reflect(const Walk& walk) const noexcept {
  return scene_->interreflects() || walk.turned == Walk::Turned::not_yet;
}

void PathSolver::add_sky(Walk& walk) const {
  const Vec3 towards = walk.ray.direction;
  const atmosphere::BoundAtmosphere& air = scene_->air();
  // Only the sensor's own ray has the sensor's air before it.
  const Vec3 eye = walk.ray.origin;
  const bool at_sensor = walk.bounces == 0;
  const Spectrum sky = at_sensor ? air.beyond(eye, towards) : air.sky(towards);
  walk.radiance->add(sky * walk.throughput);
  for (const Target& target : scene_->targets()) {
    if (!target.covers(towards)) continue;
    // Balance heuristic against the ray that is sent to every disc.
    const double share = share_of_walk(walk, 1.0 / target.solid_angle);
    if (!(share > 0.0)) continue;
    const Spectrum disc =
        at_sensor ? target.outside * air.disc_transmittance(eye, towards) : target.radiance;
    walk.radiance->add(disc * walk.throughput, share);
  }
}

void PathSolver::add_emission(Walk& walk, const SurfacePoint& point) const {
  if (scene_->emits()) {
    Spectrum scratch;
    if (const Spectrum* even = scene_->even_emission(point.hit(), scratch)) {
      walk.radiance->add(*even * walk.throughput);
    } else {
      walk.radiance->add(emission(*scene_, point) * walk.throughput);
    }
  }
  if (scene_->lamps().empty()) return;
  const auto lamp = scene_->lamps().radiance(walk.ray, point.hit());
  if (!lamp) return;
  double other = 0.0;
  if (walk.pdf > 0.0) {
    other = scene_->lamps().pdf(walk.origin, walk.normal, walk.ray, point.hit());
  }
  walk.radiance->add(*lamp * walk.throughput, share_of_walk(walk, other));
}

/// Of a light that a walk meets, beside the ray that was sent to it with the density `other`:
/// without shadows that ray, which nothing stops, brings all of it.
double PathSolver::share_of_walk(const Walk& walk, double other) const noexcept {
  if (!(walk.pdf > 0.0)) return 1.0;
  return scene_->shadows() || !(other > 0.0) ? walk.pdf / (walk.pdf + other) : 0.0;
}

/// @param scatter  what turns light at this vertex: `value(direction, f)` writes f |cos| per lane
///                 and returns the density of going on that way, or a negative number where no
///                 light can come from; `ray(direction)`, `position()`, `normal()`
template <class Scatter>
void PathSolver::add_lights(const Walk& walk, const Scatter& scatter) {
  const bool shadows = scene_->shadows();
  Spectrum light{scene_->lanes().count()};
  for (const Target& target : scene_->targets()) {
    const std::uint32_t number = first_target + target.number;
    const Vec3 towards = direction_in_disc(target, walk.numbers.point(number));
    const Sampler numbers = walk.numbers.child(Branch::shadow + number);
    if (towards.z <= 0.0) continue;  // set behind the horizon
    const double pdf = scatter.value(towards, light);
    if (pdf < 0.0) continue;
    light *= target.irradiance;
    if (shadows) {
      ++counters_.target_rays;
      if (!passes(*scene_, scatter.ray(towards), numbers, light)) continue;
    }
    light *= walk.throughput;
    walk.radiance->add(light, shadows ? 1.0 / (1.0 + pdf * target.solid_angle) : 1.0);
  }
  if (scene_->lamps().empty()) return;
  const auto lamp = scene_->lamps().sample(scatter.position(), scatter.normal(),
                                           walk.numbers.number(Dimension::lamp_choice),
                                           walk.numbers.point(Dimension::lamp_place));
  if (!lamp) return;
  const double pdf = scatter.value(lamp->direction, light);
  if (pdf < 0.0) return;
  light *= lamp->irradiance;
  if (shadows) {
    ++counters_.lamp_rays;
    const Ray ray = ray_to_lamp(scatter.ray(lamp->direction).origin, scatter.position(), *lamp);
    if (!passes(*scene_, ray, walk.numbers.child(Branch::shadow), light)) return;
  }
  light *= walk.throughput;
  walk.radiance->add(light, shadows && lamp->pdf > 0.0 ? lamp->pdf / (lamp->pdf + pdf) : 1.0);
}

namespace {

/// Density of a direction under the mixture of scattering function and sky.
double mixed_pdf(const SkyDistribution& sky, double surface_pdf, Vec3 towards) {
  if (sky.empty()) return surface_pdf;
  return (1.0 - sky.share()) * surface_pdf + sky.share() * sky.pdf(towards);
}

struct SurfaceScatter {
  const LitScene& scene;
  const SurfacePoint& point;

  double value(Vec3 towards, Spectrum& f) const {
    if (!point.scattered(towards, f)) return -1.0;
    return mixed_pdf(scene.sky_distribution(), point.pdf(towards), towards);
  }
  [[nodiscard]] Ray ray(Vec3 towards) const { return point.leaving(towards); }
  [[nodiscard]] Vec3 position() const { return point.hit().position; }
  [[nodiscard]] Vec3 normal() const { return point.lit_normal(); }
};

struct VolumeScatter {
  const VolumeEvent& event;
  Vec3 wo;

  double value(Vec3 towards, Spectrum& f) const {
    f = event.phase->eval(towards, wo);
    return event.phase->pdf(towards, wo);
  }
  [[nodiscard]] Ray ray(Vec3 towards) const { return {event.position, towards}; }
  [[nodiscard]] Vec3 position() const { return event.position; }
  [[nodiscard]] static Vec3 normal() { return {}; }
};

}  // namespace

void PathSolver::add_surface_lights(const Walk& walk, const SurfacePoint& point) {
  if (point.material().traits.only_delta) return;  // no direction of a light is among its own
  add_lights(walk, SurfaceScatter{*scene_, point});
}

std::optional<PathSolver::Draw> PathSolver::draw_to_sky(const SurfacePoint& point, Vec2 u) const {
  const SkyDistribution& sky = scene_->sky_distribution();
  Draw drawn{sky.sample(u), Spectrum{scene_->lanes().count()}};
  if (!point.scattered(drawn.direction, drawn.weight)) return std::nullopt;
  drawn.pdf = mixed_pdf(sky, point.pdf(drawn.direction), drawn.direction);
  drawn.weight *= static_cast<float>(1.0 / drawn.pdf);
  return drawn;
}

std::optional<PathSolver::Draw> PathSolver::draw(const Walk& walk,
                                                 const SurfacePoint& point) const {
  const materials::ScatteringTraits& traits = point.material().traits;
  const SkyDistribution& sky = scene_->sky_distribution();
  const bool shared = !sky.empty() && !traits.only_delta;  // with directions to the sky
  const Vec2 u = walk.numbers.point(Dimension::direction);
  if (shared && walk.numbers.number(Dimension::technique) < sky.share()) {
    return draw_to_sky(point, u);
  }
  const auto drawn = materials::sample(point.material().scattering, point.wo(),
                                       {walk.numbers.number(Dimension::lobe), u});
  if (!drawn) return std::nullopt;
  Draw result{point.outgoing(drawn->wi), drawn->weight};
  if (drawn->delta) {
    result.straight = traits.straight && dot(drawn->wi, point.wo()) < -(1.0 - 1e-12);
    if (shared) result.weight *= static_cast<float>(1.0 / (1.0 - sky.share()));
    return result;
  }
  const double own = point.folds() ? point.pdf(result.direction) : drawn->pdf;
  result.pdf = shared ? mixed_pdf(sky, own, result.direction) : own;
  // The weight of what was drawn belongs to the density that it was drawn with, folded or not.
  if (shared) result.weight *= static_cast<float>(own / result.pdf);
  return result;
}

bool PathSolver::bounce(Walk& walk, const SurfacePoint& point) {
  const int limit = scene_->description().path_max_bounces;
  if (limit > 0 && walk.bounces >= limit) {
    ++counters_.bounce_limit_stops;
    return false;
  }
  const auto drawn = draw(walk, point);
  if (!drawn) return false;
  if (!drawn->straight && !may_reflect(walk)) return false;
  walk.throughput *= drawn->weight;
  walk.ray = point.leaving(drawn->direction);
  if (!drawn->straight) {
    walk.turned = Walk::Turned::at_surface;
    walk.origin = point.hit().position;
    walk.normal = point.lit_normal();
    walk.pdf = drawn->pdf;
  }
  return survives(walk);
}

bool PathSolver::scatter_in_volume(Walk& walk, const VolumeEvent& event) {
  const int limit = scene_->description().path_max_bounces;
  if (walk.turned == Walk::Turned::at_surface && !scene_->interreflects()) return false;
  walk.turned = Walk::Turned::in_volumes;
  const Vec3 wo = -walk.ray.direction;
  add_lights(walk, VolumeScatter{event, wo});
  if (limit > 0 && walk.bounces >= limit) {
    ++counters_.bounce_limit_stops;
    return false;
  }
  ++counters_.volume_events;
  const materials::PhaseSample drawn = event.phase->sample(
      wo, walk.numbers.number(Dimension::lobe), walk.numbers.point(Dimension::direction));
  walk.throughput *= drawn.weight;
  walk.ray = {event.position, drawn.direction};
  walk.origin = event.position;
  walk.normal = {};
  walk.pdf = drawn.pdf;
  return survives(walk);
}

bool PathSolver::survives(Walk& walk) {
  // The first ray that leaves is never given up: most of what a pixel sees arrives by it.
  const int bounces = walk.bounces++;
  const double strength = static_cast<double>(walk.throughput.mean());
  if (!(strength > 0.0)) return false;
  if (bounces > 0) {
    double chance = std::min(strength, bounces < endless ? 1.0 : endless_survival);
    // Rounding and tables may return a trifle more than came: it must not add up over 1e7 bounces.
    if (bounces >= endless && strength > 1.0) chance *= strength;
    if (walk.numbers.number(Dimension::roulette) >= chance) {
      ++counters_.roulette_stops;
      return false;
    }
    walk.throughput *= static_cast<float>(1.0 / chance);
  }
  walk.numbers = walk.numbers.child(Branch::next);
  return true;
}

}  // namespace nadir::radiometry
