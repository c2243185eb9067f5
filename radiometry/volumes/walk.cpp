#include "radiometry/volumes/walk.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace nadir::radiometry {

Walk::Walk(const std::vector<BoundVolume>& volumes, const geometry::Ray& ray,
           double distance) noexcept
    : volumes_{&volumes}, ray_{ray} {
  ray_.max_distance = std::min(ray.max_distance, distance);
  fill();
}

/// Takes the next crossings in the order of their beginnings. The window ends where the first
/// that found no room begins: no more of them overlap than there is room for, so that a
/// full window always gets ahead.
void Walk::fill() noexcept {
  count_ = 0;
  window_end_ = ray_.max_distance;
  for (const BoundVolume& volume : *volumes_) {
    const auto part = volume.region.crossing(ray_);
    if (part && part->end > position_) insert(volume, *part);
  }
  for (int i = 0; i < count_; ++i) prepare(crossings_[static_cast<std::size_t>(i)]);
}

void Walk::insert(const BoundVolume& volume, const geometry::Interval& part) noexcept {
  auto* const begin = crossings_.data();
  if (count_ == most_overlapping) {
    Crossing& last = begin[count_ - 1];
    window_end_ = std::min(window_end_, std::max(part.begin, last.part.begin));
    if (part.begin >= last.part.begin) return;
    --count_;
  }
  auto* at = begin + count_;
  for (; at != begin && (at - 1)->part.begin > part.begin; --at) {
    at->volume = (at - 1)->volume;
    at->part = (at - 1)->part;
  }
  at->volume = &volume;
  at->part = part;
  ++count_;
}

void Walk::prepare(Crossing& crossing) noexcept {
  const BoundVolume& volume = *crossing.volume;
  if (!volume.density && !volume.temperature) {
    crossing.blocks = BlockWalk{};
    return;
  }
  crossing.origin = volume.region.to_own_axes(ray_.origin);
  crossing.direction = volume.region.direction_to_own_axes(ray_.direction);
  crossing.blocks = BlockWalk{volume.blocks(), crossing.origin, crossing.direction,
                              std::max(crossing.part.begin, position_)};
}

bool Walk::next() noexcept {
  while (position_ < ray_.max_distance) {
    if (position_ >= window_end_) {
      fill();
      // Should rounding ever make one too many overlap, it is for no more than the last digit.
      window_end_ = std::max(window_end_, std::nextafter(position_, ray_.max_distance));
    }
    gather(position_);
    position_ = step_.end;
    if (step_.count > 0) return true;
  }
  return false;
}

/// The step that begins here: it ends where a volume begins or ends, or a grid's block.
void Walk::gather(double begin) noexcept {
  step_.begin = begin;
  step_.end = window_end_;
  step_.count = 0;
  bool more = false;
  for (int i = 0; i < count_; ++i) {
    Crossing& crossing = crossings_[static_cast<std::size_t>(i)];
    if (crossing.part.end <= begin) continue;
    more = true;
    if (crossing.part.begin > begin) {
      step_.end = std::min(step_.end, crossing.part.begin);
      continue;
    }
    while (crossing.blocks.leave() <= begin) crossing.blocks.step();
    step_.end = std::min({step_.end, crossing.part.end, crossing.blocks.leave()});
    add(crossing);
  }
  if (!more) step_.end = window_end_;  // nothing behind this place: be done
}

void Walk::add(const Crossing& crossing) noexcept {
  const BoundVolume& volume = *crossing.volume;
  const GridField::Range range = crossing.blocks.range();
  const float span = range.hi - range.lo;
  if (step_.count == 0) {
    const int lanes = volume.extinction.count();
    step_.extinction = step_.scattering = step_.emission = spectral::Spectrum{lanes};
    step_.scatters = step_.emits = step_.attenuates = false;
    step_.majorant = step_.chances = 0.0;
  }
  const double length = crossing.part.end - crossing.part.begin;
  step_.active[static_cast<std::size_t>(step_.count++)] = {
      &volume, crossing.origin, crossing.direction, length, range.lo, span};
  if (range.lo > 0.0F) {
    step_.extinction.add_scaled(volume.extinction, range.lo);
    step_.scattering.add_scaled(volume.scattering, range.lo);
    step_.emission.add_scaled(volume.emission, range.lo);
    step_.attenuates = true;
    step_.scatters = step_.scatters || volume.scatters;
  }
  // Emission at a temperature that changes from place to place is met by chance altogether.
  const bool glows = volume.planck.has_value();
  const float bound = glows ? range.hi : span;
  if (bound <= 0.0F) return;
  step_.majorant += static_cast<double>(bound) * static_cast<double>(volume.max_extinction);
  step_.chances += 1.0 / length;
}

}  // namespace nadir::radiometry
