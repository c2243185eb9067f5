#include <algorithm>

#include "radiometry/volumes/bound_volumes.hpp"
#include "radiometry/volumes/chance.hpp"
#include "radiometry/volumes/passage.hpp"
#include "radiometry/volumes/walk.hpp"

namespace nadir::radiometry {
namespace {

using spectral::Spectrum;

// Chances that a grid gets at least on a crossing, on average, to add its emission.
constexpr double least_chances = 1.0;

/// One journey of a path.
class Flight {
 public:
  Flight(const geometry::Ray& ray, const Sampler& numbers, Spectrum& throughput,
         spectral::SpectrumSum& radiance) noexcept
      : ray_{&ray},
        draws_{numbers},
        throughput_{&throughput},
        radiance_{&radiance},
        mean_at_start_{static_cast<double>(throughput.mean())} {}

  std::optional<VolumeEvent> run(Walk& walk) noexcept {
    while (walk.next()) {
      if (auto event = cross(walk.step())) return event;
      if (throughput_->max() <= 0.0F) break;
    }
    return std::nullopt;
  }

 private:
  /// The constant part up to each chance, then the chance.
  std::optional<VolumeEvent> cross(const Step& step) noexcept {
    const double rate = rate_of(step, least_chances);
    double at = step.begin;
    while (rate > 0.0) {
      if (optical_ < 0.0) optical_ = exponential(draws_.next().x);
      const double next = at + optical_ / rate;
      if (next >= step.end) {
        optical_ -= rate * (step.end - at);
        optical_ = std::max(optical_, 0.0);
        break;
      }
      if (auto event = cross_constant(step, at, next)) return event;
      if (auto event = meet(step, next, rate)) return event;
      if (!survives(*throughput_, mean_at_start_, draws_)) return std::nullopt;
      at = next;
      optical_ = -1.0;
    }
    return cross_constant(step, at, step.end);
  }

  std::optional<VolumeEvent> cross_constant(const Step& step, double begin, double end) noexcept {
    if (!step.attenuates) return std::nullopt;
    const Passage passed = passage(step.extinction, end - begin);
    const Spectrum seen = *throughput_ * passed.path;
    radiance_->add(seen * step.emission);
    const Spectrum kept = *throughput_ * passed.transmittance;
    if (!step.scatters) {
      *throughput_ = kept;
      return std::nullopt;
    }
    const Spectrum share = seen * step.scattering;
    const double of_share = total(share), of_kept = total(kept), all = of_share + of_kept;
    const Vec2 u = draws_.next();
    if (u.x * all < of_share) {
      const Vec2 place{std::min(u.x * all / of_share, 0x1.fffffffffffffp-1), u.y};
      const Scattered scattered = place_in_constant(step, {begin, end}, *throughput_, share, place);
      return arrive(scattered, all / of_share);
    }
    *throughput_ = kept;
    scale_by(*throughput_, of_kept > 0.0 ? all / of_kept : 0.0);
    return std::nullopt;
  }

  /// Either what is met there scatters, or the path goes on with what is left.
  std::optional<VolumeEvent> meet(const Step& step, double distance, double rate) noexcept {
    const Encounter met = encounter(step, distance, throughput_->count());
    radiance_->add(*throughput_ * met.emission, 1.0 / rate);
    Spectrum kept = *throughput_;
    for (int lane = 0; lane < kept.count(); ++lane) {
      const auto lost = static_cast<float>(static_cast<double>(met.extinction[lane]) / rate);
      kept[lane] *= std::max(0.0F, 1.0F - lost);
    }
    const Vec2 u = draws_.next();
    const ScattererChoice scatterer = choose_scatterer(step, met, *throughput_, u.y);
    const double of_share = scatterer.total / rate, of_kept = total(kept);
    const double all = of_share + of_kept;
    if (scatterer.volume != nullptr && u.x * all < of_share) {
      Scattered scattered{distance, scatterer.volume, *throughput_ * scatterer.volume->scattering};
      // density x scattering / rate over the probability of this volume
      scale_by(scattered.weight, scatterer.density * all / scatterer.sum);
      return arrive(scattered, 1.0);
    }
    *throughput_ = kept;
    scale_by(*throughput_, of_kept > 0.0 ? all / of_kept : 0.0);
    return std::nullopt;
  }

  std::optional<VolumeEvent> arrive(const Scattered& scattered, double factor) noexcept {
    *throughput_ = scattered.weight;
    scale_by(*throughput_, factor);
    return VolumeEvent{ray_->origin + scattered.distance * ray_->direction,
                       &scattered.volume->phase, Spectrum{throughput_->count(), 1.0F}};
  }

  const geometry::Ray* ray_;
  Draws draws_;
  Spectrum* throughput_;
  spectral::SpectrumSum* radiance_;
  double mean_at_start_;
  double optical_ = -1.0;  // to the next chance; below 0: not drawn yet
};

}  // namespace

std::optional<VolumeEvent> BoundVolumes::fly(const geometry::Ray& ray, double distance,
                                             const Sampler& numbers, Spectrum& throughput,
                                             spectral::SpectrumSum& radiance) const noexcept {
  if (volumes_.empty() || throughput.max() <= 0.0F) return std::nullopt;
  Walk walk{volumes_, ray, distance};
  return Flight{ray, numbers, throughput, radiance}.run(walk);
}

}  // namespace nadir::radiometry
