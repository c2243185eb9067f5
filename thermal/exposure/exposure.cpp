#include "thermal/exposure/exposure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/frame.hpp"
#include "core/random.hpp"
#include "thermal/exposure/lattice.hpp"
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

/// Looks for the sun from one cell. Moments of even and of odd number draw from sequences of their
/// own: each is low in discrepancy, and a moment's rays know nothing of those before and after. Two
/// that go round by the same steps would keep pace for ever.
class SunSearch {
 public:
  SunSearch(const LookedAbout& looked, CellPlaces& places, std::uint64_t key, Exposure& result)
      : looked_{&looked}, places_{&places}, key_{key}, result_{&result} {
    for (std::uint32_t odd : {0U, 1U}) {
      disc_start_[odd] = Sampler{key_, 0}.child(odd).point(sun_disc);
    }
  }

  void look_once() {
    const auto moments = static_cast<std::uint32_t>(looked_->track->direction.size());
    result_->sun_cosine.clear();
    result_->scratch.sun_rays.clear();
    for (std::uint32_t i = 0; i < moments; ++i) {
      const std::uint64_t before = result_->rays;
      const double cosine = is_up(i) ? cosine_at(i, first_draw(i)) : 0.0;
      const SunRay met = cosine > 0.0 ? SunRay::lit : SunRay::hidden;
      result_->scratch.sun_rays.push_back(result_->rays > before ? met : SunRay::none);
      result_->sun_cosine.push_back(static_cast<float>(cosine));
    }
  }

  /// More rays where they are worth it. A moment's own ray has no say in whether it gets more:
  /// those that differ from their neighbours are the unlikely ones, and to correct them alone would
  /// make of the tenth of the sun that leaves let through a 25th.
  void look_again() {
    const std::vector<SunRay>& met = result_->scratch.sun_rays;
    const std::size_t moments = met.size();
    const auto last = static_cast<std::size_t>(std::max(looked_->settings->last_moments, 0));
    for (std::size_t i = 0; i < moments; ++i) {
      const bool is_last = i + last >= moments;
      const bool is_edge = i > 0 && i + 1 < moments && differ(met[i - 1], met[i + 1]);
      if (is_last || is_edge) look_closely(static_cast<std::uint32_t>(i));
    }
  }

 private:
  /// A point of the cell and one of the disc.
  struct Pair {
    Vec2 place, disc;
  };

  [[nodiscard]] bool is_up(std::uint32_t i) const { return looked_->track->direction[i].z > 0.0; }
  [[nodiscard]] static bool differ(SunRay a, SunRay b) {
    return a != b && a != SunRay::none && b != SunRay::none;
  }
  [[nodiscard]] Pair first_draw(std::uint32_t i) const {
    const std::uint32_t odd = i % 2, number = i / 2;
    return {Sampler{key_, number}.child(odd).point(sun_from),
            stepped(disc_start_[odd], odd == 0 ? plane_step : next_roots_step, number)};
  }
  [[nodiscard]] double cosine_at(std::uint32_t i, const Pair& u) {
    const SunTrack& track = *looked_->track;
    const SunThen sun{track.direction[i], track.sin_radius, track.epoch[i]};
    return sun_cosine_at(*looked_->scene, places_->at(u.place), sun, u.disc, result_->rays);
  }

  /// Rays of one moment: points of a lattice that goes through the first ray's. Across edges 8 are
  /// off by 0.075 on squares, 0.09 on triangles; those of a (0, 3, 2)-net by 0.072 and 0.117.
  void look_closely(std::uint32_t i) {
    const int rays = looked_->settings->edge_rays;
    if (rays < 2 || !is_up(i)) return;
    const Pair first = first_draw(i);
    const Vec2 place_step{1.0 / rays, golden_step};
    auto sum = static_cast<double>(result_->sun_cosine[i]);
    for (int k = 1; k < rays; ++k) {
      const auto number = static_cast<std::uint32_t>(k);
      sum += cosine_at(
          i, {stepped(first.place, place_step, number), stepped(first.disc, roots_step, number)});
    }
    result_->sun_cosine[i] = static_cast<float>(sum / rays);
  }

  const LookedAbout* looked_;
  CellPlaces* places_;
  std::uint64_t key_;
  Exposure* result_;
  Vec2 disc_start_[2];
};

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

void look_about(CellPlaces& places, std::uint32_t epoch, LookedAbout looked, std::uint64_t key,
                Exposure& result) {
  ExposureScratch& scratch = result.scratch;
  scratch.met.clear();
  scratch.bearing.clear();
  std::uint32_t sky = 0;
  const auto rays = static_cast<std::uint32_t>(looked.settings->sky_rays);
  const Vec2 first_place = Sampler{key, 0}.point(look_from);
  for (std::uint32_t i = 0; i < rays; ++i) {
    const Sampler numbers{key, i};
    const geometry::Hit& place = places.at(stepped(first_place, plane_step, i));
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
  CellPlaces places{cell};
  SunSearch search{looked, places, key, result};
  search.look_once();
  search.look_again();
  for (const std::uint32_t epoch : result.epochs) look_about(places, epoch, looked, key, result);
}

}  // namespace nadir::thermal
