#include "sim/products/geotiff.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim/files/raster.hpp"
#include "sim/gdal_tools.hpp"
#include "sim/geo_images.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using Json = nlohmann::json;

namespace {

Json gdalinfo(const std::filesystem::path& file) {
  const auto result = support::run_tool("gdalinfo -json -mdd RPC " + file.string());
  CHECK(result.status == 0);
  CHECK(result.err.empty());  // opens without a warning
  return Json::parse(result.out);
}

}  // namespace

TEST_CASE("an orthographic image lies on a map to a ten-thousandth of a pixel") {
  const support::ScratchFolder folder;
  const auto scene = support::orthographic(0.5, 20.0);
  const Georeference place = georeference(scene->task());
  REQUIRE(place.map);
  CHECK(place.epsg == 32632);  // 11.4 degrees east
  CHECK(place.control.empty());
  CHECK(place.map_residual_px < 1e-4);
  support::write_counting_image<float>(folder / "m_radiance.img", scene->array(), 0.0);
  const auto files = write_geotiffs(scene->task(folder / "m"), place);
  REQUIRE(files.size() == 1);
  // GDAL, asked for the places of pixels, gives those of the camera. A map has no heights: 1e-7
  // degree is a centimetre, a fiftieth of the pixel.
  std::vector<Vec2> pixels;
  const auto images = image_grid(scene->array(), {4, 3}, true);
  for (const auto& image : images) pixels.push_back({image.sample, image.line});
  const auto places = locate_in_raster(folder / "m_radiance.tif", pixels);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto ground = ground_at(scene->geometry, scene->array(), images[i], 120.0);
    CHECK(places[i].latitude_deg == Approx(ground->geodetic.latitude_deg).margin(1e-10));
    CHECK(places[i].longitude_deg == Approx(ground->geodetic.longitude_deg).margin(1e-10));
  }
  CHECK(read_raster(folder / "m_radiance.tif").values[3] == 3.0);
}

TEST_CASE("coarse pixels over half a degree still have a map of their own") {
  const auto scene = support::orthographic(400.0, 0.0);  // 80 km
  const Georeference place = map_of(scene->task());
  REQUIRE(place.map);
  CHECK(place.map_residual_px <= most_map_residual_px);
}

TEST_CASE("cameras with a perspective have points and polynomials instead of a map") {
  const auto scene = support::satellite(60, 50);
  const Georeference place = georeference(scene->task());
  CHECK_FALSE(place.map);
  REQUIRE(place.control.size() == 81);
  CHECK(place.control.front().image == Vec2{0.0, 0.0});
  CHECK(place.control.back().image == Vec2{60.0, 50.0});
  CHECK(place.control[40].place.height_m == Approx(120.0).margin(1e-6));
}

TEST_CASE("an image of staggered modules gets no points that a reader would interpolate") {
  const auto scene = support::satellite(60, 50);
  auto& modules = scene->camera.arrays[0].modules;
  modules = {{0, 30, 0.0, 0.0, 0.0}, {30, 30, 0.0, 40.0 * 18e-6, 0.0}};
  const Georeference place = georeference(scene->task());
  CHECK(place.control.empty());
  CHECK_FALSE(place.rpc);
  REQUIRE(scene->diagnostics.messages().size() == 1);
  CHECK(scene->diagnostics.messages()[0] ==
        "array line: its GeoTIFF is not georeferenced: from module to module the image jumps by up "
        "to 40 pixels, which neither control points nor rational polynomials can say; NetCDF holds "
        "every pixel's place");
  // A tenth of a pixel is within what polynomials may be off by.
  modules[1].offset_y_m = 0.1 * 18e-6;
  CHECK(georeference(scene->task()).control.size() == 81);
}

TEST_CASE("polynomials that cannot be fitted are missed with a reason") {
  const auto scene = support::drone();
  // Pitched up until only the image's lowest rows see the earth.
  scene->camera.platform = sensor::Platform{
      sensor::from_euler({15.0, -8.0, 120.0}, Mat3{}, degrees(30.0), degrees(15.0), degrees(0.0))};
  const Georeference place = georeference(scene->task());
  CHECK_FALSE(place.control.empty());
  CHECK_FALSE(place.rpc);
  REQUIRE(scene->diagnostics.messages().size() == 1);
  CHECK(scene->diagnostics.messages()[0] ==
        "array frame: no rational polynomials: too few lines of sight meet the earth");
}

TEST_CASE("control points run on across the date line") {
  const auto scene = support::drone();
  scene->geometry.frame = geometry::LocalFrame{{45.2, 179.9999, 120.0}};
  const Georeference place = georeference(scene->task());
  REQUIRE(place.control.size() == 81);
  double west = 1e9, east = -1e9;
  for (const ControlPoint& point : place.control) {
    west = std::min(west, point.place.longitude_deg);
    east = std::max(east, point.place.longitude_deg);
  }
  CHECK(east - west < 0.01);  // some 150 m
  CHECK(((west < 180.0 && east > 180.0) || (west < -180.0 && east > -180.0)));
  CHECK(place.rpc);
}

TEST_CASE("digital numbers keep their scale and bands their wavelengths") {
  if (!support::has_gdal_tools()) {
    WARN("gdal-bin is not installed: skipped");
    return;
  }
  const support::ScratchFolder folder;
  const auto scene = support::satellite(700, 600);
  scene->camera.arrays[0].bands.push_back(
      {"red", spectral::BoxResponse{Micrometres{0.6}, Micrometres{0.7}}});
  scene->context.calibrations = {{{0.25, 1.5}, {0.125, -2.0}}};
  support::write_counting_image<float>(folder / "s_radiance.img", scene->array(), 0.5);
  support::write_counting_image<std::uint16_t>(folder / "s_dn.img", scene->array(), 7.0);
  const GeoTask task = scene->task(folder / "s");
  CHECK(write_geotiffs(task, georeference(task)).size() == 2);
  const Json info = gdalinfo(folder / "s_dn.tif");
  CHECK(info["gcps"]["gcpList"].size() == 81);
  CHECK_FALSE(info.contains("geoTransform"));
  CHECK(info["metadata"][""]["SATELLITEID"] == "made-1");
  CHECK(info["metadata"][""]["ACQUISITIONDATETIME"] == "2024-06-21 10:12:13");
  CHECK(info["metadata"]["IMAGE_STRUCTURE"]["LAYOUT"] == "COG");
  CHECK(info["metadata"]["RPC"]["LINE_OFF"] == "299.5");
  const Json& red = info["bands"][1];
  CHECK(red["description"] == "red");
  CHECK(red["scale"] == 0.125);
  CHECK(red["offset"] == -2.0);
  CHECK(red["metadata"][""]["CENTRAL_WAVELENGTH_UM"] == "0.65");
  CHECK(red["overviews"].size() == 1);
  CHECK(gdalinfo(folder / "s_radiance.tif")["bands"][0]["noDataValue"] == "NaN");
  // Scale and offset applied: 1007 x 0.125 - 2.
  CHECK(read_raster(folder / "s_dn.tif", 2).values[0] == 123.875);
}

TEST_CASE("GDAL's transformer by polynomials agrees with the camera") {
  if (!support::has_gdal_tools()) {
    WARN("gdal-bin is not installed: skipped");
    return;
  }
  const support::ScratchFolder folder;
  const auto scene = support::satellite(300, 200);
  support::write_counting_image<float>(folder / "s_radiance.img", scene->array(), 0.0);
  const GeoTask task = scene->task(folder / "s");
  const Georeference place = georeference(task);
  (void)write_geotiffs(task, place);
  std::ostringstream input;
  input.precision(17);
  const auto images = image_grid(scene->array(), {6, 5}, true);
  for (const auto& image : images) {
    const auto at = ground_at(scene->geometry, scene->array(), image, 150.0)->geodetic;
    input << at.longitude_deg << ' ' << at.latitude_deg << ' ' << at.height_m << '\n';
  }
  const auto result = support::run_tool(
      "gdaltransform -rpc -i " + (folder / "s_radiance.tif").string(), input.str());
  std::istringstream lines{result.out};
  for (const auto& image : images) {
    double x = 0.0, y = 0.0, z = 0.0;
    lines >> x >> y >> z;
    const double off = std::hypot(x - image.sample, y - image.line);
    CHECK(off < 2.0 * place.rpc->largest_px + 1e-6);  // of text with 12 digits
  }
}
