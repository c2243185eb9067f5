#include "sim/run/project.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "core/error.hpp"
#include "geometry/scene_builder.hpp"
#include "sim/gdal_tools.hpp"
#include "sim/geo_scene.hpp"
#include "sim/message_of.hpp"
#include "sim/products/csm_isd.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

namespace {

/// The camera of a made scene over a level square of 20 km at the site's height.
CameraScene over_ground(const support::GeoScene& made) {
  geometry::TriangleMesh ground;
  ground.positions = {{-1e4, -1e4, 0.0}, {1e4, -1e4, 0.0}, {1e4, 1e4, 0.0}, {-1e4, 1e4, 0.0}};
  ground.triangles = {{0, 1, 2}, {0, 2, 3}};
  geometry::SceneBuilder builder;
  ground.parts = {0, 0};
  ground.part_names = {""};
  builder.add({ground, {0}}, Affine{}, 0);
  Scenario scenario;
  scenario.time = made.geometry.time;
  return {std::move(scenario), made.geometry.frame, builder.build(), made.camera};
}

/// A Python that has numpy, or nothing.
std::string python_with_numpy() {
  for (const char* python : {"python3", "/usr/bin/python3"}) {
    const std::string line = std::string{python} + " -c 'import numpy' >/dev/null 2>&1";
    if (std::system(line.c_str()) == 0) return python;
  }
  return {};
}

}  // namespace

TEST_CASE("a place of the image comes back through the ground that it shows") {
  const auto made = support::drone();
  const CameraScene scene = over_ground(*made);
  const sensor::DetectorArray& array = scene.camera.arrays[0];
  for (const auto& image : image_grid(array, {5, 4}, true)) {
    const Projection shown = project(scene, array, ImagePlace{image});
    REQUIRE(shown.place);
    CHECK(shown.inside);
    CHECK(shown.place->z == Approx(0.0).margin(1e-3));  // floats of a scene of 10 km
    const Projection back = project(scene, array, LocalPlace{*shown.place});
    REQUIRE(back.image);
    CHECK(back.image->sample == Approx(image.sample).margin(1e-6));
    CHECK(back.image->line == Approx(image.line).margin(1e-6));
    CHECK_FALSE(back.hidden);
    const Projection again = project(scene, array, *shown.geodetic);
    CHECK(again.image->line == Approx(image.line).margin(1e-4));
  }
}

TEST_CASE("a height stands in for the ground, and a place below the ground is hidden") {
  const auto made = support::drone();
  const CameraScene scene = over_ground(*made);
  const sensor::DetectorArray& array = scene.camera.arrays[0];
  const Projection at = project(scene, array, ImagePlace{{640.0, 480.0}, 150.0});
  CHECK(at.geodetic->height_m == Approx(150.0).margin(1e-6));
  const Projection below = project(scene, array, ImagePlace{{640.0, 480.0}, 80.0});
  CHECK(project(scene, array, LocalPlace{*below.place}).hidden);
  CHECK_FALSE(project(scene, array, LocalPlace{{0.0, 0.0, 900.0}}).image);  // above the camera
}

TEST_CASE("a line of sight that goes down from below a height does not come to it") {
  const auto made = support::drone();
  const CameraScene scene = over_ground(*made);
  const sensor::DetectorArray& array = scene.camera.arrays[0];
  // The drone flies at 240 m. Just above it, and far above it.
  for (const double height_m : {240.1, 250.0, 5000.0}) {
    CHECK_FALSE(project(scene, array, ImagePlace{{640.0, 480.0}, height_m}).place);
  }
  CHECK(project(scene, array, ImagePlace{{640.0, 480.0}, 239.9}).place);
  // Upwards, a height above the camera is where the line of sight goes; one below it is not.
  const geometry::Ray up{{0.0, 0.0, 120.0}, normalised(Vec3{0.1, 0.2, 1.0})};
  const auto above = at_height(scene.frame, up, 5000.0);
  REQUIRE(above);
  CHECK(scene.frame.geodetic(*above).height_m == Approx(5000.0).margin(1e-5));
  CHECK_FALSE(at_height(scene.frame, up, 239.0));
}

TEST_CASE("places that are not of the earth are refused") {
  const auto made = support::drone();
  const CameraScene scene = over_ground(*made);
  const auto message = [&](const ProjectionPoint& point) {
    return support::message_of([&] { (void)project(scene, scene.camera.arrays[0], point); });
  };
  CHECK(message(geometry::Geodetic{95.0, 11.4, 0.0}) ==
        "error: latitude 95 lies outside -90 to 90 degrees\n");
  CHECK(message(geometry::Geodetic{45.0, 361.0, 0.0}) ==
        "error: longitude 361 lies outside -360 to 360 degrees\n");
  CHECK(message(ImagePlace{{640.0, 480.0}, std::nan("")}) ==
        "error: height nan is no number of metres\n");
}

TEST_CASE("a pushbroom's places have their own times") {
  const auto made = support::satellite();
  const CameraScene scene = over_ground(*made);
  const Projection first = project(scene, scene.camera.arrays[0], ImagePlace{{300.0, 0.5}, 120.0});
  const Projection last = project(scene, scene.camera.arrays[0], ImagePlace{{300.0, 499.5}, 120.0});
  CHECK(last.time_s - first.time_s == Approx(499 * 2.2e-3).epsilon(1e-12));
}

TEST_CASE("places far from the image are refused") {
  const auto made = support::drone();
  const CameraScene scene = over_ground(*made);
  CHECK(support::message_of([&] {
          (void)project(scene, scene.camera.arrays[0], ImagePlace{{5000.0, 1.0}});
        }) ==
        "error: sample 5000, line 1 lie outside the image of array frame, which has 1280 samples "
        "and 960 lines\n");
}

TEST_CASE("arrays are found by name, by band, or because there is one") {
  Camera camera;
  camera.arrays = {support::perspective(2, 2, 1e-6, 1e-3), support::perspective(2, 2, 1e-6, 1e-3)};
  camera.arrays[1].name = "other";
  camera.arrays[1].bands[0].name = "red";
  CHECK(find_array(camera, "other", "").name == "other");
  CHECK(find_array(camera, "", "red").name == "other");
  CHECK(
      support::message_of([&] { (void)find_array(camera, "", ""); }) ==
      "error: the camera has several arrays, name one with --array: frame (green), other (red)\n");
  CHECK(support::message_of([&] { (void)find_array(camera, "third", ""); }) ==
        "error: the camera has no such array or band; it has frame (green), other (red)\n");
}

TEST_CASE("tables of points are of one kind") {
  const auto places = read_projection_points("latitude_deg,longitude_deg,height_m\n45,11,3\n", "p");
  CHECK(std::get<geometry::Geodetic>(places.at(0)).height_m == 3.0);
  const auto images = read_projection_points("sample,line\n1.5,2\n", "p");
  CHECK_FALSE(std::get<ImagePlace>(images.at(0)).height_m);
  const auto high = read_projection_points("line,sample,height_m\n2,1.5,7\n", "p");
  CHECK(std::get<ImagePlace>(high.at(0)).image.sample == 1.5);
  CHECK(std::get<ImagePlace>(high.at(0)).height_m == 7.0);
  CHECK_THROWS_AS(read_projection_points("sample,east_m\n1,2\n", "p"), InputError);
}

TEST_CASE("an independent reader of the ISD projects as the program does") {
  const std::string python = python_with_numpy();
  if (python.empty()) {
    WARN("python3 with numpy is not installed: skipped");
    return;
  }
  const support::ScratchFolder folder;
  struct Case {
    bool frame;
    std::size_t module, modules;
  };
  for (const auto& one : {Case{true, 0, 1}, {false, 0, 1}, {false, 0, 2}, {false, 1, 2}}) {
    const auto made = one.frame ? support::drone() : support::satellite();
    if (one.modules == 2) {
      made->camera.arrays[0].modules = {{0, 250, 5e-6, -7e-4, 0.0}, {250, 350, -9e-6, 9e-4, 0.0}};
    }
    const CameraScene scene = over_ground(*made);
    std::vector<Projection> found;
    for (const double height_m : {20.0, 110.0}) {
      for (const auto& image : image_grid(made->array(), {5, 5}, true)) {
        found.push_back(project(scene, made->array(), ImagePlace{image, height_m}));
      }
    }
    std::ofstream{folder / "p.csv"} << to_text(found, ProjectionFormat::csv, scene.scenario.time);
    std::ofstream{folder / "isd.json"} << csm_isd(made->task(), 0, one.module);
    // 1e-5: 12 decimals of a degree are 1e-7 m, a hundred-thousandth of the drone's pixel.
    const auto result = support::run_tool(
        python + " " + NADIR_SOURCE_DIR + "/tools/check_isd.py --tolerance 1e-4 " +
        (folder / "isd.json").string() + " --points " + (folder / "p.csv").string());
    INFO(result.out << result.err);
    CHECK(result.status == 0);
    CHECK(result.out.rfind("50 places", 0) == (one.modules == 1 ? 0U : std::string::npos));
  }
}
