#pragma once

#include <cstdint>

namespace nadir::radiometry {

/// What the solver did: rays by kind, and how often each threshold changed a sample's fate.
struct Counters {
  std::uint64_t primary_rays = 0;
  std::uint64_t target_rays = 0;  ///< towards sun or moon
  std::uint64_t lamp_rays = 0;    ///< towards lamps
  std::uint64_t path_rays = 0;    ///< by which walks of the path solver go on
  std::uint64_t full_samples = 0;
  std::uint64_t direct_only_samples = 0;
  std::uint64_t truth_rays = 0;      ///< for the shadow plane
  std::uint64_t volume_events = 0;   ///< scatterings in volumes
  std::uint64_t roulette_stops = 0;  ///< walks that Russian roulette ended
  std::uint64_t current_weight_stops = 0;
  std::uint64_t target_weight_skips = 0;
  std::uint64_t full_weight_downgrades = 0;
  std::uint64_t quick_weight_skips = 0;
  std::uint64_t raw_weight_skips = 0;
  std::uint64_t budget_stops = 0;        ///< hits whose sample budget the targets used up
  std::uint64_t bounce_limit_stops = 0;  ///< hits whose full samples the bounce limit forbade

  Counters& operator+=(const Counters& b) noexcept {
    primary_rays += b.primary_rays;
    target_rays += b.target_rays;
    lamp_rays += b.lamp_rays;
    path_rays += b.path_rays;
    volume_events += b.volume_events;
    roulette_stops += b.roulette_stops;
    full_samples += b.full_samples;
    direct_only_samples += b.direct_only_samples;
    truth_rays += b.truth_rays;
    current_weight_stops += b.current_weight_stops;
    target_weight_skips += b.target_weight_skips;
    full_weight_downgrades += b.full_weight_downgrades;
    quick_weight_skips += b.quick_weight_skips;
    raw_weight_skips += b.raw_weight_skips;
    budget_stops += b.budget_stops;
    bounce_limit_stops += b.bounce_limit_stops;
    return *this;
  }
  [[nodiscard]] std::uint64_t rays() const noexcept {
    return primary_rays + target_rays + lamp_rays + path_rays + full_samples + direct_only_samples +
           truth_rays;
  }
};

}  // namespace nadir::radiometry
