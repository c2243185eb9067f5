#include "core/error.hpp"

#include <limits>

#include "core/text.hpp"
#include "support/catch.hpp"

using namespace nadir;

TEST_CASE("an error reads like a compiler's diagnostic", "[core][error]") {
  InputIssue issue;
  issue.where = {"scenes/mesa.xml", 12, 9};
  issue.message = "unknown attribute \"rhoo\"";
  issue.hint = "rho";
  issue.source_line = "  <brdf rhoo=\"0.3\"/>";
  const InputError error{issue};
  CHECK(std::string{error.what()} ==
        "scenes/mesa.xml:12:9: error: unknown attribute \"rhoo\"\n"
        "    12 |   <brdf rhoo=\"0.3\"/>\n"
        "       |         ^\n"
        "    hint: rho\n");
}

TEST_CASE("the caret stays in its column behind tabs and wide characters", "[core][error]") {
  SECTION("tabs are repeated below the text") {
    CHECK(format_issue({{"a.xml", 3, 4}, "bad", "", "\t<\tx"}) ==
          "a.xml:3:4: error: bad\n    3 | \t<\tx\n      | \t \t^\n");
  }
  SECTION("a character of two bytes takes one column") {
    CHECK(format_issue({{"a.xml", 3, 4}, "bad", "", "\xC3\xA9 <x>"}) ==
          "a.xml:3:4: error: bad\n    3 | \xC3\xA9 <x>\n      |   ^\n");
  }
  SECTION("the first column, and one past the end") {
    CHECK(format_issue({{"a.xml", 3, 1}, "bad", "", "x"}) ==
          "a.xml:3:1: error: bad\n    3 | x\n      | ^\n");
    CHECK(format_issue({{"a.xml", 3, 99}, "bad", "", "x"}) ==
          "a.xml:3:99: error: bad\n    3 | x\n      |  ^\n");
  }
}

TEST_CASE("what is not known of a location is left out", "[core][error]") {
  CHECK(format_issue({{}, "bad", "", ""}) == "error: bad\n");
  CHECK(format_issue({{"a.csv", 0, 0}, "bad", "", ""}) == "a.csv: error: bad\n");
  CHECK(format_issue({{"a.csv", 7, 0}, "bad", "", ""}) == "a.csv:7: error: bad\n");
  CHECK(format_issue({{"a.csv", 7, 0}, "bad", "", "1,2"}) == "a.csv:7: error: bad\n    7 | 1,2\n");
  CHECK(format_issue({{"a.csv", 0, 5}, "bad", "", ""}) == "a.csv: error: bad\n");
}

TEST_CASE("an error carries all mistakes, and takes a location where it has none",
          "[core][error]") {
  const InputError bare{
      std::vector<InputIssue>{{{}, "first", "", ""}, {{"b.csv", 2, 1}, "second", "", "x"}}};
  const InputError placed = bare.located({"a.xml", 5, 3}, "  <a/>");
  REQUIRE(placed.issues().size() == 2);
  CHECK(std::string{placed.what()} ==
        "a.xml:5:3: error: first\n    5 |   <a/>\n      |   ^\n"
        "b.csv:2:1: error: second\n    2 | x\n      | ^\n");
  CHECK(std::string{bare.what()} ==
        "error: first\nb.csv:2:1: error: second\n    2 | x\n      | ^\n");
  CHECK(InputError{"plain"}.issues().front().message == "plain");
}

TEST_CASE("the nearest name is offered only where it may be meant", "[core][error]") {
  const std::vector<std::string> names = {"emissivity", "reflectance", "transmittance", "rho"};
  CHECK(nearest_name("emisivity", names) == "emissivity");
  CHECK(nearest_name("relfectance", names) == "reflectance");  // two exchanged letters count 1
  CHECK(nearest_name("Transmitance", names) == "transmittance");
  CHECK(nearest_name("RHO", names) == "rho");
  CHECK(nearest_name("roh", names) == "rho");
  CHECK(nearest_name("ohr", names).empty());  // distance 2 in three letters
  CHECK(nearest_name("titel", {"title", "tile"}) == "title");
  CHECK(nearest_name("colour", names).empty());
  CHECK(nearest_name("x", {"y"}).empty());
  CHECK(nearest_name("", names).empty());
  CHECK(nearest_name("band", {}).empty());
  CHECK(nearest_name("bond", {"band", "bend"}) == "band");  // the first of equals
}

TEST_CASE("numbers in messages are the shortest that read back", "[core][text]") {
  CHECK(number_text(0.1) == "0.1");
  CHECK(number_text(-3.0) == "-3");
  CHECK(number_text(1e-300) == "1e-300");
  CHECK(number_text(-std::numeric_limits<double>::min()) == "-2.2250738585072014e-308");
  CHECK(number_text(std::numeric_limits<double>::quiet_NaN()) == "nan");
}
