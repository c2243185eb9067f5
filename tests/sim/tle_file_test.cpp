#include "sim/files/tle_file.hpp"

#include <fstream>
#include <string>

#include "sim/message_of.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

using Catch::Matchers::Contains;

// Vallado et al., AIAA 2006-6753, verification set: the first orbit, and one of deep space.
const std::string vanguard =
    "1 00005U 58002B   00179.78495062  .00000023  00000-0  28098-4 0  4753\n"
    "2 00005  34.2682 348.7242 1859667 331.7664  19.3264 10.82419157413667\n";
const std::string rocket =
    "1 16925U 86065D   06151.67415771  .02550794 -30915-6  18784-3 0  4486\n"
    "2 16925  62.0906 295.0239 5596327 245.1593  47.9690  4.88511875148616\n";

std::string tle_message(const std::string& text, const std::string& satellite = {}) {
  return support::message_of(
      [&] { static_cast<void>(parse_two_line_elements(text, "s.tle", satellite)); });
}

std::string changed_tle(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("a two-line set is read column by column", "[sim][tle]") {
  const sensor::TwoLineElements set = parse_two_line_elements(vanguard, "s.tle");
  CHECK(set.catalogue_number == 5);
  CHECK(set.designator == "58002B");
  CHECK(set.epoch_year == 2000);
  CHECK(set.epoch_day == 179.78495062);
  CHECK(set.drag_term == Approx(0.28098e-4).epsilon(1e-15));
  CHECK(set.inclination_deg == 34.2682);
  CHECK(set.ascending_node_deg == 348.7242);
  CHECK(set.eccentricity == 0.1859667);
  CHECK(set.argument_of_perigee_deg == 331.7664);
  CHECK(set.mean_anomaly_deg == 19.3264);
  CHECK(set.mean_motion_rev_day == 10.82419157);
  CHECK(parse_two_line_elements(rocket, "s.tle").epoch_year == 2006);
  CHECK(parse_two_line_elements(rocket, "s.tle").designator == "86065D");
}

TEST_CASE("a satellite is chosen by name or catalogue number", "[sim][tle]") {
  const std::string file =
      "# elements\r\n\nVANGUARD 1\r\n" + vanguard + "\n0 SL-6 R/B(2)   \n" + rocket;
  CHECK(parse_two_line_elements(file, "s.tle", "VANGUARD 1").catalogue_number == 5);
  CHECK(parse_two_line_elements(file, "s.tle", "SL-6 R/B(2)").catalogue_number == 16925);
  CHECK(parse_two_line_elements(file, "s.tle", "16925").catalogue_number == 16925);
  CHECK(parse_two_line_elements(file, "s.tle", "5").catalogue_number == 5);
  CHECK(tle_message(file) ==
        "error: s.tle has 2 element sets: say which by its name or catalogue number\n"
        "    hint: the file has 00005 \"VANGUARD 1\", 16925 \"SL-6 R/B(2)\"\n");
  CHECK(tle_message(file, "VANGUARD 2") ==
        "error: there is no satellite \"VANGUARD 2\" in s.tle\n"
        "    hint: did you mean \"VANGUARD 1\"?\n");
  CHECK_THAT(tle_message(file, "77"), Contains("hint: the file has 00005 \"VANGUARD 1\", 16925"));
  CHECK(tle_message(file + rocket, "16925") ==
        "s.tle: error: the file has more than one element set for \"16925\", in lines 8 and 10: "
        "keep the one whose epoch is nearest\n");
  CHECK(tle_message("# nothing\n") ==
        "s.tle: error: there is no two-line element set in the file\n");
}

TEST_CASE("catalogue numbers above 99999 begin with a letter", "[sim][tle]") {
  // T0005: 270005, as I and O are left out. The checksum does not count letters.
  std::string text = vanguard;
  text.replace(text.find("00005"), 5, "T0005");
  text.replace(text.find("2 00005") + 2, 5, "T0005");
  CHECK(parse_two_line_elements(text, "s.tle").catalogue_number == 270005);
  CHECK(parse_two_line_elements(text, "s.tle", "270005").catalogue_number == 270005);
}

TEST_CASE("a file of elements is read from disk", "[sim][tle]") {
  const support::ScratchFolder folder;
  std::ofstream{folder / "one.tle"} << vanguard;
  CHECK(read_two_line_elements(folder / "one.tle").catalogue_number == 5);
  CHECK_THAT(
      support::message_of([&] { static_cast<void>(read_two_line_elements(folder / "none.tle")); }),
      Contains("none.tle: error: the file cannot be read"));
}

TEST_CASE("mistakes of two-line elements have their places", "[sim][tle]") {
  CHECK(tle_message(changed_tle(vanguard, "34.2682", "34.2683")) ==
        "s.tle:2:69: error: the checksum is \"7\", the line's is 8: a digit has been changed\n"
        "    2 | 2 00005  34.2683 348.7242 1859667 331.7664  19.3264 10.82419157413667\n"
        "      |                                                                     ^\n");
  // 34.2682 to 934.268: the digits' sum grows by 9 - 2 = 7.
  CHECK_THAT(tle_message(changed_tle(vanguard, " 34.2682", "934.268 ")),
             Contains("s.tle:2:9: error: the inclination is \"934.268\", expected 0 to 180"));
  CHECK_THAT(
      tle_message(changed_tle(vanguard, "28098-4", "28098x4")),
      Contains("s.tle:1:55: error: the drag term B* is \"28098x4\", expected digits, a sign"));
  CHECK_THAT(tle_message(changed_tle(vanguard, "1859667", "18596.7")),
             Contains("s.tle:2:27: error: the eccentricity is \"18596.7\", expected seven digits"));
  CHECK_THAT(tle_message(changed_tle(vanguard, "00179.7", "00379.7")),
             Contains("s.tle:1:21: error: the epoch's day of the year is \"379.78495062\""));
  CHECK_THAT(tle_message(changed_tle(vanguard, "2 00005", "2 00006")),
             Contains("s.tle:2:3: error: line 2 is of \"00006\", line 1 of \"00005\""));
  CHECK_THAT(tle_message(changed_tle(vanguard, "-4 0 ", "-4 4 ")),
             Contains("s.tle:1:63: error: the ephemeris type is \"4\", expected 0"));
  CHECK_THAT(tle_message(changed_tle(vanguard, "10.82419157", "00.00000000")),
             Contains("s.tle:2:53: error: the mean motion is \"00.00000000\", expected above 0"));
  CHECK_THAT(tle_message(changed_tle(vanguard, " 00005U", " 000 5U")),
             Contains("s.tle:1:3: error: the catalogue number is \"000 5\""));
}

TEST_CASE("lines that do not make a set are told", "[sim][tle]") {
  const std::string first = vanguard.substr(0, 70), second = vanguard.substr(70);
  CHECK_THAT(tle_message(first),
             Contains("s.tle:1:1: error: line 1 of a set of elements without its "
                      "line 2"));
  CHECK_THAT(tle_message(second),
             Contains("s.tle:1:1: error: line 2 of a set of elements without its "
                      "line 1"));
  CHECK_THAT(tle_message(first + first + second), Contains("s.tle:1:1: error: line 1 of a set"));
  CHECK_THAT(tle_message(vanguard.substr(0, 60) + "\n" + second),
             Contains("s.tle:1:1: error: a line of two-line elements has 69 columns, this one has "
                      "60"));
  CHECK_THAT(tle_message(vanguard.substr(0, 139) + "     0.0  4320.0\n"),
             Contains("s.tle:2:1: error: a line of two-line elements has 69 columns"));
}

}  // namespace nadir::sim
