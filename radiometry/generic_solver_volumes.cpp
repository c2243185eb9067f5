// Volumes in the generic solver: light is scattered once in every segment that crosses them.

#include "radiometry/generic_solver_state.hpp"
#include "radiometry/thresholds.hpp"
#include "radiometry/visibility.hpp"

namespace nadir::radiometry {

using namespace generic;  // NOLINT(google-build-using-namespace): names of this folder alone
using geometry::Ray;
using spectral::Spectrum;
using spectral::SpectrumSum;

void GenericSolver::cross_volumes(const Ray& ray, double distance, Arrival& arrival,
                                  const Sampler& numbers, SpectrumSum& sum) {
  const BoundVolumes::Segment segment =
      scene_->volumes().segment(ray, distance, numbers.child(Dimension::flight));
  sum.add_product(arrival.factor, segment.emission, arrival.direct_share);
  if (arrival.kind == Kind::full && segment.event) {
    const Spectrum light =
        scattered_in_volume(ray, *segment.event, arrival, numbers.child(Dimension::in_scatter));
    sum.add_product(arrival.factor * segment.event->weight, light, arrival.scattered_share);
  }
  arrival.factor *= segment.transmittance;
}

Spectrum GenericSolver::scattered_in_volume(const Ray& ray, const VolumeEvent& event,
                                            const Arrival& arrival, const Sampler& numbers) {
  ++counters_.volume_events;
  SpectrumSum sum{scene_->lanes().count()};
  const Vec3 wo = -ray.direction;
  const double weight = arrival.weight * largest(event.weight);
  if (weight < thresholds::current_weight) {
    ++counters_.current_weight_stops;
    return sum.spectrum();
  }
  add_volume_lights(event, wo, numbers, sum);
  const materials::PhaseSample drawn = event.phase->sample(
      wo, numbers.number(Dimension::allocation), numbers.point(Dimension::phase));
  const bool full = arrival.generation < scene_->description().solver.max_bounces;
  if (!full) ++counters_.bounce_limit_stops;
  const double strongest = largest(drawn.weight);
  const Kind kind = admitted(Sample{drawn.weight, strongest, weight * strongest}, full);
  if (kind == Kind::none) return sum.spectrum();
  Arrival next{drawn.weight, 1.0, 1.0, kind, weight * strongest, arrival.generation + 1};
  next.of_volume = true;
  gather({event.position, drawn.direction}, next, numbers.child(0), sum);
  return sum.spectrum();
}

void GenericSolver::add_volume_lights(const VolumeEvent& event, Vec3 wo, const Sampler& numbers,
                                      SpectrumSum& sum) {
  for (const Target& target : scene_->targets()) {
    const std::uint32_t number = first_target + target.number;
    const Sampler shadow = numbers.child(number);
    const Vec3 towards = direction_in_disc(target, numbers.point(number));
    if (towards.z <= 0.0) continue;
    if (scene_->shadows()) ++counters_.target_rays;
    Spectrum light = event.phase->eval(towards, wo) * target.irradiance;
    if (passes(*scene_, {event.position, towards}, shadow, light)) sum.add(light);
  }
  if (scene_->lamps().empty()) return;
  const auto lamp =
      scene_->lamps().sample(event.position, {}, numbers.number(Dimension::lamp_choice),
                             numbers.point(Dimension::lamp_place));
  if (!lamp) return;
  if (scene_->shadows()) ++counters_.lamp_rays;
  Spectrum light = event.phase->eval(lamp->direction, wo) * lamp->irradiance;
  const Ray ray = ray_to_lamp(event.position, event.position, *lamp);
  if (passes(*scene_, ray, numbers.child(Dimension::lamp_choice), light)) sum.add(light);
}

}  // namespace nadir::radiometry
