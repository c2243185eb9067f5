#include "sim/products/netcdf_swath.hpp"

#include <nlohmann/json.hpp>

#include "sim/files/raster.hpp"
#include "sim/gdal_tools.hpp"
#include "sim/geo_images.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using Json = nlohmann::json;

namespace {

struct Swath {
  support::ScratchFolder folder;
  std::unique_ptr<support::GeoScene> scene = support::satellite(70, 90);

  Swath() {
    support::write_counting_image<float>(folder / "s_radiance.img", scene->array(), 0.5);
    support::write_counting_image<float>(folder / "s_error.img", scene->array(), 0.25);
  }
  [[nodiscard]] std::filesystem::path write() const {
    const auto files = write_netcdf_swath(scene->task(folder / "s"));
    REQUIRE(files.size() == 1);
    return files[0].path;
  }
};

}  // namespace

TEST_CASE("a swath holds radiance and its error, and where and when every pixel was seen") {
  if (!support::has_gdal_tools()) {
    WARN("gdal-bin is not installed: skipped");
    return;
  }
  const Swath swath;
  const auto file = swath.write();
  const auto result = support::run_tool("gdalmdiminfo -detailed " + file.string());
  CHECK(result.err.empty());
  const Json info = Json::parse(result.out);
  CHECK(info["attributes"]["Conventions"]["value"] == "CF-1.10");
  const Json& arrays = info["arrays"];
  const Json& radiance = arrays["radiance"];
  CHECK(radiance["attributes"]["standard_name"]["value"] ==
        "toa_outgoing_radiance_per_unit_wavelength");
  CHECK(radiance["attributes"]["ancillary_variables"]["value"] == "radiance_error");
  CHECK(radiance["unit"] == "W m-2 sr-1 um-1");
  CHECK(radiance["dimension_size"] == Json({1, 90, 70}));
  CHECK(radiance["values"][0][0][3] == 3.5);
  CHECK(radiance["values"][0][89][69] == (90 * 70 - 1) % 500 + 0.5);
  CHECK(arrays["radiance_error"]["values"][0][0][3] == 3.25);
  CHECK(arrays["wavelength"]["values"][0].get<double>() == Approx(0.56).epsilon(1e-6));
  CHECK(arrays["band_name"]["values"][0] == "green");
  CHECK(arrays["time"]["unit"] == "seconds since 2024-06-21 10:12:13.25 UTC");
  const auto& array = swath.scene->array();
  CHECK(arrays["time"]["values"][7].get<double>() ==
        Approx(sensor::image_time_s(array, {35.0, 7.5})).epsilon(1e-14));
  const auto ground = ground_at(swath.scene->geometry, array, {12.5, 7.5});
  CHECK(arrays["latitude"]["values"][7][12].get<double>() ==
        Approx(ground->geodetic.latitude_deg).epsilon(1e-14));
  CHECK(arrays["longitude"]["values"][7][12].get<double>() ==
        Approx(ground->geodetic.longitude_deg).epsilon(1e-14));
  CHECK(arrays["height"]["values"][7][12].get<double>() == Approx(120.0).margin(1e-5));
}

TEST_CASE("GDAL's readers of two dimensions take the first line for the last unless told not to") {
  if (!support::has_gdal_tools()) {
    WARN("gdal-bin is not installed: skipped");
    return;
  }
  const Swath swath;
  const std::string image = "'NETCDF:\"" + swath.write().string() + "\":radiance'";
  const auto found = support::run_tool(
      "gdallocationinfo --config GDAL_NETCDF_BOTTOMUP NO -valonly " + image + " 3 0");
  CHECK(found.status == 0);
  CHECK(found.out == "3.5\n");
}

TEST_CASE("the same image gives the same swath, and no other files stay") {
  const Swath swath;
  const auto first = support::content_of(swath.write());
  CHECK(support::content_of(swath.write()) == first);
  CHECK(swath.folder.entries() == 5);
}

TEST_CASE("places of the truth are taken where there are any") {
  const Swath swath;
  const GeoTask task = swath.scene->task(swath.folder / "s");
  write_places(task.with("_place.img"), swath.scene->geometry, swath.scene->array());
  CHECK(read_raster(task.with("_place.img"), 3).values[5] == Approx(120.0).margin(1e-5));
  (void)swath.write();
  CHECK(std::filesystem::exists(task.with("_place.img")));
}
