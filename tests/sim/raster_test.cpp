#include "sim/files/raster.hpp"

#include <cstdlib>
#include <fstream>

#include "core/error.hpp"
#include "geometry/earth.hpp"
#include "sim/files/modules.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

namespace {

namespace fs = std::filesystem;

/// Writes the small files of one test.
class Folder {
 public:
  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream{scratch_ / name, std::ios::binary} << text;
    return scratch_ / name;
  }

 private:
  support::ScratchFolder scratch_;
};

constexpr const char* wgs84 =
    "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],"
    "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]]";

// Universal Transverse Mercator, zone 17 north: central meridian 81 degrees west.
constexpr const char* utm17 =
    "PROJCS[\"UTM 17N\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,"
    "298.257223563]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],"
    "PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\",0],"
    "PARAMETER[\"central_meridian\",-81],PARAMETER[\"scale_factor\",0.9996],"
    "PARAMETER[\"false_easting\",500000],PARAMETER[\"false_northing\",0],UNIT[\"metre\",1]]";

constexpr const char* grid_text =
    "ncols 4\nnrows 3\nxllcorner -84.0\nyllcorner 36.0\ncellsize 0.5\nNODATA_value -9999\n"
    "1 2 3 4\n5 -9999 7 8\n9 10 11 12.25\n";

}  // namespace

TEST_CASE("a raster's values come row by row with NaN where there are none") {
  const Folder folder;
  const Raster raster = read_raster(folder.write("a.asc", grid_text));
  CHECK(raster.columns == 4);
  CHECK(raster.rows == 3);
  CHECK(raster.bands == 1);
  CHECK(raster.has_geotransform);
  CHECK_FALSE(raster.has_projection);
  REQUIRE(raster.values.size() == 12);
  CHECK(raster.values[0] == 1.0);
  CHECK(std::isnan(raster.values[5]));
  CHECK(raster.values[11] == 12.25);
}

TEST_CASE("posts of a height grid lie at the centres of the pixels") {
  const Folder folder;
  const fs::path file = folder.write("a.asc", grid_text);
  folder.write("a.prj", wgs84);
  const geometry::HeightGrid grid = read_height_grid(file, 100.0);
  CHECK(grid.columns == 4);
  CHECK(grid.rows == 3);
  REQUIRE(grid.posts.size() == 12);
  // The north-western pixel: the corner is at 84 W, 36 N + 3 * 0.5, the centre half a cell inside.
  CHECK(grid.posts[0].longitude_deg == Approx(-83.75).epsilon(1e-14));
  CHECK(grid.posts[0].latitude_deg == Approx(37.25).epsilon(1e-14));
  CHECK(grid.posts[0].height_m == 101.0);
  CHECK(grid.posts[11].longitude_deg == Approx(-82.25).epsilon(1e-14));
  CHECK(grid.posts[11].latitude_deg == Approx(36.25).epsilon(1e-14));
  CHECK(grid.posts[11].height_m == 112.25);
  CHECK(std::isnan(grid.posts[5].height_m));
}

TEST_CASE("a projected raster is taken to WGS84") {
  const Folder folder;
  const fs::path file = folder.write(
      "u.asc",
      "ncols 2\nnrows 2\nxllcorner 499000\nyllcorner 3999000\ncellsize 1000\n10 20\n30 40\n");
  folder.write("u.prj", utm17);
  const geometry::HeightGrid grid = read_height_grid(file, 0.0);
  // On the ground the posts are a kilometre apart over the scale 0.9996 of the central meridian
  // (at 500 m from it the scale is larger by 3e-9), whatever the projection's own formulae.
  const auto flat = [](geometry::Geodetic p) {
    return geometry::Geodetic{p.latitude_deg, p.longitude_deg, 0.0};
  };
  const geometry::LocalFrame ground{flat(grid.posts[0])};
  const Vec3 east = ground.enu(flat(grid.posts[1])), south = ground.enu(flat(grid.posts[2]));
  CHECK(length(east) == Approx(1000.0 / 0.9996).epsilon(1e-6));  // 1e-6: chord, and curvature
  CHECK(length(south) == Approx(1000.0 / 0.9996).epsilon(1e-6));
  CHECK(south.y < -1000.0);
  // Symmetric about 81 W; 4,000,000 m / 0.9996 of meridian arc from the equator is between 36 and
  // 37 N.
  CHECK(grid.posts[0].longitude_deg + grid.posts[1].longitude_deg == Approx(-162.0).epsilon(1e-12));
  CHECK(grid.posts[0].latitude_deg == Approx(36.1487).margin(1e-3).epsilon(0.0));
}

TEST_CASE("a raster of GDAL's own virtual kind has scale, offset and more bands") {
  const Folder folder;
  folder.write("a.asc", grid_text);
  const std::string band =
      "<SimpleSource><SourceFilename relativeToVRT=\"1\">a.asc</SourceFilename>"
      "<SourceBand>1</SourceBand></SimpleSource></VRTRasterBand>";
  const fs::path file = folder.write(
      "b.vrt",
      "<VRTDataset rasterXSize=\"4\" rasterYSize=\"3\">"
      "<VRTRasterBand dataType=\"Float32\" band=\"1\">" +
          band +
          "<VRTRasterBand dataType=\"Float32\" band=\"2\"><Offset>1000</Offset><Scale>0.5</Scale>" +
          band + "</VRTDataset>");
  const Raster raster = read_raster(file, 2);
  CHECK(raster.bands == 2);
  CHECK(raster.values[11] == 1000.0 + 0.5 * 12.25);
  CHECK_FALSE(raster.has_geotransform);
  CHECK_THROWS_WITH(read_raster(file, 3),
                    Catch::Matchers::Contains("2 bands, so there is no band 3"));
}

TEST_CASE("bounds cut a height grid to the pixels inside and one more all round") {
  const Folder folder;
  std::string text = "ncols 40\nnrows 30\nxllcorner 170\nyllcorner -15\ncellsize 0.5\n";
  for (int i = 0; i < 1200; ++i) text += std::to_string(i) + (i % 40 == 39 ? "\n" : " ");
  const fs::path file = folder.write("a.asc", text);
  folder.write("a.prj", wgs84);
  // Centres run 170.25, 170.75, ... and, from the top, -0.25, -0.75, ...
  const GeodeticBounds bounds{-2.0, 172.0, -1.0, 173.0};
  const geometry::HeightGrid grid = read_height_grid(file, 0.0, &bounds);
  CHECK(grid.columns == 4);  // 172.25 and 172.75, and one on either side
  CHECK(grid.rows == 4);
  CHECK(grid.posts[0].longitude_deg == Approx(171.75).epsilon(1e-14));
  CHECK(grid.posts[0].latitude_deg == Approx(-0.75).epsilon(1e-13));
  CHECK(grid.posts[0].height_m == 1 * 40 + 3);
  const GeodeticBounds across{-2.0, 179.0, -1.0, -179.0};  // over the date line
  CHECK(read_height_grid(file, 0.0, &across).columns == 6);
  const GeodeticBounds elsewhere{50.0, 0.0, 51.0, 1.0};
  CHECK_THROWS_WITH(read_height_grid(file, 0.0, &elsewhere),
                    Catch::Matchers::Contains("no pixel in the bounds"));
}

TEST_CASE("a raster that cannot be placed or read says what is missing") {
  const Folder folder;
  const fs::path bare = folder.write("a.asc", grid_text);
  CHECK_THROWS_WITH(read_height_grid(bare, 0.0),
                    Catch::Matchers::Contains("a.asc: error: the raster has no coordinate system"));
  const fs::path unplaced =
      folder.write("b.vrt",
                   "<VRTDataset rasterXSize=\"4\" rasterYSize=\"3\"><SRS>EPSG:4326</SRS>"
                   "<VRTRasterBand dataType=\"Float32\" band=\"1\"/></VRTDataset>");
  CHECK_THROWS_WITH(read_height_grid(unplaced, 0.0),
                    Catch::Matchers::Contains("has no geotransform"));
  CHECK_THROWS_AS(read_raster("/nowhere/a.tif"), InputError);
  CHECK_THROWS_WITH(read_raster("/nowhere/a.tif"), Catch::Matchers::Contains("/nowhere/a.tif"));
  CHECK_THROWS_AS(read_raster(folder.write("c.tif", "no raster at all")), InputError);
}

TEST_CASE("a module that is not there is named with the places that were searched") {
  CHECK_THROWS_WITH(module_symbol("nadir_nothing", "f"),
                    Catch::Matchers::Contains("libnadir_nothing.so is in none of these folders"));
  CHECK_THROWS_WITH(module_symbol("nadir_rasters", "no_such_function"),
                    Catch::Matchers::Contains("does not fit this program"));
  CHECK(module_directories().size() == (std::getenv("NADIR_MODULES") ? 1U : 3U));
}
