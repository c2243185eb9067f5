#include "sim/run/load_temperature.hpp"

#include <fstream>

#include "core/error.hpp"
#include "sim/message_of.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

namespace {

namespace fs = std::filesystem;

ephemeris::Instant temperature_utc(const char* text) { return ephemeris::Instant::parse_utc(text); }

/// A folder of small rasters, and what loading them needs.
class Loading {
 public:
  /// Three columns and two rows.
  fs::path raster(const std::string& name, const std::string& values) const {
    std::ofstream{scratch_ / name, std::ios::binary}
        << "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\nNODATA_value -9999\n"
        << values;
    return scratch_ / name;
  }
  fs::path text(const std::string& name, const std::string& content) const {
    std::ofstream{scratch_ / name, std::ios::binary} << content;
    return scratch_ / name;
  }
  thermal::MappedTemperature load(const TemperatureRasterInput& input, const char* moment) {
    return load_temperature_raster(input, temperature_utc(moment), {&frame_, &diagnostics_},
                                   files_);
  }
  std::string message(const TemperatureRasterInput& input, const char* moment) {
    return support::message_of([&] { (void)load(input, moment); });
  }
  InputFiles& files() { return files_; }
  [[nodiscard]] std::vector<std::string> warnings() const { return diagnostics_.messages(); }

 private:
  support::ScratchFolder scratch_;
  geometry::LocalFrame frame_{{36.0, -84.0, 0.0}};
  Diagnostics diagnostics_;
  InputFiles files_;
};

/// Over 30 m x 20 m about the origin.
TemperatureRasterInput draped(std::vector<TemperatureRasterInput::Slice> slices) {
  TemperatureRasterInput input;
  input.slices = std::move(slices);
  input.place.drape = GroundDrape{GroundArea{-15.0, -10.0, 15.0, 10.0}};
  input.where = {"yard.xml", 7, 5};
  return input;
}

geometry::TriangleMesh one_triangle(std::vector<float> values) {
  geometry::TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.vertex_values = std::move(values);
  return mesh;
}

}  // namespace

TEST_CASE("a raster becomes temperatures by gain and offset, first row in the north",
          "[sim][temperature]") {
  Loading loading;
  const fs::path file = loading.raster("a.asc", "1 2 3\n4 5 6.5\n");
  TemperatureRasterInput input = draped({{file, 1, std::nullopt}});
  input.gain = 2.0;
  input.offset_k = 270.0;
  const auto map = loading.load(input, "2020-06-01T12:00:00Z");
  CHECK(map.kelvin == std::vector<float>{272.0F, 274.0F, 276.0F, 278.0F, 280.0F, 283.0F});
  CHECK(map.frame.columns == 3);
  CHECK(map.frame.rows == 2);
  CHECK(map.frame.pixels({-15.0, 10.0}) == Vec2{0.0, 0.0});
  CHECK(map.frame.pixels({15.0, -10.0}) == Vec2{3.0, 2.0});
  CHECK(loading.files().all().count(file) == 1);
  CHECK(loading.warnings().empty());
}

// Three slices, given out of order. 1e-6: floats near 300 are good to 1.5e-5 K, 5e-8 of it.
TEST_CASE("of several rasters the two about the moment are mixed", "[sim][temperature]") {
  Loading loading;
  const auto ten = temperature_utc("2020-06-01T10:00:00Z"),
             noon = temperature_utc("2020-06-01T12:00:00Z"),
             four = temperature_utc("2020-06-01T16:00:00Z");
  const auto input = draped({{loading.raster("c.asc", "300 300 300\n300 300 300\n"), 1, noon},
                             {loading.raster("a.asc", "280 290 300\n280 290 300\n"), 1, ten},
                             {loading.raster("z.asc", "400 400 400\n400 400 400\n"), 1, four}});
  const auto check = [&](const char* moment, float first, float second) {
    CAPTURE(moment);
    const auto map = loading.load(input, moment);
    CHECK(map.kelvin[0] == Approx(first).epsilon(1e-6));
    CHECK(map.kelvin[4] == Approx(second).epsilon(1e-6));
  };
  check("2020-06-01T10:00:00Z", 280.0F, 290.0F);
  check("2020-06-01T10:30:00Z", 285.0F, 292.5F);
  CHECK(loading.files().all().size() == 2);  // the third is not opened
  check("2020-06-01T12:00:00Z", 300.0F, 300.0F);
  check("2020-06-01T13:00:00Z", 325.0F, 325.0F);
  check("2020-06-01T16:00:00Z", 400.0F, 400.0F);
  CHECK(loading.message(input, "2020-06-01T09:59:59Z") ==
        "yard.xml:7:5: error: the rasters run from 2020-06-01T10:00:00Z to 2020-06-01T16:00:00Z, "
        "which does not cover 2020-06-01T09:59:59Z\n");
  CHECK(loading.message(input, "2020-06-02T00:00:00Z").find("does not cover") != std::string::npos);
}

TEST_CASE("a lone raster of another hour stands for the moment, with a warning",
          "[sim][temperature]") {
  Loading loading;
  const fs::path file = loading.raster("a.asc", "1 2 3\n4 5 6\n");
  const auto input = draped({{file, 1, temperature_utc("2020-06-01T12:00:00Z")}});
  CHECK(loading.load(input, "2020-06-01T12:30:00Z").kelvin[0] == 1.0F);
  CHECK(loading.warnings().empty());
  CHECK(loading.load(input, "2020-06-01T15:00:00Z").kelvin[0] == 1.0F);
  CHECK(loading.warnings() ==
        std::vector<std::string>{file.string() +
                                 ": temperatures of 2020-06-01T12:00:00Z stand for "
                                 "2020-06-01T15:00:00Z: give a second raster to let them change"});
}

TEST_CASE("pixels that have no temperature are mistakes with their place", "[sim][temperature]") {
  Loading loading;
  const char* const noon = "2020-06-01T12:00:00Z";
  const auto message = [&](const std::string& values, double gain) {
    TemperatureRasterInput input = draped({{loading.raster("a.asc", values), 1, std::nullopt}});
    input.gain = gain;
    const std::string whole = loading.message(input, noon);
    return whole.substr(whole.find("error: "));
  };
  CHECK(message("300 300 300\n300 -9999 300\n", 1.0) ==
        "error: the pixel in column 2, row 2 (the first is 1, 1) has no value, and so no "
        "temperature\n");
  CHECK(message("300 -4.5 300\n300 300 300\n", 1.0) ==
        "error: the pixel in column 2, row 1 (the first is 1, 1) gives -4.5 K; temperatures are "
        "from 0 to 6000 K\n"
        "    hint: values in degrees Celsius need an offset of 273.15 K\n");
  CHECK(message("300 300 301\n300 300 300\n", 20.0) ==
        "error: the pixel in column 3, row 1 (the first is 1, 1) gives 6020 K; temperatures are "
        "from 0 to 6000 K\n");
}

TEST_CASE("rasters of several times must agree and have times", "[sim][temperature]") {
  Loading loading;
  const auto ten = temperature_utc("2020-06-01T10:00:00Z"),
             noon = temperature_utc("2020-06-01T12:00:00Z");
  const fs::path six = loading.raster("a.asc", "280 290 300\n280 290 300\n");
  const fs::path two =
      loading.text("b.asc", "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 10\n300 300\n");
  const char* const eleven = "2020-06-01T11:00:00Z";
  CHECK(loading.message(draped({{six, 1, ten}, {two, 1, noon}}), eleven) ==
        two.string() + ": error: the raster has 2 x 1 pixels, that of the time before (" +
            six.string() + ") has 3 x 2\n");
  CHECK(loading.message(draped({{six, 1, ten}, {six, 1, std::nullopt}}), eleven) ==
        six.string() + ": error: a raster that is one of several needs its time\n");
  CHECK(loading.message(draped({{six, 1, ten}, {six, 1, ten}}), eleven) ==
        six.string() + ": error: two rasters have the time 2020-06-01T10:00:00Z\n");
  CHECK(loading.message(draped({}), eleven) ==
        "yard.xml:7:5: error: temperatures from no raster at all\n");
}

TEST_CASE("georeferenced rasters of several times must lie in the same place",
          "[sim][temperature]") {
  Loading loading;
  const auto degrees = [&](const std::string& name, const std::string& west) {
    loading.text(name + ".prj",
                 "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,"
                 "298.257223563]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]]");
    return loading.text(name + ".asc", "ncols 2\nnrows 2\nxllcorner " + west +
                                           "\nyllcorner 35.999\ncellsize 0.001\n"
                                           "280 290\n300 310\n");
  };
  const auto ten = temperature_utc("2020-06-01T10:00:00Z"),
             noon = temperature_utc("2020-06-01T12:00:00Z");
  const fs::path here = degrees("here", "-84.001"), again = degrees("again", "-84.001"),
                 beside = degrees("beside", "-84.0005");  // by half a pixel
  TemperatureRasterInput input = draped({{here, 1, ten}, {again, 1, noon}});
  input.place.drape = GroundDrape{};
  const char* const eleven = "2020-06-01T11:00:00Z";
  // Its middle is the scene's origin; 1e-4 of a pixel of 100 m is 1 cm, what bending
  // of meridians leaves.
  const Vec2 middle = loading.load(input, eleven).frame.pixels({0.0, 0.0});
  CHECK(middle.x == Approx(1.0).margin(1e-4));
  CHECK(middle.y == Approx(1.0).margin(1e-4));
  input.slices[1].file = beside;
  CHECK(loading.message(input, eleven) ==
        beside.string() + ": error: the raster does not lie where that of the time before (" +
            here.string() + ") lies\n");
}

TEST_CASE("a table over time gives one temperature", "[sim][temperature]") {
  Loading loading;
  const fs::path file = loading.text("roof.csv",
                                     "utc,temperature_c,wall_k\n2020-06-01T10:00:00Z,10,280\n"
                                     "2020-06-01T12:00:00Z,20,284\n");
  const auto at = [&](const char* column) {
    return load_temperature_table({file, column, {}}, temperature_utc("2020-06-01T11:00:00Z"),
                                  loading.files());
  };
  CHECK(at("").value == Approx(288.15).epsilon(1e-9));
  CHECK(at("wall_k").value == Approx(282.0).epsilon(1e-9));
  CHECK(loading.files().all().count(file) == 1);
  CHECK_THROWS_AS(load_temperature_table({file, "", {}}, temperature_utc("2020-06-01T13:00:00Z"),
                                         loading.files()),
                  InputError);
}

TEST_CASE("a mesh under temperatures by vertex must have them, from 0 to 6000 K",
          "[sim][temperature]") {
  const auto message = [](std::vector<float> values, const VertexTemperatureInput& input) {
    return support::message_of(
        [&] { check_vertex_temperature(one_triangle(std::move(values)), input, "roof.ply"); });
  };
  CHECK_FALSE(has_vertex_values(one_triangle({})));
  CHECK(has_vertex_values(one_triangle({1.0F, 2.0F, 3.0F})));
  CHECK(message({280.0F, 0.0F, 6000.0F}, {}) == "(nothing thrown)");
  CHECK(message({}, {}) ==
        "roof.ply: error: the mesh gives its vertices no temperatures, which its material asks "
        "for\n    hint: a PLY file has them as the property temperature_k, temperature_c or "
        "temperature of its vertices\n");
  CHECK(message({280.0F, -1.0F, 300.0F}, {}) ==
        "roof.ply: error: vertex 1 (the first is 0) has -1 K; temperatures are from 0 to 6000 K\n"
        "    hint: degrees Celsius have the property temperature_c\n");
  CHECK(message({28.0F, 29.0F, 30.0F}, {1.0, 273.15, {}}) == "(nothing thrown)");
  CHECK(
      message({28.0F, 29.0F, 3000.0F}, {2.5, 0.0, {}}).find("vertex 2 (the first is 0) has 7500") !=
      std::string::npos);
  const auto source = vertex_temperature({2.0, 3.0, {}}, nullptr);
  CHECK(source.gain == 2.0);
  CHECK(source.offset_k == 3.0);
}
