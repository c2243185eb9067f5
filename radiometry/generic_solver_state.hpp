#pragma once
// Private to this folder: what the generic solver keeps in mind about one hit and one ray.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "radiometry/generic_solver.hpp"

namespace nadir::radiometry {

namespace generic {

// Purposes of the random numbers at one hit. Quads have children of their own from first_quad on.
enum Dimension : std::uint32_t {
  allocation = 0,
  lamp_choice = 1,
  lamp_place = 2,
  flight = 3,
  in_scatter = 4,
  phase = 5,
  first_target = 16
};
inline constexpr std::uint32_t first_quad = 1024;

/// Number n of an additive sequence in the unit square that fills it evenly whatever its length, as
/// steps away from a first point: samples of one quad at one hit are spread by it, while the first
/// points of successive paths are a low-discrepancy set of their own.
/// Source: M. Roberts, "The unreasonable effectiveness of quasirandom sequences" (2018): powers of
/// 1 / g with g the positive root of g^3 = g + 1.
inline Vec2 spread(Vec2 first, int n) {
  const double x = first.x + n * 0.7548776662466927, y = first.y + n * 0.5698402909980532;
  return {x - std::floor(x), y - std::floor(y)};
}
/// The same on the unit interval, by the golden ratio.
inline double spread(double first, int n) {
  const double x = first + n * 0.6180339887498949;
  return x - std::floor(x);
}

inline double largest(const spectral::Spectrum& s) { return static_cast<double>(s.max()); }

}  // namespace generic

/// Lights that a ray meets: their shadow rays have counted them already where the ray fills a quad;
/// where it was drawn by a lobe both share by the balance heuristic.
struct GenericSolver::LightsAlong {
  bool seen = false;
  double density = 0.0;  // of all lobe samples together, sr^-1; 0: a delta, or a sensor's ray
  Vec3 origin{}, normal{};
  int lamp_draws = 1;  // of shadow rays to lamps at that origin
};

/// A hit that is being solved.
struct GenericSolver::Visit {
  const SurfacePoint& point;
  const GenericPlan& plan;
  double weight;  // of the ray that asked
  int generation;
  Sampler sampler;
  QuadTurn turn;                  // how the quads lie around the view
  const Arrival* came = nullptr;  // the ray that asked; null: one from outside

  Visit(const LitScene& scene, const SurfacePoint& at, double ray_weight, int g,
        const Sampler& numbers)
      : point{at},
        plan{scene.plan(at.hit().material)},
        weight{ray_weight},
        generation{g},
        sampler{numbers} {
    if (!by_lobes()) turn = plan.importance()->turn(at.wo());
  }

  [[nodiscard]] bool by_lobes() const { return !plan.importance().has_value(); }
  /// Fewest samples of a quad, or of a lobe: the stated ones, but one at least where there are no
  /// others.
  [[nodiscard]] int minimum(bool interreflects) const {
    const int stated = plan.settings().min_quad_samples;
    return interreflects ? stated : std::max(1, stated);
  }
  /// Whether light goes on straight through: as if the surface had not been there.
  [[nodiscard]] bool goes_straight(Vec3 wi) const {
    return point.material().traits.straight && dot(wi, point.wo()) < -(1.0 - 1e-12);
  }
};

/// A direction that light may come from.
struct GenericSolver::Sample {
  spectral::Spectrum factor;  // f |cos| per lane, sr^-1
  double reflectance = 0.0;   // largest reflectance factor pi f over the wavelengths
  double weight = 0.0;        // of the ray that asked, times the former, times the cosine
  bool possible = false;

  Sample(const spectral::Spectrum& f, double largest_factor, double sample_weight)
      : factor{f}, reflectance{largest_factor}, weight{sample_weight}, possible{true} {}
  /// Light from a direction in scene axes, as a shadow ray brings it.
  Sample(const Visit& visit, Vec3 towards) : possible{visit.point.scattered(towards, factor)} {
    if (possible) weigh(visit, visit.point.cosine(towards));
  }
  /// A local direction of a quad, before it is folded.
  static Sample of_quad(const Visit& visit, Vec3 wi) {
    const double cosine = std::abs(wi.z);
    Sample sample{materials::eval(visit.point.material().scattering, wi, visit.point.wo()), 0.0,
                  0.0};
    sample.factor *= static_cast<float>(cosine);
    sample.weigh(visit, cosine);
    return sample;
  }

 private:
  void weigh(const Visit& visit, double cosine) {
    const double strongest = std::numbers::pi * generic::largest(factor);
    reflectance = strongest / std::max(cosine, 1e-12);
    weight = visit.weight * strongest;
  }
};

/// What becomes of the light that a ray brings.
struct GenericSolver::Arrival {
  spectral::Spectrum factor;
  double direct_share = 1.0;     // of emission and sky
  double scattered_share = 1.0;  // of what the hit scatters; counts for full samples only
  Kind kind = Kind::full;
  double weight = 1.0;
  int generation = 0;  // of the hit
  LightsAlong lights{};
  bool at_sensor = false;  // the air between is to be added where nothing is hit
  bool of_volume = false;  // it was scattered in a volume
};

}  // namespace nadir::radiometry
