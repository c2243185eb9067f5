#pragma once

#include <optional>

#include "core/sampler.hpp"
#include "geometry/scene.hpp"
#include "radiometry/counters.hpp"
#include "radiometry/lit_scene.hpp"
#include "radiometry/surface_point.hpp"
#include "spectral/lanes.hpp"

namespace nadir::radiometry {

/// The path solver: an unbiased estimate of the radiance along a ray, by a random walk.
///
/// At every surface and every scattering in a volume one ray goes to each of sun and moon and one
/// to a lamp (next-event estimation); the walk goes on in a direction drawn from the lane-averaged
/// scattering function, or, where the sky is uneven, from a mixture of that and the sky's
/// brightness (one-sample multiple importance sampling). Light that the walk itself meets counts
/// with the balance heuristic's weight. Walks end by Russian roulette on the lane-averaged
/// throughput alone: no thresholds, no limit of bounces unless the scene states one.
/// Where the scene leaves effects out: without shadows nothing is traced to lights, and what walks
/// meet of them is left to that; without interreflection a walk is turned at one surface, or by
/// volumes alone, and ends at the next, whose emission it takes in.
/// Sources: Kajiya, SIGGRAPH 1986; Veach & Guibas, SIGGRAPH 1995 (multiple importance sampling).
///
/// One solver serves one thread: it counts what it does.
class PathSolver {
 public:
  explicit PathSolver(const LitScene& scene) noexcept : scene_{&scene} {}

  /// Radiance at the ray's origin, through the air: W m^-2 sr^-1 um^-1 per lane.
  /// @param hit  what the ray meets first, its material resolved
  [[nodiscard]] spectral::Spectrum aperture_radiance(const geometry::Ray& ray,
                                                     const std::optional<geometry::Hit>& hit,
                                                     const Sampler& numbers);

  [[nodiscard]] const Counters& counters() const noexcept { return counters_; }

 private:
  struct Walk;
  struct Draw;
  /// Takes in what the walk meets; false where it ends.
  bool arrive(Walk& walk, const std::optional<geometry::Hit>& hit);
  void follow(Walk& walk);
  /// Through the volumes before the next surface.
  enum class Flight { arrives, scatters, ends };
  [[nodiscard]] Flight fly(Walk& walk, double distance);
  void add_sky(Walk& walk) const;
  void add_emission(Walk& walk, const SurfacePoint& point) const;
  [[nodiscard]] double share_of_walk(const Walk& walk, double other) const noexcept;
  [[nodiscard]] bool may_reflect(const Walk& walk) const noexcept;
  void add_surface_lights(const Walk& walk, const SurfacePoint& point);
  template <class Scatter>
  void add_lights(const Walk& walk, const Scatter& scatter);
  [[nodiscard]] std::optional<Draw> draw_to_sky(const SurfacePoint& point, Vec2 u) const;
  [[nodiscard]] std::optional<Draw> draw(const Walk& walk, const SurfacePoint& point) const;
  bool bounce(Walk& walk, const SurfacePoint& point);
  bool scatter_in_volume(Walk& walk, const VolumeEvent& event);
  bool survives(Walk& walk);

  const LitScene* scene_;
  Counters counters_;
};

}  // namespace nadir::radiometry
