#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <thread>
#include <vector>

#include "geometry/scene_helpers.hpp"
#include "hard/hard_case.hpp"

// Night beside day, and any number of threads at work on it.

namespace nadir::radiometry::test {
namespace {

constexpr double dynamic_range_pi = std::numbers::pi;
const spectral::Lanes lanes{{1.0_um, 4.0_um}};

/// A sunlit yard and, beside it, a sealed cellar of thin walls with a warm box inside: its floor
/// shows 1.2e-15 W m^-2 sr^-1 um^-1 at 1 um, the yard 1e12 times as much. A lamp of 1e9, a mirror,
/// a pane and a thin mist complete the yard.
SceneDescription yard_and_cellar(Method method) {
  SmallScene scene;
  scene.method = method;
  const auto warm = scene.material(grey(0.5), 270.0_K);
  const auto ground = scene.material(grey(0.5), 290.0_K);
  scene.add(geometry::Plane{{}, 40.0, 40.0}, ground);
  scene.add(geometry::test::box_mesh({2.0, -3.0, 0.5}, {8.0, 3.0, 3.0}), warm);
  scene.add(geometry::Sphere{{-4.0, 2.0, 1.0}, 1.0},
            scene.material(scaled(materials::Mirror{}, 0.8), 290.0_K));
  materials::Material pane = scaled(materials::ClearSheet{}, 0.1);
  pane.transmittance = spectral::Curve::constant(0.8);
  scene.add(geometry::Plane{{-5.0, -4.0, 2.0}, 3.0, 3.0}, scene.material(pane, 290.0_K));
  scene.add_disc_lamp({{-8.0, 0.0, 4.0}, {0.0, 0.0, -1.0}, 0.1}, 1e9,
                      scene.material(grey(0.0), Kelvin{0.0}));
  scene.volumes.push_back({"mist",
                           geometry::Region{geometry::Box{{-9.0, -9.0, 0.0}, {1.0, 9.0, 2.0}}, {}},
                           {spectral::Curve::constant(0.01), spectral::Curve::constant(0.05), {}},
                           nullptr,
                           285.0_K,
                           {}});
  scene.add_body(200.0, 45.0, 0.266, 1e4);
  scene.overcast(10.0);
  scene.solver = {.initial_sample_count = 4, .mu_samples = 2, .phi_samples = 4};
  return scene.build();
}

TEST_CASE("a cellar beside a yard 1e12 times as bright shows its own warmth", "[hard][range]") {
  for (const Method method : both_solvers) {
    SceneDescription scene = yard_and_cellar(method);
    // Sun and lamp cost every hit that faces them two of its samples, in a sealed cellar too.
    scene.solver = {.initial_sample_count = 3,
                    .sample_decay_rate = 1.0,
                    .max_bounces = 6,
                    .mu_samples = 2,
                    .phi_samples = 4};
    const auto night =
        hard_measure(scene, lanes, {{5.0, 0.0, 2.0}, normalised({0.3, 0.2, -1.0})}, 16, 32);
    CAPTURE(name_of(method));
    // 0.5^8: what the generic solver's eighth generation leaves out.
    check_right(night, black_body(lanes, 270.0_K), method == Method::path ? 1e-5 : 4e-3);
    const auto day =
        hard_measure(scene, lanes, {{12.0, 0.0, 2.0}, normalised({0.3, 0.2, -1.0})}, 4, 32);
    check_sane(day);
    CHECK(day.lanes[0].mean > 1e12 * night.lanes[0].mean);
    CHECK(day.lanes[0].mean > 0.5 * 1e4 * std::sin(degrees(45.0).value) / dynamic_range_pi);
  }
}

TEST_CASE("mirror, pane, mist and lamp look alike to both solvers", "[hard][range]") {
  SceneDescription scene = yard_and_cellar(Method::generic);
  scene.solver = {.initial_sample_count = 6,
                  .sample_decay_rate = 1.0,
                  .max_bounces = 4,
                  .mu_samples = 2,
                  .phi_samples = 4};
  const Vec3 eye{-5.0, 0.0, 15.0};
  for (const Vec3 at : {Vec3{-3.6, 2.5, 1.5}, Vec3{-5.0, -4.0, 2.0}, Vec3{-8.0, 1.5, 0.0},
                        Vec3{1.5, 1.0, 0.0}, Vec3{-4.5, -2.0, 0.0}}) {
    const geometry::Ray ray{eye, normalised(at - eye)};
    scene.method = Method::generic;
    const Measured generic = measure(scene, lanes, ray, 16, 8);
    scene.method = Method::path;
    const Measured path = measure(scene, lanes, ray, 16, 4096);
    check_sane(generic);
    check_sane(path);
    const Estimate a = generic.lanes[0], b = path.lanes[0];
    CAPTURE(at.x, at.y, a.mean, a.standard_error, b.mean, b.standard_error, a.mean / b.mean);
    CHECK(std::abs(a.mean - b.mean) <
          4.0 * std::hypot(a.standard_error, b.standard_error) + 0.01 * b.mean);
  }
}

struct Image {
  static constexpr int width = 20, height = 14;
  std::vector<float> radiance = std::vector<float>(width * height);
};

template <class Solver>
void render(const LitScene& lit, Image& image, int from, int step) {
  Solver solver{lit};
  for (int pixel = from; pixel < Image::width * Image::height; pixel += step) {
    const double x = -10.0 + 20.0 * (pixel % Image::width + 0.5) / Image::width;
    const double y = -7.0 + 14.0 * (pixel / Image::width + 0.5) / Image::height;
    spectral::SpectrumSum sum{lit.lanes().count()};
    for (std::uint32_t i = 0; i < 8; ++i) {
      const Sampler numbers{mix(11, static_cast<std::uint64_t>(pixel)), i};
      // Columns beyond x = 2 begin inside of the cellar.
      const bool inside = x > 2.0 && x < 8.0 && std::abs(y) < 3.0;
      const geometry::Ray ray{{x, y, inside ? 2.5 : 20.0}, {0.0, 0.0, -1.0}};
      sum.add(solver.aperture_radiance(ray, lit.intersect(ray, numbers), numbers.child(0)));
    }
    image.radiance[static_cast<std::size_t>(pixel)] = static_cast<float>(sum[0] / 8.0);
  }
}

template <class Solver>
Image rendered(const LitScene& lit, int threads) {
  Image image;
  std::vector<std::thread> workers;
  for (int t = 0; t < threads; ++t) {
    workers.emplace_back([&, t] { render<Solver>(lit, image, t, threads); });
  }
  for (std::thread& worker : workers) worker.join();
  return image;
}

template <class Solver>
void check_threads(Method method) {
  const SceneDescription scene = yard_and_cellar(method);
  Diagnostics diagnostics;
  const LitScene lit{scene, lanes, diagnostics};
  const Image one = rendered<Solver>(lit, 1);
  float least = one.radiance[0], most = least;
  for (const float value : one.radiance) {
    REQUIRE(std::isfinite(value));
    REQUIRE(value > 0.0F);
    least = std::min(least, value);
    most = std::max(most, value);
  }
  CHECK(static_cast<double>(most) > 1e12 * static_cast<double>(least));
  for (const int threads : {2, 5}) {
    const Image more = rendered<Solver>(lit, threads);
    CAPTURE(threads);
    CHECK(std::memcmp(one.radiance.data(), more.radiance.data(),
                      one.radiance.size() * sizeof(float)) == 0);
  }
}

TEST_CASE(
    "an image over twelve orders of magnitude is the same, bit by bit, from 1, 2 and 5 "
    "threads",
    "[hard][range]") {
  SECTION("generic") { check_threads<GenericSolver>(Method::generic); }
  SECTION("path") { check_threads<PathSolver>(Method::path); }
}

}  // namespace
}  // namespace nadir::radiometry::test
