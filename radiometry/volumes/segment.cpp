#include <algorithm>

#include "radiometry/volumes/bound_volumes.hpp"
#include "radiometry/volumes/chance.hpp"
#include "radiometry/volumes/passage.hpp"
#include "radiometry/volumes/walk.hpp"

namespace nadir::radiometry {
namespace {

using spectral::Spectrum;

// Chances that a grid gets at least on a crossing, on average: a thin one is then estimated from
// four places, not seen once in a million rays.
constexpr double least_chances = 4.0;

/// Crosses a whole segment, and keeps one of the places that scatter, in proportion to what each
/// contributes (reservoir sampling; Chao, Biometrika 69, 653 (1982)).
class Crossing {
 public:
  Crossing(const Sampler& numbers, int lanes) noexcept
      : draws_{numbers}, left_{lanes, 1.0F}, emission_{lanes} {}

  void run(Walk& walk) noexcept {
    while (alive_ && walk.next()) cross(walk.step());
  }

  [[nodiscard]] BoundVolumes::Segment result(const geometry::Ray& ray) const noexcept {
    BoundVolumes::Segment segment{left_, emission_.spectrum(), std::nullopt};
    if (kept_.volume == nullptr) return segment;
    segment.event = VolumeEvent{ray.origin + kept_.distance * ray.direction, &kept_.volume->phase,
                                kept_.weight};
    scale_by(segment.event->weight, offered_ / of_kept_);
    return segment;
  }

 private:
  void cross(const Step& step) noexcept {
    const double rate = rate_of(step, least_chances);
    double at = step.begin;
    while (rate > 0.0) {
      if (optical_ < 0.0) optical_ = exponential(draws_.next().x);
      const double next = at + optical_ / rate;
      if (next >= step.end) {
        optical_ = std::max(0.0, optical_ - rate * (step.end - at));
        break;
      }
      cross_constant(step, at, next);
      meet(step, next, rate);
      at = next;
      optical_ = -1.0;
      alive_ = survives(left_, 1.0, draws_);
      if (!alive_) return;
    }
    cross_constant(step, at, step.end);
  }

  void cross_constant(const Step& step, double begin, double end) noexcept {
    if (!step.attenuates) return;
    const Passage passed = passage(step.extinction, end - begin);
    const Spectrum seen = left_ * passed.path;
    emission_.add(seen * step.emission);
    if (step.scatters) {
      const Spectrum share = seen * step.scattering;
      const double sum = total(share);
      if (offer(sum)) {
        kept_ = place_in_constant(step, {begin, end}, left_, share, draws_.next());
      }
    }
    left_ *= passed.transmittance;
  }

  void meet(const Step& step, double distance, double rate) noexcept {
    const Encounter met = encounter(step, distance, left_.count());
    emission_.add(left_ * met.emission, 1.0 / rate);
    const ScattererChoice scatterer = choose_scatterer(step, met, left_, draws_.next().x);
    if (offer(scatterer.total / rate)) {
      kept_ = {distance, scatterer.volume, left_ * scatterer.volume->scattering};
      // density x scattering / rate over the probability of this volume among those there
      scale_by(kept_.weight, scatterer.density / rate * scatterer.total / scatterer.sum);
    }
    for (int lane = 0; lane < left_.count(); ++lane) {
      const auto lost = static_cast<float>(static_cast<double>(met.extinction[lane]) / rate);
      left_[lane] *= std::max(0.0F, 1.0F - lost);
    }
  }

  /// Whether a place of that contribution is to be kept instead of the one before.
  bool offer(double contribution) noexcept {
    if (!(contribution > 0.0)) return false;
    const bool first = offered_ == 0.0;
    offered_ += contribution;
    if (!first && draws_.next().x * offered_ >= contribution) return false;
    of_kept_ = contribution;
    return true;
  }

  Draws draws_;
  Spectrum left_;
  spectral::SpectrumSum emission_;
  Scattered kept_;
  double of_kept_ = 0.0, offered_ = 0.0;  // summed over lanes
  double optical_ = -1.0;                 // to the next chance; below 0: not drawn yet
  bool alive_ = true;
};

}  // namespace

BoundVolumes::Segment BoundVolumes::segment(const geometry::Ray& ray, double distance,
                                            const Sampler& numbers) const noexcept {
  Crossing crossing{numbers, lanes_};
  Walk walk{volumes_, ray, distance};
  crossing.run(walk);
  return crossing.result(ray);
}

}  // namespace nadir::radiometry
