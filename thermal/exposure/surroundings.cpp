#include "thermal/exposure/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/frame.hpp"
#include "thermal/exposure/lattice.hpp"

namespace nadir::thermal {
namespace {

/// Where less of the hemisphere than this is taken, nothing is followed: in full sun a surface of
/// reflectance 0.3 there gives at most 6 W m^-2, which a shadow would take away.
constexpr double least_followed = 0.02;

/// A moment within this share of an interval counts as within the track.
constexpr double moment_slack = 1e-6;

/// What a patch draws numbers for.
enum Purpose : std::uint32_t { which_one = 0, disc_point = 1 };

std::uint32_t facing_of(Vec3 n) {
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  const double largest = std::max({x, y, z});
  if (largest == z) return n.z > 0.0 ? 4 : 5;
  if (largest == y) return n.y > 0.0 ? 2 : 3;
  return n.x > 0.0 ? 0 : 1;
}

void sort_by_likeness(ExposureScratch& s) {
  s.facing.clear();
  s.order.clear();
  for (const geometry::Hit& hit : s.met) {
    s.order.push_back(static_cast<std::uint32_t>(s.order.size()));
    s.facing.push_back(facing_of(hit.normal));
  }
  std::sort(s.order.begin(), s.order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (s.met[a].material != s.met[b].material) return s.met[a].material < s.met[b].material;
    if (s.facing[a] != s.facing[b]) return s.facing[a] < s.facing[b];
    if (s.bearing[a] != s.bearing[b]) return s.bearing[a] < s.bearing[b];
    return a < b;
  });
}

void find_runs(ExposureScratch& s) {
  s.runs.clear();
  for (std::uint32_t i = 0; i < s.order.size(); ++i) {
    const std::uint32_t material = s.met[s.order[i]].material;
    if (s.runs.empty() || s.met[s.order[s.runs.back().begin]].material != material) {
      s.runs.push_back({i, i, 0});
    }
    s.runs.back().end = i + 1;
  }
}

/// Deals the patches out in proportion to the runs, after Sainte-Lague: each in turn to the run
/// with the greatest size / (2 patches + 1).
void deal_patches(ExposureScratch& s, int patches) {
  for (int i = 0; i < patches; ++i) {
    ExposureScratch::Run* best = nullptr;
    double most = 0.0;
    for (ExposureScratch::Run& run : s.runs) {
      const std::uint32_t size = run.end - run.begin;
      const double claim = static_cast<double>(size) / (2.0 * run.followed + 1.0);
      if (run.followed == size || claim <= most) continue;
      best = &run;
      most = claim;
    }
    if (!best) return;
    ++best->followed;
  }
}

int patches_to_follow(const ExposureSettings& settings, std::size_t met) {
  const double share = static_cast<double>(met) / settings.sky_rays;
  if (share < least_followed || settings.surroundings == 0) return 0;
  const long patches = std::lround(2.0 * settings.surroundings * share);
  return static_cast<int>(std::clamp(patches, 1L, static_cast<long>(settings.surroundings)));
}

/// One more patch, its memory a former one's.
SurroundingPatch& new_patch(SurroundingsSeen& seen, ExposureScratch& scratch) {
  SurroundingPatch& patch = seen.patches.emplace_back();
  if (!scratch.spare_patches.empty()) {
    patch = std::move(scratch.spare_patches.back());
    scratch.spare_patches.pop_back();
  }
  patch.sun_cosine.clear();
  patch.sun_cosine.reserve(scratch.patch_direction.size());
  return patch;
}

/// As if nothing threw shadows on it.
void light_freely(const ExposureScratch& scratch, SurroundingPatch& patch) {
  for (const Vec3& direction : scratch.patch_direction) {
    const double cosine = direction.z > 0.0 ? std::max(0.0, dot(direction, patch.normal)) : 0.0;
    patch.sun_cosine.push_back(static_cast<float>(cosine));
  }
}

void follow(const LookedAbout& looked, const geometry::Hit& hit, const Sampler& numbers,
            Exposure& result, SurroundingPatch& patch) {
  const ExposureScratch& scratch = result.scratch;
  const Vec2 first = numbers.point(disc_point);
  for (std::uint32_t i = 0; i < scratch.patch_direction.size(); ++i) {
    const SunThen sun{scratch.patch_direction[i], looked.track->sin_radius, scratch.patch_epoch[i]};
    const Vec2 u = stepped(first, plane_step, i);
    patch.sun_cosine.push_back(
        static_cast<float>(sun_cosine_at(*looked.scene, hit, sun, u, result.rays)));
  }
}

/// A part of what was met, of one material: `one` stands for [begin, end) of the order.
void add_patch(const LookedAbout& looked, const ExposureScratch::Run& part, Exposure& result,
               SurroundingsSeen& seen) {
  ExposureScratch& scratch = result.scratch;
  const Sampler numbers = looked.numbers.child(part.begin);
  const std::uint32_t size = part.end - part.begin;
  const auto drawn = static_cast<std::uint32_t>(numbers.number(which_one) * size);
  const geometry::Hit& one = scratch.met[scratch.order[part.begin + std::min(drawn, size - 1)]];
  double tilts = 0.0;
  for (std::uint32_t i = part.begin; i < part.end; ++i) {
    tilts += scratch.met[scratch.order[i]].normal.z;
  }
  SurroundingPatch& patch = new_patch(seen, scratch);
  patch.material = one.material;
  patch.view_factor = static_cast<double>(size) / looked.settings->sky_rays;
  patch.sky_fraction = 0.5 + 0.5 * tilts / size;
  patch.normal = one.normal;
  if (part.followed > 0) {
    follow(looked, one, numbers, result, patch);
  } else if (looked.settings->surroundings > 0) {
    light_freely(scratch, patch);
  }
}

void add_parts(const LookedAbout& looked, const ExposureScratch::Run& run, Exposure& result,
               SurroundingsSeen& seen) {
  const std::uint32_t parts = std::max(run.followed, 1U), size = run.end - run.begin;
  for (std::uint32_t i = 0; i < parts; ++i) {
    const std::uint32_t begin = run.begin + i * size / parts;
    const std::uint32_t end = run.begin + (i + 1) * size / parts;
    add_patch(looked, {begin, end, run.followed}, result, seen);
  }
}

void add_ground_about(const LookedAbout& looked, ExposureScratch& scratch, SurroundingsSeen& seen) {
  SurroundingPatch& patch = new_patch(seen, scratch);
  patch.material = ground_about;
  patch.view_factor = static_cast<double>(looked.ground_about) / looked.settings->sky_rays;
  patch.sky_fraction = 1.0;
  patch.normal = {0.0, 0.0, 1.0};
  light_freely(scratch, patch);
}

}  // namespace

double sun_cosine_at(const geometry::Scene& scene, const geometry::Hit& place, const SunThen& sun,
                     Vec2 u, std::uint64_t& rays) {
  const double cosine = dot(sun.direction, place.normal);
  if (!(cosine > 0.0 && sun.direction.z > 0.0)) return 0.0;
  const Frame about = frame_about(sun.direction);
  const double r = sun.sin_radius * std::sqrt(u.x), turn = 2.0 * std::numbers::pi * u.y;
  const Vec3 aside = r * (std::cos(turn) * about.x + std::sin(turn) * about.y);
  const Vec3 direction = normalised(sun.direction + aside);
  if (dot(direction, place.normal) <= 0.0) return 0.0;
  ++rays;
  geometry::Ray ray{geometry::leaving_origin(place, direction), direction};
  ray.epochs = sun.epoch;
  return scene.occluded(ray) ? 0.0 : cosine;
}

void find_patch_moments(const SunTrack& track, double interval_s, ExposureScratch& scratch) {
  scratch.patch_direction.clear();
  scratch.patch_epoch.clear();
  const std::size_t last = track.time_s.size() - 1;
  const double first_s = track.time_s.front(), length_s = track.time_s.back() - first_s;
  const auto count = static_cast<std::size_t>(length_s / interval_s + moment_slack) + 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double elapsed = length_s > 0.0 ? static_cast<double>(i) * interval_s / length_s : 0.0;
    const double at = std::min(elapsed, 1.0) * static_cast<double>(last);
    const std::size_t before = std::min(static_cast<std::size_t>(at), last > 0 ? last - 1 : 0);
    const std::size_t after = std::min(before + 1, last);
    const double share = at - static_cast<double>(before);
    const Vec3 from = track.direction[before], to = track.direction[after];
    scratch.patch_direction.push_back(normalised(from + share * (to - from)));
    scratch.patch_epoch.push_back(track.epoch[share < 0.5 ? before : after]);
  }
}

void add_patches(const LookedAbout& looked, Exposure& result, SurroundingsSeen& seen) {
  ExposureScratch& scratch = result.scratch;
  if (!scratch.met.empty()) {
    sort_by_likeness(scratch);
    find_runs(scratch);
    deal_patches(scratch, patches_to_follow(*looked.settings, scratch.met.size()));
    for (const ExposureScratch::Run& run : scratch.runs) add_parts(looked, run, result, seen);
  }
  if (looked.ground_about > 0) add_ground_about(looked, scratch, seen);
}

}  // namespace nadir::thermal
