#include "sim/files/brdf_file.hpp"

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

namespace {

const std::string header =
    "# nadir-brdf: 1\n"
    "# title: Test sand\n"
    "# quantity: brdf\n"
    "# zero-azimuth: backward\n"
    "# wavelength: um, vacuum\n"
    "# source: a goniometer\n"
    "# source: another\n"
    "# licence: CC0-1.0\n";
const std::string columns = "incidence_deg,view_deg,relative_azimuth_deg,0.55,0.86\n";
const std::string rows =
    "0,0,0,0.10,0.20\n"
    "0,60,0,0.11,0.21\n"
    "0,60,180,0.12,0.22\n"
    "45,0,0,0.13,0.23\n"
    "45,60,0,0.14,0.24\n"
    "45,60,180,0.15,0.25\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::vector<InputIssue> issues_of(const std::string& text) {
  try {
    (void)parse_brdf_file(text, "sand.csv");
  } catch (const InputError& error) {
    return error.issues();
  }
  return {};
}

struct Expected {
  int line, column;
  std::string message;
};

void check_one_issue(const std::string& text, const Expected& expected) {
  const auto issues = issues_of(text);
  REQUIRE(issues.size() == 1);
  CHECK(issues[0].message == expected.message);
  CHECK(issues[0].where.file == "sand.csv");
  CHECK(issues[0].where.line == expected.line);
  CHECK(issues[0].where.column == expected.column);
}

}  // namespace

TEST_CASE("a measured reflectance is read into its axes and values", "[sim][brdf]") {
  const BrdfFile file = parse_brdf_file(header + columns + rows, "sand.csv");
  const double degree = std::numbers::pi / 180.0;
  CHECK(file.title == "Test sand");
  CHECK(file.source == "a goniometer; another");
  CHECK(file.licence == "CC0-1.0");
  CHECK(file.table.incidence_rad == std::vector<double>{0.0, 45.0 * degree});
  CHECK(file.table.view_rad == std::vector<double>{0.0, 60.0 * degree});
  CHECK(file.table.azimuth_rad == std::vector<double>{0.0, std::numbers::pi});
  CHECK(file.table.wavelength_um == std::vector<double>{0.55, 0.86});
  // a vertical direction has one row, which stands for both azimuths
  CHECK(file.table.value == std::vector<float>{0.10F, 0.20F, 0.10F, 0.20F, 0.11F, 0.21F, 0.12F,
                                               0.22F, 0.13F, 0.23F, 0.13F, 0.23F, 0.14F, 0.24F,
                                               0.15F, 0.25F});
}

TEST_CASE("azimuths that count from forward scatter are turned round", "[sim][brdf]") {
  const auto text = replaced(header, "backward", "forward") + columns + rows;
  const auto table = parse_brdf_file(text, "sand.csv").table;
  CHECK(table.azimuth_rad == std::vector<double>{0.0, std::numbers::pi});
  CHECK(table.value[4] == 0.12F);  // incidence 0, view 60, back scatter: 180 in the file
  CHECK(table.value[12] == 0.15F);
  CHECK(table.value[14] == 0.14F);
}

TEST_CASE("reflectance factors are divided by pi", "[sim][brdf]") {
  const auto text = replaced(header, "brdf\n# zero", "reflectance_factor\n# zero") + columns + rows;
  const auto table = parse_brdf_file(text, "sand.csv").table;
  CHECK(table.value[0] == Approx(0.10 * std::numbers::inv_pi).epsilon(1e-6));  // float
}

TEST_CASE("a measured reflectance is read from a file", "[sim][brdf]") {
  const support::ScratchFolder folder;
  const auto path = folder.path() / "sand.csv";
  std::ofstream{path} << "\xEF\xBB\xBF" << header << "\r\n" << columns << rows;
  CHECK(read_brdf_file(path).table.value.size() == 16);
  CHECK_THROWS_AS(read_brdf_file(folder.path() / "none.csv"), InputError);
}

TEST_CASE("the whole message shows the line and the place", "[sim][brdf]") {
  const auto text = header + columns + replaced(rows, "0.14", "-0.14");
  CHECK_THROWS_WITH((void)parse_brdf_file(text, "sand.csv"),
                    "sand.csv:14:9: error: the reflectance is \"-0.14\"; expected a number from 0 "
                    "to 1e6\n    14 | 45,60,0,-0.14,0.24\n       |         ^\n");
}

TEST_CASE("values that are no sound numbers are located", "[sim][brdf]") {
  for (const std::string bad : {"nan", "inf", "1e999", "+1", "1.5x", "", "2e6"}) {
    check_one_issue(header + columns + replaced(rows, "0.14", bad),
                    {14, 9, "the reflectance is \"" + bad + "\"; expected a number from 0 to 1e6"});
  }
  check_one_issue(header + columns + replaced(rows, "45,60,0,", "45,95,0,"),
                  {14, 4, "view_deg is \"95\"; 0 to 90 is allowed"});
  check_one_issue(header + columns + replaced(rows, "45,60,180", "45,60,190"),
                  {15, 7, "relative_azimuth_deg is \"190\"; 0 to 180 is allowed"});
  check_one_issue(header + columns + replaced(rows, "0.14,", ""),
                  {14, 1, "expected 5 cells, found 4"});
}

TEST_CASE("holes, doubles and disorder among the rows are located", "[sim][brdf]") {
  check_one_issue(
      header + columns + replaced(rows, "45,60,180,0.15,0.25\n", ""),
      {14, 1, "after here a row is missing: incidence 45, view 60, relative azimuth 180"});
  check_one_issue(
      header + columns + replaced(rows, "45,60,0,0.14,0.24\n", ""),
      {14, 1, "before here a row is missing: incidence 45, view 60, relative azimuth 0"});
  check_one_issue(header + columns + replaced(rows, "45,60,180,", "45,60,0,"),
                  {15, 1, "incidence 45, view 60, relative azimuth 0 is there twice"});
  const auto issues = issues_of(header + columns + rows + "0,60,90,0.1,0.1\n");
  REQUIRE(issues.size() == 1);
  CHECK(issues[0].where.line == 16);
  CHECK(issues[0].message ==
        "incidence 0, view 60, relative azimuth 90 comes after incidence 45, view 60, relative "
        "azimuth 180");
  CHECK(issues[0].hint == "sort the rows by incidence, then view, then azimuth");
}

TEST_CASE("columns that are no wavelengths are located", "[sim][brdf]") {
  check_one_issue(header + replaced(columns, "0.86", "nir") + rows,
                  {9, 50, "expected a wavelength in um as the column's name, found \"nir\""});
  check_one_issue(header + replaced(columns, "0.86", "0.5") + rows,
                  {9, 50, "wavelength 0.5 is not greater than the one before it"});
  check_one_issue(header + replaced(columns, "view_deg", "view") + rows,
                  {9, 15,
                   "the first columns are incidence_deg, view_deg and "
                   "relative_azimuth_deg"});
  check_one_issue(header + replaced(columns, ",0.55,0.86", "") + rows,
                  {9, 24, "there is no wavelength after the angles"});
}

TEST_CASE("header lines are checked", "[sim][brdf]") {
  check_one_issue(replaced(header, "backward", "north") + columns + rows,
                  {4, 17, "found \"north\", expected \"backward\" or \"forward\""});
  check_one_issue(replaced(header, "nadir-brdf: 1", "nadir-brdf: 2") + columns + rows,
                  {1, 15, "found \"2\", expected \"1\""});
  check_one_issue(replaced(header, "# licence: CC0-1.0\n", "") + columns + rows,
                  {0, 0, "header line \"# licence: ...\" is missing"});
  check_one_issue(replaced(header, "# title: Test sand", "# title:") + columns + rows,
                  {2, 1, "header key \"title\" has no value"});
  check_one_issue(header + "# title: again\n" + columns + rows,
                  {9, 3, "header key \"title\" is given twice"});
  const auto issues = issues_of(header + "# sorce: x\n" + columns + rows);
  REQUIRE(issues.size() == 1);
  CHECK(issues[0].message == "unknown header key \"sorce\"");
  CHECK(issues[0].hint == "did you mean \"source\"?");
  check_one_issue(header + columns + rows + "# note: late\n",
                  {16, 1, "a header line must stand above the row of column names"});
}

TEST_CASE("files of another kind and empty ones are refused", "[sim][brdf]") {
  check_one_issue("wavelength_um,reflectance\n",
                  {0, 0, "the first line of a measured reflectance is \"# nadir-brdf: 1\""});
  check_one_issue(header, {0, 0, "the file has no row of column names"});
  check_one_issue(header + columns, {0, 0, "the file has no rows"});
  check_one_issue(header + columns + "0,0,0,0.1,0.1\n0,60,0,0.1,0.1\n0,60,180,0.1,0.1\n",
                  {0, 0, "the measured reflectance needs at least 2 angles of incidence"});
}
