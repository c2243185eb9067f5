#include "radiometry/lamps/bound_lamps.hpp"

#include <algorithm>
#include <cmath>

#include "radiometry/lamps/lamp_binder.hpp"

namespace nadir::radiometry {

BoundLamps::BoundLamps(const std::vector<Lamp>& lamps, const spectral::Lanes& lanes) {
  Binder binder{*this, lanes};
  for (const Lamp& lamp : lamps) binder.add(lamp);
  binder.finish();
}

std::optional<LampSample> BoundLamps::from_point(const Emitter& emitter,
                                                 Vec3 position) const noexcept {
  const Point& lamp = points_[emitter.index];
  const Vec3 away = position - lamp.position;
  const double distance = length(away);
  if (!(distance > 0.0)) return std::nullopt;  // no direction
  const Vec3 direction = away / distance;
  const double intensity =
      emitter.factor * shapes_[lamp.shape]({dot(direction, lamp.side), dot(direction, lamp.across),
                                            dot(direction, lamp.axis)});
  if (!(intensity > 0.0)) return std::nullopt;
  const double d = std::max(distance, PointLamp::nearest_m);
  return LampSample{-direction, distance,
                    spectra_[emitter.spectrum] * static_cast<float>(intensity / (d * d)), 0.0};
}

std::optional<LampSample> BoundLamps::from_surface(const Emitter& emitter, Vec3 position,
                                                   Vec2 u) const noexcept {
  const auto place = surfaces_[emitter.index].sample(position, u);
  if (!place) return std::nullopt;
  return LampSample{place->direction, place->distance,
                    spectra_[emitter.spectrum] * static_cast<float>(emitter.factor / place->pdf),
                    place->pdf};
}

std::optional<LampSample> BoundLamps::sample_of(std::uint32_t lamp, Vec3 position,
                                                Vec2 u) const noexcept {
  const Emitter& emitter = emitters_[lamp];
  return emitter.is_point ? from_point(emitter, position) : from_surface(emitter, position, u);
}

std::optional<LampSample> BoundLamps::sample(Vec3 position, Vec3 normal, double choice,
                                             Vec2 u) const noexcept {
  const auto drawn = tree_.draw(position, normal, choice);
  if (!drawn) return std::nullopt;
  auto sample = sample_of(drawn->item, position, u);
  if (sample) {
    sample->irradiance *= static_cast<float>(1.0 / drawn->probability);
    sample->pdf *= drawn->probability;
  }
  return sample;
}

std::optional<spectral::Spectrum> BoundLamps::radiance(const geometry::Ray& ray,
                                                       const geometry::Hit& hit) const noexcept {
  const std::uint32_t lamp = lamp_at(hit);
  if (lamp == none) return std::nullopt;
  const Emitter& emitter = emitters_[lamp];
  const bool front = surfaces_[emitter.index].seen_from_front(ray.direction, hit.position);
  return spectra_[emitter.spectrum] * static_cast<float>(front ? emitter.factor : 0.0);
}

double BoundLamps::pdf(Vec3 position, Vec3 normal, const geometry::Ray& ray,
                       const geometry::Hit& hit) const noexcept {
  const std::uint32_t lamp = lamp_at(hit);
  if (lamp == none) return 0.0;
  const EmittingSurface& surface = surfaces_[emitters_[lamp].index];
  if (!surface.seen_from_front(ray.direction, hit.position)) return 0.0;
  const double of_place = surface.pdf(position, ray.direction, hit.position);
  return of_place > 0.0 ? of_place * tree_.probability(lamp, position, normal) : 0.0;
}

}  // namespace nadir::radiometry
