#include <cmath>

#include "core/student_t.hpp"
#include "radiometry/small_scene.hpp"
#include "support/catch.hpp"

// Is the stated error the real one? A case with a known answer is computed with 500 seeds; the 95 %
// interval (Student's t, since a pixel has few replicates) must hold the answer about 475 times.
// Of 500 draws at 95 % the share has a standard deviation of 1 %: 92 to 98 % is three of them.

namespace nadir::radiometry::test {
namespace {

const spectral::Lanes one_lane{{0.55_um}};
constexpr int seeds = 500;

double covered(const SceneDescription& scene, const geometry::Ray& ray, double truth,
               int replicates, int samples) {
  int inside = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    const Estimate seen =
        measure(scene, one_lane, ray, replicates, samples, 1000 + static_cast<std::uint64_t>(seed))
            .lanes[0];
    if (confidence_interval(seen, replicates, 0.95).contains(truth)) ++inside;
  }
  return static_cast<double>(inside) / seeds;
}

// A point on the floor of a black tube, off its axis, so that no symmetry makes the points of a
// replicate exact. It sees the opening under the view factor
// F = (1 - (h^2 + r^2 - R^2) / sqrt((h^2 + r^2 + R^2)^2 - 4 r^2 R^2)) / 2.
// Source: J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-13.
constexpr double depth = 0.7, offset = 0.37, sky_radiance = 50.0;

double truth_in_tube() {
  const double sum = depth * depth + offset * offset;
  const double root = std::sqrt((sum + 1.0) * (sum + 1.0) - 4.0 * offset * offset);
  return sky_radiance * 0.5 * (1.0 - (sum - 1.0) / root);
}

SmallScene tube() {
  SmallScene scene;
  scene.add(geometry::Disc{{0.0, 0.0, -depth}, {0.0, 0.0, 1.0}, 1.0},
            scene.material(grey(1.0), Kelvin{0.0}));
  scene.add(geometry::Cylinder{{0.0, 0.0, -depth}, {}, 1.0, false},
            scene.material(grey(0.0), Kelvin{0.0}));
  scene.sky(sky_radiance);
  return scene;
}

geometry::Ray onto_floor() { return {{offset, 0.0, 10.0}, {0.0, 0.0, -1.0}}; }

TEST_CASE("the 95 % interval of the path solver holds the truth in 92 to 98 % of 500 seeds",
          "[radiometry][coverage]") {
  SmallScene scene = tube();
  scene.method = Method::path;
  const double share = covered(scene.build(), onto_floor(), truth_in_tube(), 4, 32);
  CAPTURE(share);
  CHECK(share >= 0.92);
  CHECK(share <= 0.98);
}

TEST_CASE("the 95 % interval of the generic solver holds the truth in 92 to 98 % of 500 seeds",
          "[radiometry][coverage]") {
  SmallScene scene = tube();
  scene.solver = {.initial_sample_count = 8, .mu_samples = 2, .phi_samples = 6};
  const double share = covered(scene.build(), onto_floor(), truth_in_tube(), 4, 8);
  CAPTURE(share);
  CHECK(share >= 0.92);
  CHECK(share <= 0.98);
}

TEST_CASE("the 95 % interval holds in a furnace of many bounces", "[radiometry][coverage]") {
  SmallScene scene;
  scene.method = Method::path;
  scene.add(geometry::Sphere{{}, 5.0}, scene.material(grey(0.6), 6000.0_K));
  const double truth = spectral::planck(one_lane[0], 6000.0_K).value;
  const double share = covered(scene.build(), {{}, {0.0, 0.6, -0.8}}, truth, 8, 32);
  CAPTURE(share);
  CHECK(share >= 0.92);
  CHECK(share <= 0.98);
}

}  // namespace
}  // namespace nadir::radiometry::test
