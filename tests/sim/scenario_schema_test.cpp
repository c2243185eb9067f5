#include "sim/scenario/schema.hpp"

#include <cstdlib>
#include <map>
#include <set>

#include "scenario_support.hpp"
#include "sim/scenario/material_library.hpp"
#include "sim/scenario/sensor_file.hpp"
#include "sim/scenario/write_reference.hpp"
#include "sim/scenario/write_xsd.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
namespace fs = std::filesystem;

namespace {

const fs::path source_folder = NADIR_SOURCE_DIR;
const fs::path xsd = source_folder / "scenes/schema/nadir.xsd";

bool has_xmllint() {
  static const bool found = std::system("xmllint --version >/dev/null 2>&1") == 0;
  if (!found) WARN("xmllint (package libxml2-utils) is not there: the XML schema is not checked");
  return found;
}

/// Whether xmllint finds each file valid; one run for all of them.
std::map<std::string, bool> xmllint(const std::vector<fs::path>& files) {
  const test::TemporaryFolder folder;
  const fs::path log = folder / "log";
  std::string command = "xmllint --noout --schema " + xsd.string();
  for (const fs::path& file : files) command += " " + file.string();
  static_cast<void>(std::system((command + " 2>" + log.string()).c_str()));
  const std::string text = test::file_text(log);
  std::map<std::string, bool> valid;
  for (const fs::path& file : files) {
    valid[file.string()] = text.find(file.string() + " validates\n") != std::string::npos;
  }
  return valid;
}

bool reader_takes(const std::string& text) {
  if (text.find("<materials>\n") == std::string::npos) return test::mistakes(text).empty();
  const test::TemporaryFolder folder;
  const fs::path file = folder / "library.xml";
  std::ofstream{file} << text;
  try {
    static_cast<void>(read_material_library(file));
    return true;
  } catch (const InputError&) {
    return false;
  }
}

struct Change {
  std::string from, to;
};

/// Changes of the full scenario that keep it valid.
const std::vector<Change> good_changes = {
    {"xsi:noNamespaceSchemaLocation=\"../../../../scenes/schema/nadir.xsd\"", ""},
    {"name=\"full\"", "name=\" full \""},
    {"latitude_deg=\"0\"", "latitude_deg=\" +9.e1 \""},
    {"latitude_deg=\"0\"", "latitude_deg=\"-.5E-1\""},
    {"latitude_deg=\"0\"", "latitude_deg=\"1e-999\""},
    {"<site ", "<!-- here --><site "},
    {"ut1_minus_utc_s=\"0.1\"", ""},
    {"16:00:00.25Z", "16:00:00Z"},
    {"max_bounces=\"4\"", "max_bounces=\"+004\""},
    {"scale=\"1 2 3\"", "scale=\" 1  2\n 3 \""},
    {"scale=\"1 2 3\"", "scale=\"0.5\""},
    {"on_terrain=\"true\"", "on_terrain=\" true \""},
    {"<lambertian/>", ""},
    {"<solver max_bounces=\"1\"/>", "<solver/>"},
    {"<part name=\"roof\" material=\"roof\"/>", ""},
    {"lunar_irradiance=\"0.001\"", ""},
    {"<ephemeris solar_irradiance=\"solar.csv\" lunar_irradiance=\"0.001\"/>", "<ephemeris/>"},
    {"<ephemeris solar_irradiance=\"solar.csv\" lunar_irradiance=\"0.001\"/>", "<fixed/>"},
    {"<sampling replicates=\"8\" samples_per_replicate=\"3\" wavelengths_per_band=\"5\"/>", ""},
    {"quick_look_bands=\"Red Green Blue\"", "quick_look_bands=\"Red\""},
    {"title=\"K\xC3\xA4se &amp; bread\"", ""},
    {"<sphere radius_m=\"2\" material=\"roof\" scale=\"2\"/>", ""},
    {"<cylinder ", "<cylinder name=\"chimney\" "},
    {"height_m=\"100\"", "height_m=\"00100.000\""},
    {"yaw_deg=\"30\"", "yaw_deg=\"-360\""},
    {"emissivity=\"curves.csv#asphalt\"", "emissivity=\" curves.csv#asphalt \""},
    {"material=\"wall\">", "material=\"wall\"><!-- a --> "},
};

/// Changes that break a rule of form: both the schema and the reader must refuse them.
const std::vector<Change> bad_changes = {
    {"name=\"full\"", ""},
    {"name=\"full\"", "name=\"\""},
    {"name=\"full\"", "name=\"f\xC3\xBCll\""},
    {"name=\"full\"", "name=\"-full\""},
    {"title=\"K\xC3\xA4se &amp; bread\"", "title=\" \""},
    {"<site ", "<sites "},
    {"<site ", "<site lattitude_deg=\"1\" "},
    {"<site ", "text<site "},
    {"<site ", "<site latitude_deg=\"0\" longitude_deg=\"0\" height_m=\"0\"/><site "},
    {"latitude_deg=\"0\"", ""},
    {"latitude_deg=\"0\"", "latitude_deg=\"\""},
    {"latitude_deg=\"0\"", "latitude_deg=\"90.001\""},
    {"latitude_deg=\"0\"", "latitude_deg=\"1,5\""},
    {"latitude_deg=\"0\"", "latitude_deg=\"1.5x\""},
    {"latitude_deg=\"0\"", "latitude_deg=\"nan\""},
    {"latitude_deg=\"0\"", "latitude_deg=\"NaN\""},
    {"latitude_deg=\"0\"", "latitude_deg=\"INF\""},
    {"latitude_deg=\"0\"", "latitude_deg=\"1e999\""},
    {"latitude_deg=\"0\"", "latitude_deg=\"0x10\""},
    {"latitude_deg=\"0\"", "latitude_deg=\"1e\""},
    {"latitude_deg=\"0\"", "latitude_deg=\".\""},
    {"latitude_deg=\"0\"", "latitude_deg=\"1 2\""},
    {"16:00:00.25Z", "16:00:00.25"},
    {"16:00:00.25Z", "16:00Z"},
    {"16:00:00.25Z", "16:00:00.1234567891Z"},
    {"16:00:00.25Z", "16:00:00,25Z"},
    {"ut1_minus_utc_s=\"0.1\"", "ut1_minus_utc_s=\"201\""},
    {"max_bounces=\"4\"", "max_bounces=\"4.0\""},
    {"max_bounces=\"4\"", "max_bounces=\"-1\""},
    {"max_bounces=\"4\"", "max_bounces=\"99999999999999999999\""},
    {"sample_decay_rate=\"2\"", "sample_decay_rate=\"0.99\""},
    {"sky_radiance=\"20\"", "sky_radiance=\"-1\""},
    {"solar_irradiance=\"solar.csv\"", "solar_irradiance=\"solar.csv#\""},
    {"solar_irradiance=\"solar.csv\"", "solar_irradiance=\"solar.txt\""},
    {"solar_irradiance=\"solar.csv\"", "solar_irradiance=\"\""},
    {"transmittance=\"0.7\"", "transmittance=\"1.1\""},
    {"<uniform ", "<none/><uniform "},
    {"<ephemeris solar_irradiance=\"solar.csv\" lunar_irradiance=\"0.001\"/>", ""},
    {"<ephemeris ", "<fixed/><ephemeris "},
    {"<ephemeris ", "<ephemeris time=\"now\" "},
    {"default_temperature_k=\"290\"", "default_temperature_k=\"-1\""},
    {"<library file=\"materials.xml\"/>", "<library/>"},
    {"<library file=\"materials.xml\"/>", "<library file=\"materials.csv\"/>"},
    {"<lambertian/>", "<lambertian/><lambertian/>"},
    {"<lambertian/>", "<phong/>"},
    {"<lambertian/>", "<lambertian rho=\"1\"/>"},
    {"<material name=\"bark\"/>", "<material name=\"bark\">brown</material>"},
    {"material=\"ground\" height", "height"},
    {"file=\"hut.obj\"", "file=\"hut.stl\""},
    {"<part name=\"roof\"", "<part"},
    {"<part name=\"roof\"", "<part name=\"\""},
    {"on_terrain=\"true\"", "on_terrain=\"yes\""},
    {"on_terrain=\"true\"", "on_terrain=\"1\""},
    {"on_terrain=\"true\"", "on_terrain=\"True\""},
    {"scale=\"1 2 3\"", "scale=\"1 2\""},
    {"scale=\"1 2 3\"", "scale=\"1 2 3 4\""},
    {"scale=\"1 2 3\"", "scale=\"1 0 3\""},
    {"scale=\"1 2 3\"", "scale=\"1,2,3\""},
    {"radius_m=\"2\"", "radius_m=\"0\""},
    {"radius_m=\"2\"", "radius_m=\"1e-999\""},
    {"lo_m=\"-1 -2 0\"", "lo_m=\"-1 -2\""},
    {"lo_m=\"-1 -2 0\"", "lo_m=\"-1\""},
    {"<cylinder radius_m=\"0.2\" top_m=\"0 0 5\"",
     "<cylinder on_terrain=\"true\" radius_m=\"0.2\" top_m=\"0 0 5\""},
    {"<instances list=\"trees.csv\" on_terrain", "<instances on_terrain"},
    {"<disc radius_m=\"0.1\" material=\"ground\"/>", ""},
    {"<disc radius_m=\"0.1\" material=\"ground\"/>", "<terrain raster=\"a\" material=\"ground\"/>"},
    {"<look_at roll_deg=\"5\">", "<euler yaw_deg=\"0\" pitch_deg=\"0\"/><look_at roll_deg=\"5\">"},
    {"<position>", "<position><local east_m=\"0\" north_m=\"0\" up_m=\"9\"/>"},
    {"<perspective focal_length_mm=\"50\">", "<perspective>"},
    {"pitch_um=\"5.5\"", ""},
    {"pitch_um=\"5.5\"", "ground_pitch_m=\"5.5\""},
    {"response=\"responses.csv#Red\"", "response=\"0.5\""},
    {"lo_um=\"8\"", "lo_um=\"0.1\""},
    {"replicates=\"8\"", "replicates=\"3\""},
    {"quick_look_bands=\"Red Green Blue\"", "quick_look_bands=\"Red Green Blue Red\""},
    {"quick_look_bands=\"Red Green Blue\"", "quick_look_bands=\"Red, Green\""},
    {"<products ", "<products/><products "},
    {"</scenario>", "</scenario><scenario/>"},
    {"</platform>", "</platfrom>"},
    {"name=\"full\"", "name=\"full\" name=\"again\""},
    {"&amp;", "&"},
    {"&amp;", "&nope;"},
    {"<scenario ", "<scene "},
    {"2001/XMLSchema-instance", "2001/XMLSchema"},
    {"xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\"", ""},
};

/// Mistakes of meaning, which no XML schema can see.
const std::vector<Change> meaning_changes = {
    {"default_temperature_k=\"290\"", ""},
    {"2026-06-21", "2026-06-31"},
    {"2026-06-21", "2526-06-21"},
    {"ut1_minus_utc_s=\"0.1\"", "ut1_minus_utc_s=\"150\""},
    {"solar.csv", "lunar.csv"},
    {"<material name=\"wall\"", "<material name=\"roof\""},
    {"from=\"meadow\"", "from=\"lawn\""},
    {"emissivity=\"0.9\"", "emissivity=\"0.95\""},
    {"material=\"roof\"", "material=\"gold\""},
    {"hi_m=\"1 2 3\"", "hi_m=\"1 2 -3\""},
    {"normal=\"0 1 1\"", "normal=\"0 0 0\""},
    {"<terrain raster=\"ground.asc\" material=\"ground\" height_offset_m=\"-30.5\"/>", ""},
    {"name=\"narrow\"", "name=\"wide\""},
    {"hi_um=\"12\"", "hi_um=\"7\""},
    {"quick_look_bands=\"Red Green Blue\"", "quick_look_bands=\"Red Green\""},
};

/// Changes of the warm scenario: still valid; of a form that is wrong; of a wrong meaning.
const std::vector<Change> good_warm_changes = {
    {" step_min=\"20\"", ""},
    {" history_h=\"48\"", ""},
    {"<weather_file file=\"weather.csv\" format=\"csv\" any_year=\"true\" long_wave=\"swinbank\"/>",
     "<clear_sky air_low_c=\"5\" dew_point_k=\"270\"/>"},
    {"default_temperature_c=\"15\"", "default_temperature_k=\"288\""},
    {"convection=\"simple\" roughness=\"smooth\"", "convection=\"mcadams\""},
    {"back=\"room\" room_temperature_c=\"20\"\n                    room_film_w_m2_k=\"6\"", ""},
    {"temperature_of=\"engine\"", "temperature_c=\"-3\""},
    {" present_from=\"2026-06-20T00:00:00Z\"", ""},
    {"drape=\"texture\" size_u=\"2\"", ""},
};
const std::vector<Change> bad_warm_changes = {
    {"step_min=\"20\"", "step_min=\"0\""},
    {"sky_rays=\"128\"", "sky_rays=\"0\""},
    {"growth=\"1.5\"", "growth=\"0.9\""},
    {"<weather_file file=\"weather.csv\" format=\"csv\" any_year=\"true\" long_wave=\"swinbank\"/>",
     ""},
    {"format=\"csv\"", "format=\"xls\""},
    {"<weather_file file", "<clear_sky/><weather_file file"},
    {"default_temperature_c=\"15\"", "default_temperature_c=\"-274\""},
    {"solve=\"true\"", "solve=\"yes\""},
    {"convection=\"simple\"", "convection=\"forced\""},
    {"roughness=\"smooth\"", "roughness=\"flat\""},
    {"wetness=\"0.1\"", "wetness=\"1.1\""},
    {"back=\"room\"", "back=\"cellar\""},
    {"<layer substance=\"steel_sheet\"", "<sheet substance=\"steel_sheet\""},
    {"density_kg_m3=\"30\"", "density_kg_m3=\"0\""},
    {"<temperature_table file=\"weather.csv\" column=\"engine_c\"/>", "<temperature_table/>"},
    {"<slice utc=\"2026-06-21T17:00:00Z\"", "<slice"},
    {"utc=\"2026-06-21T17:00:00Z\" file", "utc=\"2026-06-21\" file"},
    {"unit=\"C\"", "unit=\"F\""},
    {"offset_k=\"-1.5\"", "offset_k=\"-1.5 K\""},
    {"present_until=\"2026-06-21T15:30:00Z\"", "present_until=\"15:30\""},
    {"raster=\"ground.asc\">", "raster=\"ground.asc\" temperature_k=\"3\">"},
    {"truth_temperature=\"true\"", "truth_temperature=\"1\""},
};
const std::vector<Change> meaning_warm_changes = {
    {"step_min=\"20\"", "step_min=\"21\""},
    {"default_temperature_c=\"15\"", ""},
    {"default_temperature_c=\"15\"", "default_temperature_c=\"15\" default_temperature_k=\"288\""},
    {"<material name=\"asphalt\"", "<material name=\"asphalt\" temperature_k=\"3\""},
    {"roughness=\"smooth\"", "film_w_m2_k=\"3\""},
    {"back=\"room\"", "back=\"open\""},
    {"substance=\"steel_sheet\" thickness_m=\"0.001\"", "substance=\"steel_sheet\""},
    {"file=\"ground.asc\" band=\"1\" gain", "gain"},
    {"temperature_of=\"engine\"", "temperature_of=\"motor\""},
    {"temperature_of=\"engine\"", "temperature_of=\"engine\" temperature_k=\"3\""},
    {"2026-06-21T10:00:00Z", "2026-06-21T18:00:00Z"},
};

/// Writes every changed text to a file of its own in `folder`.
std::vector<fs::path> write_changed(const test::TemporaryFolder& folder, const std::string& text,
                                    const std::vector<Change>& changes) {
  std::vector<fs::path> files;
  for (const Change& change : changes) {
    files.push_back(folder / (std::to_string(files.size()) + ".xml"));
    std::ofstream{files.back(), std::ios::binary} << test::replaced(text, change.from, change.to);
  }
  return files;
}

struct Verdict {
  bool reader = false, schema = false;  ///< whether each takes every change
};

void check_changes(const std::string& text, const std::vector<Change>& changes, Verdict expected) {
  const test::TemporaryFolder folder;
  const std::vector<fs::path> files = write_changed(folder, text, changes);
  const auto valid = has_xmllint() ? xmllint(files) : std::map<std::string, bool>{};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    CAPTURE(changes[i].from, changes[i].to);
    CHECK(reader_takes(test::file_text(files[i])) == expected.reader);
    if (!valid.empty()) CHECK(valid.at(files[i].string()) == expected.schema);
  }
}

}  // namespace

TEST_CASE("the table names only elements that it has", "[scenario][schema]") {
  std::set<std::string> ids, used = {scenario_root, library_root, sensor_root};
  for (const ElementType& type : schema().types()) {
    CAPTURE(type.id);
    CHECK(ids.insert(type.id).second);
    CHECK(type.doc.ends_with('.'));
    CHECK((type.content == Content::nothing) == type.children.empty());
    std::set<std::string> names;
    for (const Child& child : type.children) {
      used.insert(child.type);
      CHECK_NOTHROW(names.insert(schema().type(child.type).name));
    }
    CHECK(names.size() == type.children.size());  // the reader finds children by their names
  }
  CHECK(ids == used);
}

TEST_CASE("every default of the table is a valid value", "[scenario][schema]") {
  for (const ElementType& type : schema().types()) {
    std::set<std::string> names;
    for (const Attribute& attribute : type.attributes) {
      CAPTURE(type.id, attribute.name);
      CHECK(names.insert(attribute.name).second);
      CHECK(attribute.doc.ends_with('.'));
      if (attribute.presence != Presence::defaulted) continue;
      CHECK(parse_attribute(attribute.type, attribute.fallback).value() != nullptr);
    }
  }
}

TEST_CASE("the table's defaults are those of the plain data", "[scenario][schema]") {
  std::string text = test::replaced(test::minimal_text(), "</scenario>",
                                    "<solver/><sampling/><products/></scenario>");
  Diagnostics diagnostics;
  const Scenario s = parse_scenario(text, "test.xml", diagnostics);
  CHECK(s.solver == materials::SolverSettings{});
  CHECK(s.sampling.replicates == SamplingInput{}.replicates);
  CHECK(s.sampling.samples_per_replicate == SamplingInput{}.samples_per_replicate);
  CHECK(s.sampling.wavelengths_per_band == SamplingInput{}.wavelengths_per_band);
  CHECK(s.products.envi == ProductsInput{}.envi);
  CHECK(s.products.exr == ProductsInput{}.exr);
  CHECK(s.products.quick_look == ProductsInput{}.quick_look);
  CHECK(s.products.truth == ProductsInput{}.truth);
  CHECK(s.products.truth_temperature == ProductsInput{}.truth_temperature);
}

TEST_CASE("the shipped schema and reference page are up to date", "[scenario][schema]") {
  INFO(
      "to write them anew:\n  nadir schema --xsd > scenes/schema/nadir.xsd\n"
      "  nadir schema --reference > docs/scenario-reference.md");
  CHECK((test::file_text(xsd) == write_xsd()));
  CHECK((test::file_text(source_folder / "docs/scenario-reference.md") == write_reference()));
}

TEST_CASE("reader and XML schema take the same good scenarios", "[scenario][schema]") {
  check_changes(test::full_text(), good_changes, {true, true});
  check_changes(test::warm_text(), good_warm_changes, {true, true});
}

TEST_CASE("reader and XML schema refuse the same bad forms", "[scenario][schema]") {
  check_changes(test::full_text(), bad_changes, {false, false});
  check_changes(test::warm_text(), bad_warm_changes, {false, false});
}

TEST_CASE("mistakes of meaning are the reader's alone", "[scenario][schema]") {
  check_changes(test::full_text(), meaning_changes, {false, true});
  check_changes(test::warm_text(), meaning_warm_changes, {false, true});
}

TEST_CASE("reader and XML schema agree on material libraries", "[scenario][schema]") {
  const std::vector<std::pair<std::string, bool>> libraries = {
      {"<materials>\n<material name=\"a\" emissivity=\"1\"/></materials>", true},
      {"<materials>\n<material name=\"a\" emissivity=\"1\"><lambertian/></material></materials>",
       true},
      {"<materials>\n<material name=\"a\" emissivity=\"1\"><heat_balance><layer substance=\"b\"/>"
       "</heat_balance></material></materials>",
       true},
      {"<materials>\n<material name=\"a\" emissivity=\"1\"><heat_balance/></material></materials>",
       false},
      {"<materials>\n<material name=\"a\" emissivity=\"1\"><air_temperature/></material>"
       "</materials>",
       false},
      {"<materials>\n</materials>", false},
      {"<materials>\n<material emissivity=\"1\"/></materials>", false},
      {"<materials>\n<material name=\"a\" emissivity=\"2\"/></materials>", false},
      {"<materials>\n<material name=\"a\" emissivity=\"1\" temperature_k=\"3\"/></materials>",
       false},
      {"<materials>\n<library file=\"a.xml\"/></materials>", false},
      {"<materials>\n<material name=\"a\" emissivity=\"1\"><solver/></material></materials>",
       false},
  };
  const test::TemporaryFolder folder;
  const fs::path file = folder / "library.xml";
  for (const auto& [text, good] : libraries) {
    CAPTURE(text);
    CHECK(reader_takes(text) == good);
    std::ofstream{file} << text;
    if (has_xmllint()) CHECK(xmllint({file}).at(file.string()) == good);
  }
}

TEST_CASE("every shipped scenario and library is valid in both", "[scenario][schema]") {
  std::vector<fs::path> files;
  for (const char* name : {"minimal", "full", "warm", "materials", "warm_library"}) {
    files.push_back(test::data_folder() / (std::string{name} + ".xml"));
  }
  for (const auto& entry : fs::recursive_directory_iterator{source_folder / "scenes"}) {
    if (entry.path().extension() == ".xml") files.push_back(entry.path());
  }
  const auto valid = has_xmllint() ? xmllint(files) : std::map<std::string, bool>{};
  Diagnostics diagnostics;
  for (const fs::path& file : files) {
    CAPTURE(file.string());
    CHECK_NOTHROW(is_material_library(file) ? static_cast<void>(read_material_library(file))
                  : is_sensor_file(file)    ? static_cast<void>(read_sensor_file(file))
                                            : static_cast<void>(read_scenario(file, diagnostics)));
    if (!valid.empty()) CHECK(valid.at(file.string()));
  }
}
