#include "scenario_support.hpp"
#include "sim/scenario/material_library.hpp"
#include "support/catch.hpp"

using namespace nadir;
using test::full_text;
using test::minimal_text;
using test::mistake_lines;
using test::replaced;

TEST_CASE("ten different mistakes are ten errors, told at once", "[scenario][mistakes]") {
  const std::string text = test::file_text(test::data_folder() / "ten_mistakes.xml");
  CHECK(test::mistakes(text, "ten_mistakes.xml") ==
        R"(ten_mistakes.xml:2:31: error: <scenario> has no attribute "titl"
    2 | <scenario name="ten_mistakes" titl="A title">
      |                               ^
    hint: did you mean "title"?
ten_mistakes.xml:3:9: error: attribute "utc" of <time>: time "2026-02-30T16:00:00Z": month 2 of 2026 has 28 days
    3 |   <time utc="2026-02-30T16:00:00Z"/>
      |         ^
ten_mistakes.xml:4:9: error: attribute "latitude_deg" of <site>: "36,5", expected a number from -90 to 90 [deg]
    4 |   <site latitude_deg="36,5" longitude_deg="-84" height_m="300"/>
      |         ^
ten_mistakes.xml:5:28: error: file "solr.csv" does not exist (looked at solr.csv)
    5 |   <illumination><ephemeris solar_irradiance="solr.csv"/></illumination>
      |                            ^
    hint: that folder holds "solar.csv"
ten_mistakes.xml:6:22: error: <atmosphere> holds only one <none> or <uniform> or <layered> or <table>; <none> stands in line 6 already
    6 |   <atmosphere><none/><uniform/></atmosphere>
      |                      ^
ten_mistakes.xml:8:27: error: attribute "reflectance" of <material>: "1.5", expected a number from 0 to 1, or a spectrum file *.csv or *.csv#column
    8 |     <material name="grey" reflectance="1.5"/>
      |                           ^
ten_mistakes.xml:12:12: error: material "gray" is not declared in <materials>
    12 |     <plane material="gray" size_x_m="100" size_y_m="100"/>
       |            ^
    hint: did you mean "grey"?
ten_mistakes.xml:13:5: error: <geometry> may not hold <spher>
    13 |     <spher radius_m="2" material="roof" on_terrain="true"/>
       |     ^
    hint: did you mean "sphere"?
ten_mistakes.xml:13:41: error: <sphere> stands on the terrain, but <geometry> has no <terrain>
    13 |     <spher radius_m="2" material="roof" on_terrain="true"/>
       |                                         ^
ten_mistakes.xml:21:7: error: <array> lacks its attribute "ground_pitch_m"
    21 |       <array name="main" samples="4" lines="3">
       |       ^
    hint: it is a number above 0 and at most 1e6 [m]
)");
}

TEST_CASE("a misspelt name is one mistake, not a missing one as well", "[scenario][mistakes]") {
  CHECK(mistake_lines(replaced(minimal_text(), "latitude_deg", "latitud_deg")) ==
        "5:9: <site> has no attribute \"latitud_deg\" (did you mean \"latitude_deg\"?)\n");
  CHECK(mistake_lines(replaced(minimal_text(), "<site ", "<sites ")) ==
        "5:3: <scenario> may not hold <sites> (did you mean \"site\"?)\n");
  // and what it holds is read all the same: the material is declared
  CHECK(mistake_lines(replaced(minimal_text(), "name=\"grey\"", "nam=\"grey\"")) ==
        "9:15: <material> has no attribute \"nam\" (did you mean \"name\"?)\n");
}

TEST_CASE("a name like no other gets the list of valid names", "[scenario][mistakes]") {
  CHECK(mistake_lines(replaced(minimal_text(), "<plane ", "<torus/><plane ")) ==
        "12:5: <geometry> may not hold <torus> (known: terrain, mesh, sphere, disc, box, plane, "
        "cylinder, instances)\n");
  CHECK(mistake_lines(replaced(minimal_text(), "<time ", "<time zone=\"5\" ")) ==
        "4:9: <time> has no attribute \"zone\" (known: utc, ut1_minus_utc_s)\n");
  CHECK(mistake_lines(replaced(full_text(), "capped=\"true\"", "capped=\"tru\"")) ==
        "38:44: attribute \"capped\" of <cylinder>: \"tru\", expected true or false (did you mean "
        "\"true\"?)\n");
}

TEST_CASE("the form of elements is checked", "[scenario][mistakes]") {
  const auto [from, to, expected] = GENERATE(table<std::string, std::string, std::string>({
      {"name=\"minimal\"", "",
       "3:1: <scenario> lacks its attribute \"name\" (it is a name of "
       "letters, digits and _ . -)\n"},
      {"<site latitude_deg=\"36\" longitude_deg=\"-84\" height_m=\"300\"/>", "",
       "3:1: <scenario> lacks <site> (Origin of the scene's axes (x east, y north, z up) on or "
       "above the WGS84 ellipsoid, and where sun and moon are seen from.)\n"},
      {"<time ", "<time utc=\"2026-06-21T16:00:00Z\"/><time ",
       "4:37: <scenario> holds only one <time>; <time> stands in line 4 already\n"},
      {"<none/>", "", "7:3: <atmosphere> needs <none> or <uniform> or <layered> or <table>\n"},
      {"<band_box name=\"thermal\" lo_um=\"8\" hi_um=\"12\"/>", "",
       "20:7: <array> needs <band> or <band_box> or <band_gaussian>\n"},
      {"<none/>", "<none>thin</none>",
       "7:21: text inside <none>, which holds no text (values are "
       "given as attributes: name=\"value\")\n"},
      {"<none/>", "<none><wind/></none>",
       "7:21: <none> may not hold <wind> (it holds no elements)\n"},
      {"<none/>", "<none wind=\"1\"/>", "7:21: <none> has no attribute \"wind\" (it has none)\n"},
      {"name=\"grey\"", "name=\"light grey\"",
       "9:15: attribute \"name\" of <material>: \"light grey\", expected a name of letters, digits "
       "and _ . -\n"},
      {"size_x_m=\"100\"", "size_x_m=\"0\"",
       "12:28: attribute \"size_x_m\" of <plane>: \"0\", "
       "expected a number above 0 and at most 1e7 [m]\n"},
      {"samples=\"4\"", "samples=\"4.0\"",
       "20:26: attribute \"samples\" of <array>: \"4.0\", "
       "expected a whole number from 1 to 100000\n"},
      {"<scenario ", "<scenario xml:lang=\"en\" ",
       "3:11: <scenario> has no attribute \"xml:lang\" (known: name, title)\n"},
  }));
  CAPTURE(to);
  CHECK(mistake_lines(replaced(minimal_text(), from, to)) == expected);
}

TEST_CASE("a file with another root is told at the root", "[scenario][mistakes]") {
  CHECK(mistake_lines("<scene/>") == "1:1: expected the root <scenario>, found <scene>\n");
  CHECK(mistake_lines("<materials><material name=\"a\" emissivity=\"1\"/></materials>") ==
        "1:1: expected the root <scenario>, found <materials>\n");
}

TEST_CASE("what a minimal scenario means is checked", "[scenario][mistakes]") {
  const auto [from, to, expected] = GENERATE(table<std::string, std::string, std::string>({
      {"</materials>", "<material name=\"grey\" emissivity=\"1\"/></materials>",
       "10:13: material \"grey\" is there already, in line 9\n"},
      {"reflectance=\"0.5\"", "",
       "9:5: material \"grey\" has neither reflectance nor emissivity, "
       "and no library is listed to take them from (write <library "
       "file=\"library:materials.xml\"/> in <materials>)\n"},
      {"reflectance=\"0.5\"", "reflectance=\"0.5\" emissivity=\"0.6\"",
       "9:45: reflectance 0.5 and emissivity 0.6 sum to more than 1\n"},
      {"reflectance=\"0.5\"", "reflectance=\"0.5\" from=\"sand\"",
       "9:45: give either from, or reflectance and emissivity, not both\n"},
      {"<plane ", "<box material=\"grey\" lo_m=\"0 0 0\" hi_m=\"1 0 1\"/><plane ",
       "12:39: each number of hi_m must be greater than that of lo_m\n"},
      {"<plane ", "<disc material=\"grey\" radius_m=\"1\" normal=\"0 0 0\"/><plane ",
       "12:40: the normal of <disc> has no length\n"},
      {"<plane ", "<cylinder material=\"grey\" radius_m=\"1\" top_m=\"0 0 0\"/><plane ",
       "12:44: base_m and top_m of <cylinder> are the same place\n"},
      {"<plane ", "<mesh file=\"hut.obj\"/><plane ",
       "12:5: <mesh> has neither a material nor a <part> (write material=\"name\" for the whole "
       "mesh)\n"},
      {"<plane ",
       "<mesh file=\"hut.obj\"><part name=\"a\" material=\"grey\"/><part name=\"a\" "
       "material=\"grey\"/></mesh><plane ",
       "12:64: part \"a\" is there already, in line 12\n"},
      {"<plane ", "<plane on_terrain=\"true\" ",
       "12:12: <plane> stands on the terrain, but <geometry> has no <terrain>\n"},
      {"up_m=\"1000\"", "up_m=\"1000\" on_terrain=\"true\"",
       "15:57: <local> of <position> counts from the terrain, but <geometry> has no <terrain>\n"},
      {"<euler yaw_deg=\"0\" pitch_deg=\"-90\"/>",
       "<look_at><local east_m=\"0\" north_m=\"0\" up_m=\"1000\"/></look_at>",
       "16:15: <look_at> names the place where the camera itself is\n"},
      {"lo_um=\"8\"", "lo_um=\"12\"",
       "21:45: band \"thermal\" must end after it begins: lo_um is 12, hi_um 12\n"},
      {"<band_box name=\"thermal\" lo_um=\"8\" hi_um=\"12\"/>",
       "<band_gaussian name=\"b\" centre_um=\"1\" fwhm_um=\"2\"/>",
       "21:47: band \"b\" is wider than its wavelength\n"},
      {"</array>", "<band_box name=\"thermal\" lo_um=\"8\" hi_um=\"9\"/></array>",
       "22:17: band \"thermal\" is there already, in line 21\n"},
      {"</scenario>", "<products quick_look_bands=\"thermo\"/></scenario>",
       "25:11: the camera has no band \"thermo\" (did you mean \"thermal\"?)\n"},
      {"</scenario>", "<products quick_look_bands=\"thermal thermal\"/></scenario>",
       "25:11: a quick look has one band or three, not two\n"},
      {"<time ", "<time ut1_minus_utc_s=\"100\" ",
       "4:9: UT1 - UTC is 100 s"},  // the rest is the ephemeris' business
  }));
  CAPTURE(to);
  const std::string lines = mistake_lines(replaced(minimal_text(), from, to));
  CHECK((expected.ends_with('\n') ? lines : lines.substr(0, expected.size())) == expected);
}

TEST_CASE("what a full scenario means is checked", "[scenario][mistakes]") {
  const auto [from, to, expected] = GENERATE(table<std::string, std::string, std::string>({
      {"<sphere radius", "<terrain raster=\"ground.asc\" material=\"ground\"/><sphere radius",
       "34:5: a second <terrain>; the first is in line 29\n"},
      {"from=\"meadow\"", "from=\"medow\"",
       "20:29: no library has a material \"medow\" (did you mean \"meadow\"?)\n"},
      {"<material name=\"bark\"/>", "<material name=\"barg\"/>",
       "26:5: no library has a material \"barg\", and it has neither reflectance nor emissivity "
       "here (did you mean \"bark\"?)\n40:46: material \"bark\" is not declared in <materials> (a "
       "library has it: write <material name=\"bark\"/> in <materials>)\n"},
      {"<part name=\"roof\" material=\"roof\"/>", "<part name=\"roof\" material=\"rof\"/>",
       "32:25: material \"rof\" is not declared in <materials> (did you mean \"roof\"?)\n"},
      {"raster=\"ground.asc\"", "raster=\"..\"", "29:14: file \"..\" is not a file (looked at "},
      {"name=\"thermal\"", "name=\"visible\"",
       "60:14: array \"visible\" is there already, in line 55\n"},
      {"bands=\"Red Green", "bands=\"Red wide",
       "68:13: the bands of a quick look must be bands of one array\n"},
      {"<local east_m=\"0\" north_m=\"0\" up_m=\"0\" on_terrain=\"true\"/>",
       "<geodetic latitude_deg=\"0\" longitude_deg=\"0.01\" height_m=\"5000\"/>",
       "50:7: <look_at> names the place where the camera itself is\n"},
      {"<library file=\"materials.xml\"/>", "<library file=\"material.xml\"/>",
       "18:14: file \"material.xml\" does not exist (looked at "},
  }));
  CAPTURE(to);
  const std::string lines = mistake_lines(replaced(full_text(), from, to));
  CHECK((expected.ends_with('\n') ? lines : lines.substr(0, expected.size())) == expected);
}

TEST_CASE("a position in one frame and a target in another can be the same place",
          "[scenario][mistakes]") {
  std::string text = replaced(
      full_text(), "<geodetic latitude_deg=\"0\" longitude_deg=\"0.01\" height_m=\"5000\"/>",
      "<geodetic latitude_deg=\"0\" longitude_deg=\"0\" height_m=\"100\"/>");
  text = replaced(text, "up_m=\"0\" on_terrain=\"true\"/></look_at>", "up_m=\"0\"/></look_at>");
  CHECK(mistake_lines(text) == "50:7: <look_at> names the place where the camera itself is\n");
}

TEST_CASE("the mistakes of a library name the library", "[scenario][mistakes]") {
  const test::TemporaryFolder folder;
  std::ofstream{folder / "lib.xml"}
      << "<materials>\n"
         "  <material name=\"a\" emissivity=\"0.5\" reflectance=\"0.6\"/>\n"
         "  <material name=\"a\" reflectence=\"0.6\"/>\n"
         "  <material name=\"b\"/>\n"
         "  <material name=\"c\" emissivity=\"c.csv\"/>\n"
         "</materials>\n";
  const std::string lib = (folder / "lib.xml").string();
  const auto told = [&](const std::string& text, const std::string& part) {
    CAPTURE(text, part);
    CHECK(text.find(part) != std::string::npos);
  };
  try {
    static_cast<void>(sim::read_material_library(lib));
    FAIL("the library was taken");
  } catch (const InputError& error) {
    CHECK(error.issues().size() == 5);
    told(error.what(),
         lib + ":2:22: error: reflectance 0.6 and emissivity 0.5 sum to more than 1\n");
    told(error.what(), lib + ":3:13: error: material \"a\" is there already, in line 2\n");
    told(error.what(), lib + ":3:22: error: <material> has no attribute \"reflectence\"\n");
    told(error.what(),
         lib + ":4:3: error: material \"b\" has neither reflectance nor emissivity\n");
    told(error.what(), lib + ":5:22: error: file \"c.csv\" does not exist");
  }
  // In a scenario they come together with its own, and materials of a library that could not be
  // read whole are not said to be missing.
  const std::string text =
      replaced(replaced(full_text(), "file=\"materials.xml\"", "file=\"" + lib + "\""),
               "height_m=\"100\"", "");
  const std::string all = test::mistakes(text);
  told(all, "test.xml:7:3: error: <site> lacks its attribute \"height_m\"\n");
  told(all, lib + ":4:3: error: ");
  CHECK(all.find("no library has") == std::string::npos);
}

TEST_CASE("a file that is not there, or no file, says so", "[scenario][mistakes]") {
  Diagnostics diagnostics;
  const auto message = [&](const std::filesystem::path& file) -> std::string {
    try {
      static_cast<void>(sim::read_scenario(file, diagnostics));
      return {};
    } catch (const InputError& error) {
      return error.what();
    }
  };
  CHECK(message("/nowhere/x.xml") == "/nowhere/x.xml: error: the file does not exist\n");
  CHECK(message("/") == "/: error: this is not a file\n");
}
