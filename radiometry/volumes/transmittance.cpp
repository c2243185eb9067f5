#include <algorithm>

#include "radiometry/volumes/bound_volumes.hpp"
#include "radiometry/volumes/chance.hpp"
#include "radiometry/volumes/passage.hpp"
#include "spectral/exp_minus.hpp"

namespace nadir::radiometry {
namespace {

using spectral::Spectrum;

/// Transmittance of several volumes is the product of theirs, whether they overlap or not: each
/// is crossed alone. `depth` gathers what is exact, `ratio` what is estimated.
struct Attenuation {
  Spectrum depth, ratio;

  /// The mean over lanes of what is left.
  [[nodiscard]] double mean() const noexcept {
    Spectrum left = ratio;
    for (int lane = 0; lane < left.count(); ++lane) left[lane] *= spectral::exp_minus(depth[lane]);
    return total(left) / left.count();
  }
};

/// Residual ratio tracking through one block.
void cross_block(const BoundVolume& volume, const geometry::Ray& ray,
                 const geometry::Interval& part, const GridField::Range& range, Attenuation& left,
                 Draws& draws) noexcept {
  left.depth.add_scaled(volume.extinction, static_cast<float>(static_cast<double>(range.lo) *
                                                              (part.end - part.begin)));
  const float span = range.hi - range.lo;
  const double rate = static_cast<double>(span) * static_cast<double>(volume.max_extinction);
  if (rate <= 0.0) return;
  double at = part.begin;
  while ((at += exponential(draws.next().x) / rate) < part.end) {
    const Vec3 place = volume.region.to_own_axes(ray.origin + at * ray.direction);
    const float above = std::clamp(volume.density_at(place) - range.lo, 0.0F, span);
    const auto met = static_cast<float>(static_cast<double>(above) / rate);
    for (int lane = 0; lane < left.ratio.count(); ++lane) {
      left.ratio[lane] *= std::max(0.0F, 1.0F - met * volume.extinction[lane]);
    }
  }
}

/// False where nothing is left: it is then exactly 0.
bool cross_grid(const BoundVolume& volume, const geometry::Ray& ray, const geometry::Interval& part,
                Attenuation& left, Draws& draws) noexcept {
  BlockWalk blocks{volume.blocks(), volume.region.to_own_axes(ray.origin),
                   volume.region.direction_to_own_axes(ray.direction), part.begin};
  double at = part.begin;
  while (at < part.end) {
    while (blocks.leave() <= at) blocks.step();
    const double end = std::min(blocks.leave(), part.end);
    cross_block(volume, ray, {at, end}, blocks.range(), left, draws);
    at = end;
    // Roulette as in `survives`, on all that is left of the ray's light.
    constexpr double small = 1e-3, chance = 0.1;
    if (left.mean() >= small) continue;
    if (draws.next().x >= chance) return false;
    left.ratio *= static_cast<float>(1.0 / chance);
  }
  return true;
}

}  // namespace

Spectrum BoundVolumes::transmittance(const geometry::Ray& ray, double distance,
                                     const Sampler& numbers) const noexcept {
  Attenuation left{Spectrum{lanes_}, Spectrum{lanes_, 1.0F}};
  Draws draws{numbers};
  geometry::Ray whole = ray;
  whole.max_distance = std::min(ray.max_distance, distance);
  for (const BoundVolume& volume : volumes_) {
    const auto part = volume.region.crossing(whole);
    if (!part) continue;
    const GridField::Range range = volume.density ? volume.density->range() : GridField::Range{};
    if (range.lo == range.hi) {
      left.depth.add_scaled(volume.extinction, static_cast<float>(static_cast<double>(range.lo) *
                                                                  (part->end - part->begin)));
    } else if (!cross_grid(volume, whole, *part, left, draws)) {
      return Spectrum{lanes_};
    }
  }
  for (int lane = 0; lane < lanes_; ++lane)
    left.ratio[lane] *= spectral::exp_minus(left.depth[lane]);
  return left.ratio;
}

}  // namespace nadir::radiometry
