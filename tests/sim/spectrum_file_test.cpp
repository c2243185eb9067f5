#include "sim/files/spectrum_file.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/error.hpp"
#include "support/catch.hpp"

using namespace nadir;
using sim::SpectrumQuantity;
using spectral::Outside;

namespace {

const std::string spectrum_header =
    "# nadir-spectrum: 1\n"
    "# title: Two greys\n"
    "# quantity: reflectance\n"
    "# unit: 1\n"
    "# wavelength: um, vacuum\n"
    "# source: a ruler\n"
    "# source: a lamp\n"
    "# licence: CC0-1.0\n"
    "# made-by: by hand\n"
    "# note: grey\n";

std::string error_of(const std::string& text) {
  try {
    (void)sim::parse_spectrum(text, "grey.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// A file in the system's temporary folder, removed at the end.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text)
      : path{std::filesystem::temp_directory_path() / ("nadir_spectrum_test_" + name)} {
    std::ofstream{path, std::ios::binary} << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path path;
};

}  // namespace

TEST_CASE("a spectrum file gives its facts and its columns", "[sim][spectrum]") {
  const auto file = sim::parse_spectrum(
      spectrum_header + "wavelength_um,light,dark\n0.4,0.5,0.1\n0.7,0.6,\n1e0,.75,2.5e-1\n",
      "grey.csv");
  CHECK(file.path == "grey.csv");
  CHECK(file.title == "Two greys");
  CHECK(file.quantity == SpectrumQuantity::reflectance);
  CHECK(file.unit == "1");
  CHECK(file.source == "a ruler; a lamp");
  CHECK(file.licence == "CC0-1.0");
  CHECK(file.made_by == "by hand");
  CHECK(file.notes == std::vector<std::string>{"note: grey"});
  CHECK(file.column_names() == std::vector<std::string>{"light", "dark"});
  CHECK(file.column("light").wavelength_um == std::vector<double>{0.4, 0.7, 1.0});
  CHECK(file.column("light").value == std::vector<double>{0.5, 0.6, 0.75});
  // the empty cell is no row of this column
  CHECK(file.column("dark").wavelength_um == std::vector<double>{0.4, 1.0});
  CHECK(file.column("dark").value == std::vector<double>{0.1, 0.25});
}

TEST_CASE("byte-order mark, CR LF, blank lines and a missing last line end are read",
          "[sim][spectrum]") {
  std::string text = "\xEF\xBB\xBF" + spectrum_header + "\nwavelength_um,grey\n0.4,0.5\n\n0.7, 0.6";
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) {
    text.insert(at, "\r");
  }
  const auto file = sim::parse_spectrum(text, "grey.csv");
  CHECK(file.title == "Two greys");
  CHECK(file.column("").value == std::vector<double>{0.5, 0.6});
}

TEST_CASE("all mistakes of a spectrum file are reported at once, each in its place",
          "[sim][spectrum]") {
  const std::string text =
      "# nadir-spectrum: 2\n"
      "# titel: Grey\n"
      "# quantity: reflektance\n"
      "# wavelength: nm, air\n"
      "# licence:\n"
      "# just text\n"
      "wavelength,grey,grey\n"
      "0.4,0.5x,0.5\n"
      "0.5,nan,0.5\n"
      "0.6,1e999\n"
      "-0.7,0.5,+0.5\n"
      "0.4,0.5,0.5\n"
      "0.3,0.5,0.5\n";
  CHECK(error_of(text) ==
        "grey.csv:1:19: error: version \"2\" of the format is not known; expected 1\n"
        "    1 | # nadir-spectrum: 2\n"
        "      |                   ^\n"
        "grey.csv:2:3: error: unknown header key \"titel\"\n"
        "    2 | # titel: Grey\n"
        "      |   ^\n"
        "    hint: did you mean \"title\"?\n"
        "grey.csv:3:13: error: unknown quantity \"reflektance\"\n"
        "    3 | # quantity: reflektance\n"
        "      |             ^\n"
        "    hint: did you mean \"reflectance\"?\n"
        "grey.csv:4:15: error: wavelength is \"nm, air\"; expected \"um, vacuum\"\n"
        "    4 | # wavelength: nm, air\n"
        "      |               ^\n"
        "grey.csv:5:3: error: header key \"licence\" has no value\n"
        "    5 | # licence:\n"
        "      |   ^\n"
        "grey.csv:6:1: error: expected a header line \"# key: value\"\n"
        "    6 | # just text\n"
        "      | ^\n"
        "grey.csv: error: header line \"# title: ...\" is missing\n"
        "grey.csv: error: header line \"# unit: ...\" is missing\n"
        "grey.csv: error: header line \"# source: ...\" is missing\n"
        "grey.csv: error: header line \"# licence: ...\" is missing\n"
        "grey.csv:7:1: error: expected a row of column names that starts with \"wavelength_um\", "
        "found \"wavelength\"\n"
        "    7 | wavelength,grey,grey\n"
        "      | ^\n"
        "grey.csv:7:17: error: column name \"grey\" is given twice\n"
        "    7 | wavelength,grey,grey\n"
        "      |                 ^\n"
        "grey.csv:8:5: error: grey is \"0.5x\"; expected a number\n"
        "    8 | 0.4,0.5x,0.5\n"
        "      |     ^\n"
        "grey.csv:9:5: error: grey is \"nan\"; expected a number\n"
        "    9 | 0.5,nan,0.5\n"
        "      |     ^\n"
        "grey.csv:10:1: error: expected 3 cells, found 2\n"
        "    10 | 0.6,1e999\n"
        "       | ^\n"
        "grey.csv:11:1: error: wavelength is \"-0.7\"; expected a positive number\n"
        "    11 | -0.7,0.5,+0.5\n"
        "       | ^\n"
        "grey.csv:11:10: error: grey is \"+0.5\"; expected a number\n"
        "    11 | -0.7,0.5,+0.5\n"
        "       |          ^\n"
        "grey.csv:12:1: error: wavelength 0.4 is not greater than the one before it; rows must "
        "ascend\n"
        "    12 | 0.4,0.5,0.5\n"
        "       | ^\n"
        "grey.csv:13:1: error: wavelength 0.3 is not greater than the one before it; rows must "
        "ascend\n"
        "    13 | 0.3,0.5,0.5\n"
        "       | ^\n");
}

TEST_CASE("numbers are read strictly", "[sim][spectrum]") {
  const std::string token = GENERATE("1.5x", "0x1p-1", "inf", "-nan", "1e999", "+0.5", "0.5 0.5",
                                     ".", "1e", "0,5", "\"0.5\"");
  CAPTURE(token);
  CHECK(error_of(spectrum_header + "wavelength_um,grey\n0.4,0.5\n0.7," + token + "\n") !=
        "no error");
}

TEST_CASE("values outside the quantity's range are refused", "[sim][spectrum]") {
  CHECK(error_of(spectrum_header + "wavelength_um,grey\n0.4,0.5\n0.7,1.01\n0.8,-0.01\n") ==
        "grey.csv:13:5: error: grey is 1.01; reflectance is from 0 to 1\n"
        "    13 | 0.7,1.01\n"
        "       |     ^\n"
        "grey.csv:14:5: error: grey is -0.01; reflectance is from 0 to 1\n"
        "    14 | 0.8,-0.01\n"
        "       |     ^\n");
}

TEST_CASE("a unit that is not the quantity's is refused, in either order", "[sim][spectrum]") {
  const std::string rest =
      "# wavelength: um, vacuum\n# source: s\n# licence: l\nwavelength_um,e\n1,2\n2,3\n";
  const std::string top = "# nadir-spectrum: 1\n# title: t\n";
  CHECK(error_of(top + "# quantity: irradiance\n# unit: W m^-2 um^-1\n" + rest) == "no error");
  CHECK(
      error_of(top + "# quantity: irradiance\n# unit: W m^-2 nm^-1\n" + rest) ==
      "grey.csv:4:9: error: the unit of irradiance is \"W m^-2 nm^-1\"; expected \"W m^-2 um^-1\"\n"
      "    4 | # unit: W m^-2 nm^-1\n"
      "      |         ^\n");
  CHECK(error_of(top + "# unit: 1\n# quantity: radiance\n" + rest) ==
        "grey.csv:4:13: error: the unit of radiance is \"1\"; expected \"W m^-2 sr^-1 um^-1\"\n"
        "    4 | # quantity: radiance\n"
        "      |             ^\n");
}

TEST_CASE("files without a table are refused", "[sim][spectrum]") {
  CHECK(error_of("") == "grey.csv: error: the file has no row of column names\n");
  CHECK(error_of(spectrum_header) == "grey.csv: error: the file has no row of column names\n");
  CHECK(error_of(spectrum_header + "wavelength_um\n") ==
        "grey.csv:11:1: error: expected at least one column beside the wavelength\n"
        "    11 | wavelength_um\n"
        "       | ^\n");
  CHECK(error_of(spectrum_header + "wavelength_um,a,b\n0.4,0.5,\n0.5,0.5,0.5\n") ==
        "grey.csv: error: column \"b\" has 1 values; expected at least 2\n");
  CHECK(error_of(spectrum_header + "wavelength_um,a\n0.4,0.5\n# note: late\n0.5,0.5\n") ==
        "grey.csv:13:1: error: a header line must stand above the row of column names\n"
        "    13 | # note: late\n"
        "       | ^\n");
}

TEST_CASE("a file of another kind is given up after a hundred mistakes", "[sim][spectrum]") {
  std::string text = spectrum_header + "wavelength_um,grey\n";
  for (int i = 0; i < 1000; ++i) text += "x,y\n";
  try {
    (void)sim::parse_spectrum(text, "grey.csv");
    FAIL("no error");
  } catch (const InputError& error) {
    CHECK(error.issues().size() == 101);
    CHECK(error.issues().back().message == "too many mistakes; reading stopped here");
  }
}

TEST_CASE("a column is found by name, or answered with the nearest", "[sim][spectrum]") {
  const auto file =
      sim::parse_spectrum(spectrum_header + "wavelength_um,red,green\n1,0,0\n2,0,0\n", "g.csv");
  CHECK_THROWS_WITH(file.column("gren"),
                    "g.csv: error: there is no column \"gren\"\n"
                    "    hint: did you mean \"green\"?\n");
  CHECK_THROWS_WITH(file.column("thermal"),
                    "g.csv: error: there is no column \"thermal\"\n"
                    "    hint: known are: red, green\n");
  CHECK_THROWS_WITH(file.column(""),
                    "g.csv: error: the file has 2 columns; name one as file.csv#column\n"
                    "    hint: columns are: red, green\n");
}

TEST_CASE("a plain table states the unit of its wavelengths", "[sim][spectrum]") {
  const std::string text = GENERATE("wavelength_nm,rsr\n500,0.5\n600,1.5\n",
                                    "# my camera\nwavelength_nm  rsr\n500 0.5\n  600\t1.5\n",
                                    "wavelength_um,rsr\n0.5,0.5\n# done\n0.6,1.5\n");
  CAPTURE(text);
  const auto file = sim::parse_spectrum(text, "plain.txt", SpectrumQuantity::response);
  CHECK_FALSE(file.quantity.has_value());
  CHECK(file.column("rsr").wavelength_um[0] == 0.5);
  CHECK(file.column("rsr").wavelength_um[1] == Approx(0.6).epsilon(1e-15));  // 600 * 1e-3 rounds
  CHECK(file.column("rsr").value == std::vector<double>{0.5, 1.5});
}

TEST_CASE("a plain table's unit is never guessed", "[sim][spectrum]") {
  CHECK(error_of("500,0.5\n600,1.5\n") ==
        "grey.csv:1:1: error: expected a row of column names that starts with \"wavelength_um\" or "
        "\"wavelength_nm\", found \"500\"\n"
        "    1 | 500,0.5\n"
        "      | ^\n");
}

TEST_CASE("a curve is read for the quantity that its user needs", "[sim][spectrum]") {
  const TemporaryFile file{"grey.csv", spectrum_header + "wavelength_um,grey\n0.4,0.5\n0.8,0.7\n"};
  const std::string name = file.path.string();
  const auto curve = sim::read_curve(file.path, "", SpectrumQuantity::reflectance, Outside::reject);
  CHECK(curve.at(0.6_um) == Approx(0.6).epsilon(1e-15));
  CHECK(std::isnan(curve.at(0.9_um)));
  CHECK_THROWS_WITH(sim::read_curve(file.path, "", SpectrumQuantity::emissivity, Outside::hold),
                    name + ": error: the file holds reflectance; expected emissivity\n");
  CHECK_THROWS_WITH(
      sim::read_curve(file.path, "gray", SpectrumQuantity::reflectance, Outside::hold),
      name + ": error: there is no column \"gray\"\n    hint: did you mean \"grey\"?\n");
  CHECK_THROWS_WITH(sim::read_curve("none.csv", "", SpectrumQuantity::response, Outside::zero),
                    "none.csv: error: the file cannot be opened\n");
}

TEST_CASE("both parts of a refractive index come from one file and are not mixed up",
          "[sim][spectrum]") {
  std::string text = spectrum_header;
  text.replace(text.find("reflectance"), 11, "refractive_index");
  const TemporaryFile file{"gold.csv", text + "wavelength_um,n,k\n0.4,1.5,1.9\n0.8,0.2,4.9\n"};
  const std::string name = file.path.string();
  const auto read = [&](const char* column, SpectrumQuantity expected) {
    return sim::read_curve(file.path, column, expected, Outside::reject).at(0.8_um);
  };
  CHECK(read("n", SpectrumQuantity::refractive_index) == 0.2);
  CHECK(read("k", SpectrumQuantity::extinction_coefficient) == 4.9);
  CHECK_THROWS_WITH(
      read("k", SpectrumQuantity::refractive_index),
      name + ": error: column \"k\" holds extinction_coefficient; expected refractive_index\n");
  CHECK_THROWS_WITH(
      read("n", SpectrumQuantity::extinction_coefficient),
      name + ": error: the file holds refractive_index; expected extinction_coefficient\n");
}

TEST_CASE("a plain table is checked as what it is used for", "[sim][spectrum]") {
  const TemporaryFile file{"plain.csv", "wavelength_nm,x\n400,0.5\n800,1.5\n"};
  const std::string name = file.path.string();
  CHECK(sim::read_curve(file.path, "", SpectrumQuantity::response, Outside::zero).at(0.8_um) ==
        1.5);
  CHECK_THROWS_WITH(sim::read_curve(file.path, "", SpectrumQuantity::emissivity, Outside::hold),
                    name +
                        ":3:5: error: x is 1.5; emissivity is from 0 to 1\n"
                        "    3 | 800,1.5\n"
                        "      |     ^\n");
}

TEST_CASE("a reference names a file and perhaps a column", "[sim][spectrum]") {
  const auto whole = sim::parse_spectrum_reference("spectra/sand.csv");
  CHECK(whole.path == "spectra/sand.csv");
  CHECK(whole.column.empty());
  const auto part = sim::parse_spectrum_reference("responses/oli.csv#Red");
  CHECK(part.path == "responses/oli.csv");
  CHECK(part.column == "Red");
}
