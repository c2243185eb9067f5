#include "thermal/exposure/exposure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/frame.hpp"
#include "core/random.hpp"
#include "thermal/exposure/surroundings.hpp"

namespace nadir::thermal {
namespace {

/// What random numbers are drawn for. Every epoch's rays are the same ones: between epochs only
/// what has come or gone makes a difference.
enum Draw : std::uint32_t { sun_from = 0, sun_disc = 1, look_from = 2, look_along = 3 };
constexpr std::uint64_t for_patches = 0x7061746368657321ULL;

/// By cosine about a unit normal. Malley's method: a uniform point of the disc, raised.
Vec3 about_by_cosine(Vec3 normal, Vec2 u) {
  const double r = std::sqrt(u.x), turn = 2.0 * std::numbers::pi * u.y;
  return frame_about(normal).to_world(
      {r * std::cos(turn), r * std::sin(turn), std::sqrt(1.0 - u.x)});
}

void find_epochs(const SunTrack& track, std::vector<std::uint32_t>& epochs) {
  epochs.clear();
  for (const std::uint32_t epoch : track.epoch) {
    if (!epochs.empty() && epochs.back() == epoch) continue;
    if (std::find(epochs.begin(), epochs.end(), epoch) == epochs.end()) epochs.push_back(epoch);
  }
}

void look_for_sun(const LookedAbout& looked, const SurfaceCell& cell, std::uint64_t key,
                  Exposure& result) {
  const SunTrack& track = *looked.track;
  result.sun_cosine.clear();
  for (std::uint32_t i = 0; i < track.direction.size(); ++i) {
    const SunThen sun{track.direction[i], track.sin_radius, track.epoch[i]};
    double cosine = 0.0;
    if (sun.direction.z > 0.0) {
      const Sampler numbers{key, i};
      const geometry::Hit place = cell.place(numbers.point(sun_from));
      if (dot(place.normal, sun.direction) > 0.0) {
        cosine = sun_cosine_at(*looked.scene, place, sun, numbers.point(sun_disc), result.rays);
      }
    }
    result.sun_cosine.push_back(static_cast<float>(cosine));
  }
}

/// Patches and epochs of the last call join the spare ones, with their memory.
void put_by(Exposure& result) {
  ExposureScratch& scratch = result.scratch;
  for (SurroundingsSeen& seen : result.seen) {
    for (SurroundingPatch& patch : seen.patches) scratch.spare_patches.push_back(std::move(patch));
    seen.patches.clear();
    scratch.spare_seen.push_back(std::move(seen));
  }
  result.seen.clear();
}

SurroundingsSeen& new_seen(Exposure& result) {
  auto& spare = result.scratch.spare_seen;
  if (spare.empty()) return result.seen.emplace_back();
  result.seen.push_back(std::move(spare.back()));
  spare.pop_back();
  return result.seen.back();
}

void look_about(const SurfaceCell& cell, std::uint32_t epoch, LookedAbout looked, std::uint64_t key,
                Exposure& result) {
  ExposureScratch& scratch = result.scratch;
  scratch.met.clear();
  scratch.bearing.clear();
  std::uint32_t sky = 0;
  const auto rays = static_cast<std::uint32_t>(looked.settings->sky_rays);
  for (std::uint32_t i = 0; i < rays; ++i) {
    const Sampler numbers{key, i};
    const geometry::Hit place = cell.place(numbers.point(look_from));
    const Vec3 along = about_by_cosine(place.normal, numbers.point(look_along));
    geometry::Ray ray{geometry::leaving_origin(place, along), along};
    ray.epochs = epoch;
    if (const auto hit = looked.scene->intersect(ray)) {
      scratch.met.push_back(*hit);
      scratch.bearing.push_back(std::atan2(along.y, along.x));
    } else if (along.z > 0.0) {
      ++sky;
    } else {
      ++looked.ground_about;
    }
  }
  result.rays += rays;
  SurroundingsSeen& seen = new_seen(result);
  seen.sky_fraction = static_cast<double>(sky) / rays;
  add_patches(looked, result, seen);
}

}  // namespace

void expose(const geometry::Scene& scene, const SurfaceCell& cell, const SunTrack& track,
            const ExposureSettings& settings, std::uint64_t seed, Exposure& result) {
  const std::uint64_t key = mix(cell.key(), seed);
  result.rays = 0;
  put_by(result);
  find_epochs(track, result.epochs);
  find_patch_moments(track, settings.surroundings_interval_s, result.scratch);
  const LookedAbout looked{&scene, &track, &settings, Sampler{key ^ for_patches, 0}, 0};
  look_for_sun(looked, cell, key, result);
  for (const std::uint32_t epoch : result.epochs) look_about(cell, epoch, looked, key, result);
}

}  // namespace nadir::thermal
