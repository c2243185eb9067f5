#include <cmath>
#include <numbers>

#include "radiometry/small_scene.hpp"
#include "support/catch.hpp"

// The path solver is right by construction; these scenes have closed forms to hold it to.

namespace nadir::radiometry::test {
namespace {

constexpr double float_rounding_path_solver = 1e-5;  // some dozens of float products
const spectral::Lanes visible_path_solver{{0.45_um, 0.55_um, 0.65_um}};
const spectral::Lanes thermal_ir_path_solver{{8.5_um, 10.9_um, 12.0_um}};

SmallScene path_scene() {
  SmallScene scene;
  scene.method = Method::path;
  return scene;
}

void check_near(const Measured& seen, double expected,
                double systematic = float_rounding_path_solver) {
  for (const Estimate& lane : seen.lanes) {
    CAPTURE(lane.mean, lane.standard_error, expected);
    CHECK(std::abs(lane.mean - expected) < 4.0 * lane.standard_error + systematic * expected);
  }
}

materials::Material with_path_solver(const materials::Scattering& model, double reflectance) {
  materials::Material material = grey(reflectance);
  material.scattering = model;
  return material;
}

TEST_CASE("path: a plane under sun and even sky reflects rho (E cos / pi + L_sky)",
          "[radiometry][path]") {
  SmallScene scene = path_scene();
  scene.add(geometry::Plane{{}, 1000.0, 1000.0}, scene.material(grey(0.25), Kelvin{0.0}));
  scene.add_body(200.0, 40.0, 0.266, 1000.0);
  scene.sky(80.0);
  const auto seen = measure(scene.build(), visible_path_solver, downward(), 16, 16);
  check_near(seen, 0.25 * 1000.0 * std::sin(degrees(40.0).value) * std::numbers::inv_pi + 20.0);
  CHECK(seen.counters.target_rays == 256);
  CHECK(seen.counters.path_rays == 256);
}

TEST_CASE("path: a closed furnace is a black body whatever its walls reflect",
          "[radiometry][path]") {
  const double reflectance = GENERATE(0.0, 0.5, 0.9, 0.99);
  SmallScene scene = path_scene();
  scene.add(geometry::Sphere{{}, 5.0}, scene.material(grey(reflectance), 300.0_K));
  const auto seen = measure(scene.build(), thermal_ir_path_solver, {{}, {0.0, 0.6, -0.8}}, 32, 256);
  CAPTURE(reflectance, seen.counters.path_rays);
  for (int i = 0; i < thermal_ir_path_solver.count(); ++i) {
    const double expected = spectral::planck(thermal_ir_path_solver[i], 300.0_K).value;
    const Estimate& lane = seen.lanes[static_cast<std::size_t>(i)];
    CHECK(std::abs(lane.mean - expected) <
          4.0 * lane.standard_error + float_rounding_path_solver * expected);
    CHECK(lane.standard_error < 0.02 * expected);
  }
}

TEST_CASE("path: a lossless bowl under an even sky is as bright as the sky", "[radiometry][path]") {
  // A deep white tube: light leaves it after dozens of reflections, and none is lost.
  SmallScene scene = path_scene();
  const auto white = scene.material(grey(1.0), Kelvin{0.0});
  scene.add(geometry::Disc{{0.0, 0.0, -3.0}, {0.0, 0.0, 1.0}, 1.0}, white);
  scene.add(geometry::Cylinder{{0.0, 0.0, -3.0}, {0.0, 0.0, 0.0}, 1.0, false}, white);
  scene.sky(50.0);
  const auto seen = measure(scene.build(), visible_path_solver, downward(), 16, 64);
  check_near(seen, 50.0);
  // Every path arrives with all it set out with: nothing is random but its length.
  CHECK(seen.lanes[0].standard_error < float_rounding_path_solver * 50.0);
}

TEST_CASE("path: a spherical cavity with a hole has the closed form of its radiosity",
          "[radiometry][path]") {
  // Every element of a sphere sees every other alike: radiosity of a sunlit spot apart, a diffuse
  // cavity with an opening of relative area f and wall reflectance rho, isothermal at B under a
  // black sky, leaves eps / (1 - rho (1 - f)) B. Source: E. M. Sparrow & R. D. Cess, Radiation
  // Heat Transfer (1978), ch. 6.
  const double rho = GENERATE(0.3, 0.8);
  const double half_angle = 0.5;  // of the hole, rad
  const double hole = 0.5 * (1.0 - std::cos(half_angle));
  SmallScene scene = path_scene();
  const auto wall = scene.material(grey(rho), 300.0_K);
  scene.add(geometry::Sphere{{}, 1.0}, wall);
  // The hole is a black cold cap just inside the wall, a disc that closes it off: what lies behind
  // it is not seen, and the spherical cap and its chord have the same view factors.
  scene.add(
      geometry::Disc{{0.0, 0.0, std::cos(half_angle)}, {0.0, 0.0, -1.0}, std::sin(half_angle)},
      scene.material(grey(0.0), Kelvin{0.0}));
  const auto seen = measure(scene.build(), thermal_ir_path_solver, {{}, {0.0, 0.6, -0.8}}, 32, 256);
  for (int i = 0; i < thermal_ir_path_solver.count(); ++i) {
    const double expected = spectral::planck(thermal_ir_path_solver[i], 300.0_K).value *
                            (1.0 - rho) / (1.0 - rho * (1.0 - hole));
    const Estimate& lane = seen.lanes[static_cast<std::size_t>(i)];
    CAPTURE(rho, lane.mean, lane.standard_error, expected);
    CHECK(std::abs(lane.mean - expected) <
          4.0 * lane.standard_error + float_rounding_path_solver * expected);
  }
}

TEST_CASE("path: an ideal mirror shows the sun's disc with its own radiance",
          "[radiometry][path]") {
  SmallScene scene = path_scene();
  scene.add(geometry::Plane{{}, 10.0, 10.0},
            scene.material(with_path_solver(materials::Mirror{}, 0.5), Kelvin{0.0}));
  scene.add_body(0.0, 90.0, 1.0, 1000.0);
  const double sine = std::sin(degrees(1.0).value);
  const auto seen = measure(scene.build(), visible_path_solver, downward(), 4, 4);
  check_near(seen, 0.5 * 1000.0 / (std::numbers::pi * sine * sine));
}

TEST_CASE("path: a sun through a clear pane keeps its share, seen from below",
          "[radiometry][path]") {
  SmallScene scene = path_scene();
  materials::Material pane = with_path_solver(materials::ClearSheet{}, 0.1);
  pane.transmittance = spectral::Curve::constant(0.7);
  pane.emissivity.reset();
  scene.add(geometry::Plane{{}, 1000.0, 1000.0}, scene.material(grey(0.5), Kelvin{0.0}));
  scene.add(geometry::Plane{{0.0, 0.0, 2.0}, 1000.0, 1000.0}, scene.material(pane, Kelvin{0.0}));
  scene.add_body(0.0, 60.0, 0.266, 1000.0);
  const auto seen = measure(scene.build(), visible_path_solver, downward(1.0), 32, 128);
  // Between a floor of 0.5 and a pane that sends 0.1 back: a geometric series (mirror images of the
  // floor in the pane are as bright as the floor, which is endless here).
  const double sun = 0.7 * 1000.0 * std::sin(degrees(60.0).value) * std::numbers::inv_pi;
  check_near(seen, 0.5 * sun / (1.0 - 0.5 * 0.1), 1e-3);  // the plane ends: 1e-3 of the sphere
}

TEST_CASE("path: light that walk and shadow ray both find is counted once", "[radiometry][path]") {
  // A wide sun: walks meet it often. Closed form for an overhead disc: rho E / pi.
  SmallScene scene = path_scene();
  scene.add(geometry::Plane{{}, 10.0, 10.0}, scene.material(grey(1.0), Kelvin{0.0}));
  scene.add_body(0.0, 90.0, 40.0, 1000.0);
  const auto seen = measure(scene.build(), visible_path_solver, downward(), 16, 256);
  check_near(seen, 1000.0 * std::numbers::inv_pi);
  CHECK(seen.lanes[0].standard_error < 0.01 * seen.lanes[0].mean);
}

TEST_CASE("path: an overcast sky gives a level surface what an even one gives",
          "[radiometry][path]") {
  SmallScene scene = path_scene();
  scene.add(geometry::Plane{{}, 1000.0, 1000.0}, scene.material(grey(0.5), Kelvin{0.0}));
  scene.overcast(80.0);
  const auto seen = measure(scene.build(), visible_path_solver, downward(), 16, 256);
  check_near(seen, 40.0);
  CHECK(seen.lanes[0].standard_error < 0.01 * 40.0);
}

TEST_CASE("path: a wall under an overcast sky gets its closed form", "[radiometry][path]") {
  // Integral of 3/7 (1 + 2 cos z) over the quarter sphere that a wall sees, with its cosine:
  // L_sky 3/7 (pi/2 + 4/3), and below the horizon, where the sky is as at the horizon, 3/7 pi/2.
  SmallScene scene = path_scene();
  scene.add(geometry::Disc{{}, {0.0, -1.0, 0.0}, 1.0}, scene.material(grey(1.0), Kelvin{0.0}));
  scene.overcast(7.0);
  const auto seen =
      measure(scene.build(), visible_path_solver, {{0.0, -5.0, 0.0}, {0.0, 1.0, 0.0}}, 16, 1024);
  const double irradiance = 3.0 * (std::numbers::pi + 4.0 / 3.0);
  check_near(seen, irradiance * std::numbers::inv_pi);
}

TEST_CASE("path: a limit of bounces cuts the series where it says", "[radiometry][path]") {
  SmallScene scene = path_scene();
  scene.add(geometry::Sphere{{}, 5.0}, scene.material(grey(0.5), 300.0_K));
  scene.path_max_bounces = 3;
  const auto seen = measure(scene.build(), thermal_ir_path_solver, {{}, {0.0, 0.6, -0.8}}, 32, 256);
  const double expected =
      spectral::planck(thermal_ir_path_solver[1], 300.0_K).value * (1.0 - std::pow(0.5, 4.0));
  CHECK(std::abs(seen.lanes[1].mean - expected) <
        4.0 * seen.lanes[1].standard_error + float_rounding_path_solver * expected);
  CHECK(seen.counters.bounce_limit_stops > 0);
}

TEST_CASE("both solvers agree where the generic one has no bias", "[radiometry][path]") {
  // A grey corner under sun and sky; enough bounces and no decay: only noise is left.
  SmallScene scene;
  const auto material = scene.material(grey(0.4), 280.0_K);
  scene.add(geometry::Plane{{}, 100.0, 100.0}, material);
  scene.add(geometry::Box{{1.0, -50.0, 0.0}, {2.0, 50.0, 50.0}}, material);
  scene.add_body(225.0, 45.0, 0.266, 10.0);
  scene.sky(1.0);
  scene.solver = {.initial_sample_count = 3,
                  .sample_decay_rate = 1.0,
                  .max_bounces = 7,
                  .mu_samples = 2,
                  .phi_samples = 4};
  SceneDescription description = scene.build();
  const Measured generic = measure(description, thermal_ir_path_solver, downward(), 16, 64);
  description.method = Method::path;
  const Measured path = measure(description, thermal_ir_path_solver, downward(), 16, 1024);
  for (std::size_t lane = 0; lane < 3; ++lane) {
    const double error =
        std::hypot(generic.lanes[lane].standard_error, path.lanes[lane].standard_error);
    CAPTURE(generic.lanes[lane].mean, path.lanes[lane].mean, error);
    CHECK(error < 0.01 * path.lanes[lane].mean);
    // 0.4^8 = 7e-4 of what is left at the ninth generation
    CHECK(std::abs(generic.lanes[lane].mean - path.lanes[lane].mean) <
          4.0 * error + 7e-4 * path.lanes[lane].mean);
  }
}

}  // namespace
}  // namespace nadir::radiometry::test
