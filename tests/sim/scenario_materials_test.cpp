#include <cmath>
#include <numbers>

#include "scenario_support.hpp"
#include "sim/scenario/material_library.hpp"
#include "support/catch.hpp"

// Scattering models, transmittance and relief of materials in scenarios and libraries.

using namespace nadir;
using namespace nadir::sim;
using test::minimal_text;
using test::mistake_lines;
using test::replaced;

namespace {

const std::string grey = "    <material name=\"grey\" reflectance=\"0.5\"/>\n";

/// The minimal scenario with other materials in line 9 and following; "grey" must be among them.
std::string with_materials(const std::string& materials) {
  return replaced(minimal_text(), grey, materials + "\n");
}

Scenario read_materials(const std::string& text) {
  Diagnostics diagnostics;
  return parse_scenario(text, test::data_folder() / "test.xml", diagnostics);
}

/// The model of a material that consists of it and nothing else.
template <class Model>
Model model_of(const std::string& element, const std::string& attributes = "") {
  const Scenario scenario = read_materials(
      with_materials("<material name=\"grey\"" + attributes + ">" + element + "</material>"));
  REQUIRE(std::holds_alternative<Model>(scenario.materials.at(0).scattering));
  return std::get<Model>(scenario.materials.at(0).scattering);
}

double number_of(const SpectralInput& input) { return std::get<double>(input.source); }

const std::string half = " reflectance=\"0.5\"";

}  // namespace

TEST_CASE("every scaled scattering model is read with its units", "[scenario][materials]") {
  CHECK_NOTHROW(model_of<materials::Lambertian>("<lambertian/>", half));
  CHECK(model_of<materials::OrenNayar>("<oren_nayar slope_sigma_deg=\"30\"/>", half)
            .slope_sigma_rad == Approx(std::numbers::pi / 6).epsilon(1e-15));
  CHECK(model_of<materials::Minnaert>("<minnaert k=\"1.2\"/>", half).k == 1.2);
  CHECK_NOTHROW(model_of<materials::Leaf>("<leaf/>", half + " transmittance=\"0.4\""));
  CHECK_FALSE(model_of<MirrorInput>("<mirror/>", half).n.has_value());
  CHECK_FALSE(model_of<ClearSheetInput>("<clear_sheet/>",
                                        " reflectance=\"0.1\" "
                                        "transmittance=\"0.9\"")
                  .n.has_value());
  const auto ward = model_of<WardInput>(
      "<ward specular=\"0.2\" alpha_x=\"0.1\" alpha_y=\"0.3\" azimuth_deg=\"90\"/>", half);
  CHECK(number_of(ward.specular) == 0.2);
  CHECK(ward.alpha_x == 0.1);
  CHECK(ward.alpha_y == 0.3);
  CHECK(ward.azimuth_deg == 90.0);
  const auto germer =
      model_of<PriestGermerInput>("<priest_germer n=\"1.6\" slope_sigma=\"0.2\"/>", half);
  CHECK(number_of(germer.n) == 1.6);
  CHECK(number_of(germer.k) == 0.0);
  CHECK(germer.slope_sigma == 0.2);
}

TEST_CASE("every model with spectra of its own is read without any of the material's",
          "[scenario][materials]") {
  CHECK(number_of(*model_of<MirrorInput>("<mirror n=\"0.2\" k=\"3.4\"/>").k) == 3.4);
  CHECK(number_of(
            *model_of<ClearSheetInput>("<clear_sheet n=\"1.5\" absorption=\"0.1\"/>").absorption) ==
        0.1);
  const auto glass = model_of<MicrofacetInput>(
      "<microfacet slopes=\"beckmann\" alpha=\"0.2\" n=\"1.5\" transmits=\"true\"/>");
  CHECK(glass.slopes == materials::SlopeDistribution::beckmann);
  CHECK(glass.alpha_x == 0.2);
  CHECK(glass.alpha_y == 0.2);
  CHECK(glass.transmits);
  const auto sea = model_of<CoxMunkInput>("<cox_munk wind_speed_m_s=\"7\" foam=\"false\"/>");
  CHECK(sea.wind_speed_m_s == 7.0);
  CHECK(number_of(sea.n) == 1.34);
  CHECK_FALSE(sea.foam);
  const auto land = model_of<RossLiInput>(
      "<ross_li isotropic=\"curves.csv#grass\" volumetric=\"0.1\" geometric=\"0.02\"/>");
  CHECK(land.isotropic.column == "grass");
  CHECK(number_of(land.geometric) == 0.02);
  const auto rpv = model_of<RahmanPintyVerstraeteInput>(
      "<rahman_pinty_verstraete rho0=\"0.1\" k=\"0.7\" asymmetry=\"-0.2\"/>");
  CHECK(number_of(rpv.asymmetry) == -0.2);
  CHECK_FALSE(rpv.rho_c.has_value());
  const auto hapke = model_of<HapkeInput>(
      "<hapke single_scattering_albedo=\"0.8\" mean_slope_deg=\"20\" opposition_b0=\"1\"/>");
  CHECK(number_of(hapke.single_scattering_albedo) == 0.8);
  CHECK(hapke.rest.mean_slope_rad == Approx(std::numbers::pi / 9).epsilon(1e-15));
  CHECK(hapke.rest.opposition_b0 == 1.0);
  CHECK(hapke.rest.asymmetry_b == 0.3);
  CHECK(model_of<MeasuredInput>("<measured file=\"curves.csv\"/>").file ==
        test::data_folder() / "curves.csv");
}

TEST_CASE("a material knows where it stands", "[scenario][materials]") {
  const SourceLocation where = read_materials(minimal_text()).materials.at(0).where;
  CHECK(where.file == (test::data_folder() / "test.xml").string());
  CHECK(where.line == 9);
  CHECK(where.column == 5);
}

TEST_CASE("a mixture holds its parts whole, mixtures among them", "[scenario][materials]") {
  const Scenario scenario = read_materials(
      with_materials("<material name=\"grey\"><mixture><part material=\"both\" weight=\"0.25\"/>"
                     "<part material=\"a\" weight=\"0.75\"/></mixture></material>"
                     "<material name=\"both\"><mixture><part material=\"a\" weight=\"0.5\"/>"
                     "<part material=\"b\" weight=\"0.5\"/></mixture></material>"
                     "<material name=\"a\" reflectance=\"0.1\"/>"
                     "<material name=\"b\" reflectance=\"0.2\"><minnaert k=\"2\"/></material>"));
  const auto& outer = std::get<MixtureInput>(scenario.materials.at(0).scattering);
  REQUIRE(outer.parts.size() == 2);
  CHECK(outer.parts[0].weight == 0.25);
  CHECK(outer.parts[0].material->name == "both");
  const auto& inner = std::get<MixtureInput>(outer.parts[0].material->scattering);
  REQUIRE(inner.parts.size() == 2);
  CHECK(inner.parts[1].material->name == "b");
  CHECK(std::holds_alternative<materials::Minnaert>(inner.parts[1].material->scattering));
  CHECK(inner.parts[0].material == outer.parts[1].material);  // stored once
}

TEST_CASE("mixtures that contain themselves or nothing known are located",
          "[scenario][materials][mistakes]") {
  CHECK(mistake_lines(with_materials(
            "<material name=\"grey\"><mixture><part material=\"b\" weight=\"1\"/></mixture>"
            "</material>\n<material name=\"b\"><mixture><part material=\"grey\" weight=\"1\"/>"
            "</mixture></material>")) == "10:35: the mixture \"b\" would contain itself\n");
  CHECK(mistake_lines(with_materials(
            "<material name=\"grey\"><mixture><part material=\"grey\" weight=\"1\"/></mixture>"
            "</material>")) == "9:38: the mixture \"grey\" would contain itself\n");
  CHECK(mistake_lines(with_materials(
            "<material name=\"grey\"><mixture><part material=\"gray\" weight=\"1\"/></mixture>"
            "</material>")) ==
        "9:38: material \"gray\" is not declared in <materials> "
        "(did you mean \"grey\"?)\n");
  CHECK(mistake_lines(
            with_materials(
                "<material name=\"grey\"><mixture><part material=\"grey\" weight=\"0\"/></mixture>"
                "</material>"))
            .find("9:54: attribute \"weight\" of <part>: \"0\", expected a number above 0 and at "
                  "most 1") != std::string::npos);
}

TEST_CASE("weights that do not sum to 1 are told", "[scenario][materials]") {
  Diagnostics diagnostics;
  static_cast<void>(parse_scenario(
      with_materials("<material name=\"grey\"><mixture><part material=\"a\" weight=\"0.5\"/>"
                     "</mixture></material><material name=\"a\" reflectance=\"1\"/>"),
      test::data_folder() / "test.xml", diagnostics));
  REQUIRE(diagnostics.messages().size() == 1);
  CHECK(diagnostics.messages()[0].find("test.xml:9:23: the weights of the mixture "
                                       "\"grey\" sum to 0.5, not to 1") != std::string::npos);
}

TEST_CASE("spectra and scattering models that do not go together are located",
          "[scenario][materials][mistakes]") {
  const auto told = [](const std::string& attributes, const std::string& model) {
    return mistake_lines(
        with_materials("<material name=\"grey\" " + attributes + ">" + model + "</material>"));
  };
  const std::string glass = "<microfacet alpha=\"0.1\" n=\"1.5\"/>";
  CHECK(told("reflectance=\"0.5\"", glass) ==
        "9:23: reflectance has no place beside <microfacet>, which brings its own spectra\n");
  CHECK(told("from=\"meadow\"", glass) ==
        "9:23: <microfacet> brings its own spectra: from has no place beside it\n");
  CHECK(told("reflectance=\"0.5\" transmittance=\"0.1\"", "") ==
        "9:41: the material's scattering model lets no light through by it "
        "(<leaf/> does, and <clear_sheet/> without n)\n");
  CHECK(told("reflectance=\"0.5\" transmittance=\"0.7\"", "<leaf/>") ==
        "9:41: reflectance 0.5 and transmittance 0.7 sum to more than 1\n");
  CHECK(told("reflectance=\"0.5\"", "<leaf/><lambertian/>") ==
        "9:48: a material has one scattering model; <leaf> stands in line 9 already "
        "(<mixture> adds the scattering of several materials)\n");
  CHECK(told("", "<mirror k=\"2\"/>").find("9:32: k of <mirror> needs n as well") !=
        std::string::npos);
}

TEST_CASE("parameters out of their range are located", "[scenario][materials][mistakes]") {
  const auto told = [](const std::string& model) {
    return mistake_lines(with_materials("<material name=\"grey\">" + model + "</material>"));
  };
  CHECK(told("<microfacet n=\"1.5\"/>") ==
        "9:23: <microfacet> needs either alpha, or alpha_x and alpha_y\n");
  CHECK(told("<microfacet n=\"1.5\" alpha=\"0.1\" alpha_x=\"0.1\"/>") ==
        "9:23: <microfacet> needs either alpha, or alpha_x and alpha_y\n");
  CHECK(told("<microfacet n=\"1.5\" alpha=\"0\"/>").find("9:43: attribute \"alpha\"") == 0);
  CHECK(told("<microfacet n=\"1.5\" k=\"1\" alpha=\"0.1\" transmits=\"true\"/>") ==
        "9:61: a <microfacet> that transmits is of clear glass: k must be 0\n");
  CHECK(told("<cox_munk wind_speed_m_s=\"21\"/>")
            .find("9:33: attribute \"wind_speed_m_s\" of <cox_munk>: \"21\", expected a number "
                  "from 0 to 20") == 0);
  CHECK(told("<rahman_pinty_verstraete rho0=\"0.1\" k=\"1\" asymmetry=\"1\"/>")
            .find("above -1 and below 1") != std::string::npos);
  CHECK(told("<hapke single_scattering_albedo=\"1.1\"/>").find("expected a number from 0 to 1") !=
        std::string::npos);
  CHECK(told("<measured file=\"none.csv\"/>").find("file \"none.csv\" does not exist") !=
        std::string::npos);
}

TEST_CASE("a library's scattering, mixtures and spectra come along, and may be overridden",
          "[scenario][materials]") {
  const test::TemporaryFolder folder;
  const auto library = folder / "own.xml";
  std::ofstream{library} << "<materials>\n"
                            "<material name=\"leaf\" reflectance=\"0.3\" transmittance=\"0.2\">"
                            "<leaf/></material>\n"
                            "<material name=\"glass\"><clear_sheet n=\"1.5\"/></material>\n"
                            "<material name=\"mixed\"><mixture>"
                            "<part material=\"leaf\" weight=\"0.5\"/>"
                            "<part material=\"glass\" weight=\"0.5\"/></mixture></material>\n"
                            "</materials>\n";
  const Scenario scenario = read_materials(
      with_materials("<library file=\"" + library.string() +
                     "\"/><material name=\"grey\" from=\"leaf\"><minnaert k=\"1\"/></material>"
                     "<material name=\"leaf\"/><material name=\"pane\" from=\"glass\"/>"
                     "<material name=\"mixed\" temperature_k=\"280\"/>"));
  REQUIRE(scenario.materials.size() == 4);
  CHECK(std::holds_alternative<materials::Minnaert>(scenario.materials[0].scattering));
  CHECK(number_of(*scenario.materials[0].reflectance) == 0.3);
  CHECK(std::holds_alternative<materials::Leaf>(scenario.materials[1].scattering));
  CHECK(number_of(*scenario.materials[1].transmittance) == 0.2);
  CHECK(std::holds_alternative<ClearSheetInput>(scenario.materials[2].scattering));
  const auto& mixture = std::get<MixtureInput>(scenario.materials[3].scattering);
  REQUIRE(mixture.parts.size() == 2);
  CHECK(mixture.parts[0].material->name == "leaf");
  CHECK(test::kelvin_of(scenario.materials[3]) == 280.0);
  // A model that scales a reflectance finds none in glass.
  CHECK(mistake_lines(with_materials("<library file=\"" + library.string() +
                                     "\"/>\n<material name=\"grey\" from=\"glass\">"
                                     "<minnaert k=\"1\"/></material>")) ==
        "10:36: <minnaert> needs a reflectance, but the library's material brings its spectra with "
        "a scattering model of its own\n");
}

TEST_CASE("a library's mixtures know only the library", "[scenario][materials][mistakes]") {
  const test::TemporaryFolder folder;
  const auto library = folder / "own.xml";
  std::ofstream{library} << "<materials><material name=\"m\"><mixture><part material=\"n\" "
                            "weight=\"1\"/></mixture></material></materials>";
  try {
    static_cast<void>(read_material_library(library));
    FAIL("read");
  } catch (const InputError& error) {
    REQUIRE(error.issues().size() == 1);
    CHECK(error.issues()[0].message == "the library has no material \"n\"");
    CHECK(error.issues()[0].where.column == 46);
  }
}

TEST_CASE("a relief is read with its place", "[scenario][materials]") {
  const Scenario scenario = read_materials(with_materials(
      "<material name=\"grey\" reflectance=\"0.5\"><relief file=\"ground.asc\" kind=\"heights\" "
      "strength=\"2\" drape=\"texture\" size_u=\"3\"/></material>"));
  const auto& relief = scenario.materials.at(0).relief;
  REQUIRE(relief.has_value());
  CHECK_FALSE(relief->normals);
  CHECK(relief->strength == 2.0);
  CHECK(relief->place.repeats);
  CHECK(std::get<TextureDrape>(relief->place.drape).size_u == 3.0);
  CHECK(std::get<TextureDrape>(relief->place.drape).size_v == 1.0);
}
