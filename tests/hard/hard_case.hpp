#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "radiometry/small_scene.hpp"
#include "support/catch.hpp"

// What every hard case is held to: right within its error bar, finite, not negative, and the same
// bits whatever else was computed before or at the same time.

namespace nadir::radiometry::test {

inline constexpr Method both_solvers[] = {Method::generic, Method::path};

inline const char* name_of(Method method) { return method == Method::path ? "path" : "generic"; }

inline void check_sane(const Measured& seen) {
  for (const Estimate& lane : seen.lanes) {
    CHECK(std::isfinite(lane.mean));
    CHECK(std::isfinite(lane.standard_error));
    CHECK(lane.mean >= 0.0);
  }
}

/// Four standard errors, and a systematic part: float rounding where nothing else is known.
inline void check_right(const Measured& seen, const std::vector<double>& expected,
                        double systematic = 1e-5) {
  check_sane(seen);
  REQUIRE(seen.lanes.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Estimate& lane = seen.lanes[i];
    CAPTURE(i, lane.mean, lane.standard_error, expected[i]);
    CHECK(std::abs(lane.mean - expected[i]) <=
          4.0 * lane.standard_error + systematic * expected[i]);
  }
}
inline void check_right(const Measured& seen, double expected, double systematic = 1e-5) {
  check_right(seen, std::vector<double>(seen.lanes.size(), expected), systematic);
}
inline std::vector<double> black_body(const spectral::Lanes& lanes, Kelvin temperature) {
  std::vector<double> radiance;
  for (const Micrometres at : lanes) radiance.push_back(spectral::planck(at, temperature).value);
  return radiance;
}

template <class Solver>
void check_order_is_nothing(const LitScene& lit, const geometry::Ray& ray) {
  constexpr std::uint32_t count = 6;
  const auto hit = lit.intersect(ray, Sampler{1, 0});
  const auto seen = [&](Solver& solver, std::uint32_t i) {
    return solver.aperture_radiance(ray, hit, Sampler{mix(1, i), i});
  };
  Solver first{lit};
  std::vector<spectral::Spectrum> in_order;
  for (std::uint32_t i = 0; i < count; ++i) in_order.push_back(seen(first, i));
  for (std::uint32_t i = count; i-- > 0;) {
    Solver fresh{lit};  // as another thread would have it
    const spectral::Spectrum again = seen(fresh, i);
    for (int lane = 0; lane < lit.lanes().count(); ++lane) CHECK(again[lane] == in_order[i][lane]);
  }
}

/// As `measure`; and checks that a sample's value depends on its numbers alone: bit by bit the same
/// in reverse order, each from a solver of its own. That is what makes images independent of the
/// number of threads.
inline Measured hard_measure(const SceneDescription& scene, const spectral::Lanes& lanes,
                             const geometry::Ray& ray, int replicates, int samples) {
  Diagnostics diagnostics;
  const LitScene lit{scene, lanes, diagnostics};
  if (scene.method == Method::path) {
    check_order_is_nothing<PathSolver>(lit, ray);
    return measure_with(PathSolver{lit}, lit, ray, replicates, samples, 1);
  }
  check_order_is_nothing<GenericSolver>(lit, ray);
  return measure_with(GenericSolver{lit}, lit, ray, replicates, samples, 1);
}

/// A material that scatters by a model scaled with this reflectance.
inline materials::Material scaled(const materials::Scattering& model, double reflectance) {
  materials::Material material = grey(reflectance);
  material.scattering = model;
  return material;
}
/// A material whose model brings its own spectra.
inline materials::Material own_spectra(const materials::Scattering& model) {
  materials::Material material;
  material.name = "own";
  material.scattering = model;
  return material;
}

/// Two triangles; seen from the front they run a, b, c, d anticlockwise.
inline geometry::TriangleMesh two_triangles(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  return {{a, b, c, d}, {{0, 1, 2}, {0, 2, 3}}, {}, {}, {}};
}

/// A ray that meets `target` at an angle from the vertical, from the west.
inline geometry::Ray slanted(Vec3 target, double zenith_deg, double from_m) {
  const double zenith = degrees(zenith_deg).value;
  const Vec3 towards{-std::sin(zenith), 0.0, std::cos(zenith)};
  return {target + from_m * towards, -towards};
}

}  // namespace nadir::radiometry::test
