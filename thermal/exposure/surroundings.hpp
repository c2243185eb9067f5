#pragma once

#include "core/sampler.hpp"
#include "thermal/exposure/exposure.hpp"

// Private to this folder.

namespace nadir::thermal {

/// The sun at a moment.
struct SunThen {
  Vec3 direction;  ///< to the disc's centre
  double sin_radius = 0.0;
  std::uint32_t epoch = geometry::at_the_picture;
};

/// The cosine of incidence of the disc's centre where a point of the disc, drawn by `u`, is seen;
/// 0 where it is hidden, or the centre is below the horizon or the surface's own plane. Counts the
/// ray if there was one.
[[nodiscard]] double sun_cosine_at(const geometry::Scene& scene, const geometry::Hit& place,
                                   const SunThen& sun, Vec2 u, std::uint64_t& rays);

/// Where the sun is at the moments of the patches: between those of the track, as the crow flies;
/// the epoch is that of the nearest.
void find_patch_moments(const SunTrack& track, double interval_s, ExposureScratch& scratch);

/// What rays that looked about have met.
struct LookedAbout {
  const geometry::Scene* scene = nullptr;
  const SunTrack* track = nullptr;
  const ExposureSettings* settings = nullptr;
  Sampler numbers{0, 0};
  std::uint32_t ground_about = 0;  ///< rays that went down and met nothing
};

/// Turns what was met (scratch.met) into patches of seen.
void add_patches(const LookedAbout& looked, Exposure& result, SurroundingsSeen& seen);

}  // namespace nadir::thermal
