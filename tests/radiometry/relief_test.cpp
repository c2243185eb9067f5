#include <cmath>
#include <numbers>

#include "radiometry/small_scene.hpp"
#include "support/catch.hpp"

// Bumps turn the normal that light sees; they must neither lose nor create any.

namespace nadir::radiometry::test {
namespace {

const spectral::Lanes one_lane_relief{{0.55_um}};
const spectral::Lanes thermal_ir_relief{{10.9_um}};

materials::Material bumpy(double reflectance, Vec2 slope, materials::MapFrame::By by) {
  materials::Material material = grey(reflectance);
  materials::ReliefMap relief;
  relief.frame.by = by;
  relief.frame.columns = relief.frame.rows = 1;
  relief.frame.repeats = true;
  relief.slope = {slope};
  material.relief = std::make_shared<const materials::ReliefMap>(std::move(relief));
  return material;
}

/// A level square whose texture runs east and north, or, mirrored, west and north.
geometry::TriangleMesh square(bool mirrored) {
  const double u = mirrored ? -1.0 : 1.0;
  return {{{-5.0, -5.0, 0.0}, {5.0, -5.0, 0.0}, {5.0, 5.0, 0.0}, {-5.0, 5.0, 0.0}},
          {{0, 1, 2}, {0, 2, 3}},
          {{0.0, 0.0}, {u, 0.0}, {u, 1.0}, {0.0, 1.0}},
          {0, 0},
          {"square"}};
}

TEST_CASE("a slope towards north turns away from a southern sun, mirrored texture or not",
          "[radiometry][relief]") {
  // dz/dv = 0.5 on a map whose v runs north in both cases: normal (0, -0.5, 1) / sqrt(1.25).
  const bool mirrored = GENERATE(false, true);
  SmallScene scene;
  scene.method = Method::path;
  const auto material =
      scene.material(bumpy(0.5, {0.0, 0.5}, materials::MapFrame::By::texture), Kelvin{0.0});
  scene.add(square(mirrored), material);
  scene.add_body(180.0, 30.0, 1e-3, 1000.0);
  const Estimate seen = measure(scene.build(), one_lane_relief, downward(), 4, 16).lanes[0];
  const double elevation = degrees(30.0).value;
  const double cosine = (0.5 * std::cos(elevation) + std::sin(elevation)) / std::sqrt(1.25);
  CAPTURE(mirrored);
  // 1e-4: the disc of a thousandth of a degree and float lanes
  CHECK(seen.mean == Approx(0.5 * 1000.0 * cosine * std::numbers::inv_pi).epsilon(1e-4));
}

TEST_CASE("a relief draped on a ceiling counts north as on the ground", "[radiometry][relief]") {
  // Heights of a relief count outwards, here down: bumps that grow towards north turn the ceiling's
  // normal (0, 0, -1) into (0, -0.3, -1) / sqrt(1.09), towards a lamp in the south.
  const auto lit_from = [&](double north) {
    SmallScene scene;
    scene.method = Method::path;
    scene.add(geometry::Disc{{0.0, 0.0, 3.0}, {0.0, 0.0, -1.0}, 1.0},
              scene.material(bumpy(1.0, {0.0, 0.3}, materials::MapFrame::By::ground), Kelvin{0.0}));
    Lamp lamp;
    lamp.name = "lamp";
    lamp.form = PointLamp{{0.0, north, 0.0}};
    lamp.flux = spectral::Curve::constant(100.0);
    scene.lamps.push_back(lamp);
    return measure(scene.build(), one_lane_relief, {{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}, 4, 4)
        .lanes[0]
        .mean;
  };
  // Lambert: f E cos / d^2 with I = 100 / 4 pi.
  const auto expected = [](double north) {
    const double d2 = north * north + 9.0;
    const double cosine = (3.0 - 0.3 * north) / std::sqrt(1.09 * d2);
    return std::numbers::inv_pi * 100.0 / (4.0 * std::numbers::pi) * cosine / d2;
  };
  CHECK(lit_from(4.0) == Approx(expected(4.0)).epsilon(1e-5));  // float lanes
  CHECK(lit_from(-4.0) == Approx(expected(-4.0)).epsilon(1e-5));
}

TEST_CASE("a bumped surface in a furnace is a black body: nothing is lost below its bumps",
          "[radiometry][relief]") {
  const double slope = GENERATE(0.2, 0.6, 1.5);
  SmallScene scene;
  scene.add(geometry::Plane{{}, 10.0, 10.0},
            scene.material(bumpy(0.9, {slope, 0.0}, materials::MapFrame::By::ground), 300.0_K));
  scene.sky(0.0, 300.0_K);
  scene.solver = {.initial_sample_count = 4, .mu_samples = 4, .phi_samples = 8};
  SceneDescription description = scene.build();
  const double expected = spectral::planck(10.9_um, 300.0_K).value;
  for (const Method method : {Method::path, Method::generic}) {
    description.method = method;
    const geometry::Ray ray{{-10.0, 0.0, 10.0}, normalised({1.0, 0.0, -1.0})};
    const Estimate seen = measure(description, thermal_ir_relief, ray, 16, 256).lanes[0];
    CAPTURE(slope, seen.mean, seen.standard_error);
    // float lanes; the path solver has no noise here, the quads a little
    CHECK(std::abs(seen.mean - expected) < 4.0 * seen.standard_error + 1e-5 * expected);
    CHECK(seen.standard_error < 2e-3 * expected);
  }
}

TEST_CASE("light that a bump folds back is found by walk and shadow ray alike",
          "[radiometry][relief]") {
  // A wide sun low in the east over slopes that face it: part of every lobe is folded.
  SmallScene scene;
  materials::Material shiny = bumpy(0.2, {-0.8, 0.0}, materials::MapFrame::By::ground);
  shiny.scattering = materials::Ward{spectral::Curve::constant(0.5), 0.4, 0.4};
  scene.add(geometry::Plane{{}, 10.0, 10.0}, scene.material(shiny, Kelvin{0.0}));
  scene.add_body(90.0, 15.0, 14.0, 1000.0);
  scene.solver = {.initial_sample_count = 8, .mu_samples = 4, .phi_samples = 8};
  SceneDescription description = scene.build();
  const geometry::Ray ray{{-10.0, 0.0, 10.0}, normalised({1.0, 0.0, -1.0})};
  const Estimate generic = measure(description, one_lane_relief, ray, 16, 1024).lanes[0];
  description.method = Method::path;
  const Estimate path = measure(description, one_lane_relief, ray, 16, 4096).lanes[0];
  const double error = std::hypot(generic.standard_error, path.standard_error);
  CAPTURE(generic.mean, path.mean, error);
  CHECK(error < 0.01 * path.mean);
  CHECK(std::abs(generic.mean - path.mean) < 4.0 * error);
}

TEST_CASE("a pane in a mixture lets lamps through like the pane itself", "[radiometry][lamps]") {
  const bool mixed = GENERATE(false, true);
  SmallScene scene;
  scene.method = Method::path;
  auto pane = std::make_shared<materials::Material>(grey(0.1));
  pane->transmittance = spectral::Curve::constant(0.8);
  pane->scattering = materials::ClearSheet{};
  materials::Material window = *pane;
  if (mixed) {
    window = materials::Material{};
    window.name = "window";
    window.scattering = materials::Mixture{{{0.5, pane}}};  // half of it is black frame
  }
  scene.add(geometry::Plane{{}, 100.0, 100.0}, scene.material(grey(0.5), Kelvin{0.0}));
  scene.add(geometry::Disc{{0.0, 0.0, 2.0}, {0.0, 0.0, 1.0}, 0.5},
            scene.material(window, Kelvin{0.0}));
  Lamp lamp;
  lamp.name = "lamp";
  lamp.form = PointLamp{{0.0, 0.0, 4.0}};
  lamp.flux = spectral::Curve::constant(100.0);
  scene.lamps.push_back(lamp);
  const Estimate seen = measure(scene.build(), one_lane_relief,
                                {{3.0, 0.0, 1.5}, normalised({-3.0, 0.0, -1.5})}, 16, 256)
                            .lanes[0];
  const double through = mixed ? 0.4 : 0.8;
  const double direct =
      0.5 * std::numbers::inv_pi * through * 100.0 / (4.0 * std::numbers::pi) / 16.0;
  CAPTURE(mixed, seen.mean, seen.standard_error, direct);
  // The pane sends 0.1 of what the floor reflects back to it: its view factor from the floor below
  // is 0.5^2 / (0.5^2 + 2^2) = 0.06, so at most 0.3 % more of what the lit floor around reflects.
  CHECK(seen.mean > direct * 0.999);
  CHECK(seen.mean < direct * 1.02 + 4.0 * seen.standard_error);
}

}  // namespace
}  // namespace nadir::radiometry::test
