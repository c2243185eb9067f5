#include "sim/products/stac_item.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/geo_images.hpp"
#include "sim/products/geo_products.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using Json = nlohmann::json;

TEST_CASE("a satellite's item says where, when and from where it looked") {
  const auto scene = sim::support::satellite();
  const Json item = Json::parse(stac_item(scene->task("out/line"), {}, {}));
  CHECK(item["type"] == "Feature");
  CHECK(item["stac_version"] == "1.1.0");
  const Json& properties = item["properties"];
  CHECK(properties["platform"] == "made-1");
  CHECK(properties["sat:orbit_state"] == "descending");  // the sun-synchronous morning
  CHECK(properties["datetime"] == "2024-06-21T10:12:13.25Z");
  CHECK(properties["start_datetime"] < properties["end_datetime"]);
  // Rolled by 3 degrees, and 40 rows of 0.02 mrad ahead of it.
  const double off_nadir = std::hypot(3.0, 40.0 * 18e-6 / 0.886 * 57.29578);
  CHECK(properties["view:off_nadir"].get<double>() == Approx(off_nadir).margin(2e-3));
  // The earth's curvature adds what the swath subtends at its centre: 705 km tan 3 / 6371 km.
  CHECK(properties["view:incidence_angle"].get<double>() == Approx(3.33).margin(0.02));
  CHECK(properties["gsd"].get<double>() == Approx(14.6).margin(0.4));
  CHECK(properties["view:sun_elevation"].get<double>() > 45.0);
  CHECK(item["bbox"].size() == 4);
  const Json& ring = item["geometry"]["coordinates"][0];
  CHECK(ring.front() == ring.back());
  double area = 0.0;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    area += ring[i][0].get<double>() * ring[i + 1][1].get<double>() -
            ring[i + 1][0].get<double>() * ring[i][1].get<double>();
  }
  CHECK(area > 0.0);  // counter-clockwise
  CHECK(properties["bands"][0]["eo:common_name"] == "green");
}

TEST_CASE("staggered modules that meet in the middle of the image leave its pixels their size") {
  const auto scene = sim::support::satellite();
  const auto gsd = [&] {
    const Json item = Json::parse(stac_item(scene->task("out/line"), {}, {}));
    const Json& properties = item["properties"];
    CHECK(properties["bands"][0]["raster:spatial_resolution"] == properties["gsd"]);
    return properties["gsd"].get<double>();
  };
  const double even_m = gsd();
  // A hundred rows apart: 1.5 km on the ground.
  scene->camera.arrays[0].modules = {{0, 300, 0.0, -9e-4, 0.0}, {300, 300, 0.0, 9e-4, 0.0}};
  // The height of the ground point differs by nothing: the same pixel.
  CHECK(gsd() == Approx(even_m).epsilon(1e-6));
}

TEST_CASE("the view's azimuth leads from below the camera to the scene") {
  const auto scene = sim::support::drone();
  const Json item = Json::parse(stac_item(scene->task("out/frame"), {}, {}));
  // Yaw 30; the image's middle lies half a degree off the axis, which is tilted by 15.
  CHECK(item["properties"]["view:azimuth"].get<double>() == Approx(30.0).margin(2.5));
  CHECK(item["properties"]["view:off_nadir"].get<double>() == Approx(15.0).margin(0.6));
}

TEST_CASE("an item on a map has its projection, and one at rest no orbit") {
  const auto scene = sim::support::orthographic(0.5, 20.0);
  const GeoTask task = scene->task("out/map");
  const Json item = Json::parse(stac_item(task, map_of(task), {}));
  CHECK(item["properties"]["proj:code"] == "EPSG:32632");
  CHECK(item["properties"]["proj:shape"] == Json({150, 200}));
  CHECK(item["properties"]["proj:transform"].size() == 9);
  CHECK_FALSE(item["properties"].contains("sat:orbit_state"));
  CHECK(item["properties"]["gsd"].get<double>() == Approx(0.5).epsilon(1e-4));
  CHECK(item["properties"]["view:off_nadir"].get<double>() == Approx(0.0).margin(1e-3));
}

TEST_CASE("all products of an array are written and listed as the item's assets") {
  const sim::support::ScratchFolder folder;
  const auto scene = sim::support::satellite(40, 30);
  sim::support::write_counting_image<float>(folder / "line_radiance.img", scene->array(), 0.0);
  sim::support::write_counting_image<std::uint16_t>(folder / "line_dn.img", scene->array(), 0.0);
  scene->context.wanted.geotiff = scene->context.wanted.netcdf = true;
  scene->context.calibrations = {{{0.5, 0.25}}};
  const auto stem = folder / "line";
  const auto files = write_geo_products(
      scene->context, 0, stem, {{"radiance", "line", stem.string() + "_radiance.img", 4800}});
  REQUIRE(files.size() == 5);  // two GeoTIFFs, swath, ISD, item
  const Json item = Json::parse(sim::support::content_of(stem.string() + "_stac.json"));
  const Json& assets = item["assets"];
  CHECK(assets.size() == 5);  // the same but the item, and the image
  CHECK(assets["radiance_img"]["href"] == "./line_radiance.img");
  CHECK(assets["dn_tif"]["bands"][0]["raster:scale"] == 0.5);
  CHECK(assets["dn_tif"]["bands"][0]["raster:offset"] == 0.25);
  CHECK(assets["nc"]["type"] == "application/netcdf");
  CHECK(assets["green_isd_json"]["roles"] == Json({"metadata"}));
}
