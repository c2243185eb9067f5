#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "hard/hard_case.hpp"

// Cases in which numbers like to break. Each says what physics expects of it.

namespace nadir::radiometry::test {
namespace {

const spectral::Lanes widest{{0.3_um, 2.0_um, 14.0_um}};

TEST_CASE("from 0 K to 6000 K and emissivity 0 to 1 radiance is finite, positive and Planck's",
          "[hard]") {
  const double temperature_k = GENERATE(0.0, 3.0, 300.0, 6000.0);
  const double emissivity = GENERATE(0.0, 0.5, 1.0);
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(geometry::Plane{{0.0, 0.0, 0.0}, 10.0, 10.0},
              scene.material(grey(1.0 - emissivity), Kelvin{temperature_k}));
    const auto seen = hard_measure(scene.build(), widest, downward(), 4, 1);
    CAPTURE(temperature_k, emissivity, name_of(method));
    for (int i = 0; i < widest.count(); ++i) {
      const double expected = emissivity * spectral::planck(widest[i], Kelvin{temperature_k}).value;
      const double radiance = seen.lanes[static_cast<std::size_t>(i)].mean;
      CHECK(std::isfinite(radiance));
      CHECK(radiance >= 0.0);
      // Float lanes; below the smallest normal float (1.2e-38) radiance is 0.
      CHECK(radiance == Approx(expected).epsilon(1e-6).margin(1.2e-38));
    }
  }
}

TEST_CASE("a sunlit target of one metre has the same radiance from 5 m and from 36,000 km",
          "[hard]") {
  SmallScene scene;
  scene.add(geometry::Plane{{0.0, 0.0, 0.0}, 1.0, 1.0}, scene.material(grey(0.5), 300.0_K));
  scene.add_body(140.0, 40.0, 0.266, 1500.0);
  const SceneDescription description = scene.build();
  const auto near = measure(description, widest, downward(5.0), 4, 16);
  const auto far = measure(description, widest, downward(3.6e7), 4, 16);
  for (std::size_t i = 0; i < near.lanes.size(); ++i) {
    // The same random numbers from a place that differs by float rounding.
    CHECK(far.lanes[i].mean == Approx(near.lanes[i].mean).epsilon(1e-5));
  }
}

TEST_CASE("a night pixel beside a source 1e12 times as bright keeps its own digits", "[hard]") {
  // Two plates far apart, one of them white-hot: sums in double must not wipe out the cold one.
  SmallScene scene;
  scene.add(geometry::Plane{{0.0, 0.0, 0.0}, 1.0, 1.0}, scene.material(grey(0.0), 300.0_K));
  scene.add(geometry::Plane{{50.0, 0.0, 0.0}, 1.0, 1.0}, scene.material(grey(0.0), 6000.0_K));
  const auto seen = measure(scene.build(), spectral::Lanes{{1.5_um}}, downward(), 4, 4);
  CHECK(seen.lanes[0].mean == Approx(spectral::planck(1.5_um, 300.0_K).value).epsilon(1e-6));
}

TEST_CASE("an instance shrunk to nothing is refused, not traced", "[hard]") {
  // Embree's float transform of such an instance would be infinite and end the process.
  const geometry::Surface ball{geometry::Shape{geometry::Sphere{{0.0, 0.0, 0.0}, 1.0}}, {0}};
  geometry::SceneBuilder builder;
  const double scale = GENERATE(1e-18, 1e-7, 1e7);
  CHECK_THROWS_AS(
      builder.add_instances({ball}, {{scaling({scale, scale, scale}), {1.0, 2.0, 3.0}}}, 0),
      InputError);
}

}  // namespace
}  // namespace nadir::radiometry::test
