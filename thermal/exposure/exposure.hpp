#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/vec.hpp"
#include "geometry/scene.hpp"
#include "thermal/exposure/surface_cell.hpp"

namespace nadir::thermal {

/// Where the sun was at the moments at which shadows are looked for.
struct SunTrack {
  std::vector<double> time_s;        ///< ascending, evenly spaced, the last 0 (the picture)
  std::vector<Vec3> direction;       ///< unit, scene axes; the air's refraction not counted
  double sin_radius = 0.00465;       ///< of the disc
  std::vector<std::uint32_t> epoch;  ///< bit of the scene's epoch at each moment (Ray::epochs)
};

/// How many rays look about from each place.
struct ExposureSettings {
  int sky_rays = 64;     ///< over the hemisphere, by cosine
  int surroundings = 8;  ///< of the surfaces met, followed through the day; 0: never in the sun
  double surroundings_interval_s = 3600.0;
  /// To the sun at moments when a shadow's edge may lie on the cell, and at the last ones. One ray
  /// there is off by 0.4 of the sun, 8 by 0.1: 0.82 and 0.46 K of the temperature after a day among
  /// houses, 16 would have 0.45. 1: no more than at other moments.
  int edge_rays = 8;
  /// Of the track, the picture's included. What the surface has left of the sun's heat falls as the
  /// root of time: with 2 of 10 minutes 0.50 K, with 6 0.46, with 10 0.45. 0: none.
  int last_moments = 6;
};

/// A surface about a place: what of it is seen, and its sun.
struct SurroundingPatch {
  std::uint32_t material = 0;  ///< of the scene, maps resolved; `ground_about` below the horizon
  double view_factor = 0.0;
  double sky_fraction = 1.0;  ///< of the patch's own hemisphere, by its tilt alone
  Vec3 normal;
  /// At moments surroundings_interval apart, from the track's first on: cosine of incidence, 0 in
  /// shadow. Empty for one that is never in the sun.
  std::vector<float> sun_cosine;
};
inline constexpr std::uint32_t ground_about = ~0U;  ///< what lies beyond the scene's edge

/// What a place sees during an epoch.
struct SurroundingsSeen {
  double sky_fraction = 1.0;  ///< cosine-weighted share of the hemisphere that is sky
  std::vector<SurroundingPatch> patches;
};

/// What a ray towards the sun has met, if there was one.
enum class SunRay : std::uint8_t { none, hidden, lit };

/// Memory of expose() that its next call uses again.
struct ExposureScratch {
  struct Run {  ///< of `order`, of one material
    std::uint32_t begin = 0, end = 0;
    std::uint32_t followed = 0;  ///< patches that it is cut into
  };
  std::vector<geometry::Hit> met;     ///< by the rays that look about
  std::vector<std::uint32_t> facing;  ///< of each: axis that its normal is nearest to
  std::vector<double> bearing;        ///< of each, as seen from where its ray left
  std::vector<std::uint32_t> order;   ///< of met
  std::vector<SunRay> sun_rays;       ///< the first of each moment
  std::vector<Run> runs;
  std::vector<Vec3> patch_direction;  ///< to the sun at the moments of the patches
  std::vector<std::uint32_t> patch_epoch;
  std::vector<SurroundingPatch> spare_patches;
  std::vector<SurroundingsSeen> spare_seen;
};

/// What a place on a surface was exposed to, all along the sun's track.
struct Exposure {
  std::vector<float> sun_cosine;  ///< at each moment: cosine of incidence times the visible share
  std::vector<std::uint32_t> epochs;   ///< those that occur in the track, in order of time
  std::vector<SurroundingsSeen> seen;  ///< for each of them
  std::uint64_t rays = 0;
  ExposureScratch scratch;
};

/// Looks about from a cell of the scene's surface: every ray leaves from a place of its own, so
/// that all are means over the cell. Deterministic: depends on cell, seed and settings alone.
///
/// - One ray a moment looks for the sun, at a point of its disc, while the disc's centre stands
///   above the horizon and the place's own plane; the cosine is that of the centre. Where the
///   moments before and after differ, and at the last ones, it is the mean of `edge_rays`.
/// - For each epoch `sky_rays` rays by cosine. What meets nothing is sky above the horizon and
///   `ground_about` below, which is level and open.
/// - What is met becomes patches: the materials' shares are exact counts of rays; each material's
///   are sorted by the way they face and lie, cut into equal parts, and one of each part, drawn at
///   random, is followed through the day for all. A part is at least 1 / (2 surroundings) of the
///   hemisphere: where little is about, few are followed. Materials too rare for a part, and all
///   where less than a fiftieth of the hemisphere is taken, count as lit by cosine alone.
///
/// The scratch memory is in `result`: nothing is allocated once it has grown.
void expose(const geometry::Scene& scene, const SurfaceCell& cell, const SunTrack& track,
            const ExposureSettings& settings, std::uint64_t seed, Exposure& result);

}  // namespace nadir::thermal
