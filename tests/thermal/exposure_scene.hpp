#pragma once
// What the tests of exposure share: small scenes, suns, one call for a whole facet.

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/scene_builder.hpp"
#include "thermal/exposure/exposure.hpp"

namespace nadir::thermal::test {

inline constexpr double degree = std::numbers::pi / 180.0;

/// Unit vector: azimuth clockwise from north, elevation, both in degrees.
inline Vec3 towards(double azimuth_deg, double elevation_deg) {
  const double level = std::cos(elevation_deg * degree);
  return {level * std::sin(azimuth_deg * degree), level * std::cos(azimuth_deg * degree),
          std::sin(elevation_deg * degree)};
}

inline SunTrack track_of(std::vector<Vec3> directions, double interval_s = 600.0) {
  SunTrack track;
  const double last = static_cast<double>(directions.size()) - 1.0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    track.time_s.push_back((static_cast<double>(i) - last) * interval_s);
  }
  track.epoch.assign(directions.size(), geometry::at_the_picture);
  track.direction = std::move(directions);
  return track;
}

/// From the eastern horizon over the zenith to the western one, every half degree: 361 moments.
inline SunTrack overhead_track() {
  std::vector<Vec3> directions;
  for (int i = 0; i <= 360; ++i) directions.push_back(towards(90.0, 0.5 * i));
  return track_of(std::move(directions), 120.0);
}

inline geometry::Surface at_times(geometry::Shape shape, std::uint32_t material,
                                  std::uint32_t epochs = geometry::always) {
  return {shape, {material}, epochs};
}

/// The facet as one cell.
inline SurfaceCell whole(const geometry::Scene& scene, std::uint64_t facet, bool back = false) {
  SurfaceCell cell{&scene, facet, back, {}, 0};
  cell.grid.triangle = scene.facet_size(facet).triangle;
  return cell;
}

/// A piece of a square metre or so at the middle of a face.
inline SurfaceCell middle(const geometry::Scene& scene, std::uint64_t facet, bool back = false) {
  SurfaceCell cell = whole(scene, facet, back);
  cell.grid = cut(scene.facet_size(facet), 1.0);
  cell.cell = cell.grid.cell_at({0.5, 0.5});
  return cell;
}

inline Exposure exposure_of(const SurfaceCell& cell, const SunTrack& track,
                            const ExposureSettings& settings = {}, std::uint64_t seed = 1) {
  Exposure result;
  expose(*cell.scene, cell, track, settings, seed, result);
  return result;
}

inline double view_factor_of(const SurroundingsSeen& seen, std::uint32_t material) {
  double sum = 0.0;
  for (const SurroundingPatch& patch : seen.patches) {
    if (patch.material == material) sum += patch.view_factor;
  }
  return sum;
}

}  // namespace nadir::thermal::test
