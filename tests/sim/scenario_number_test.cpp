#include <string>
#include <utility>

#include "scenario_support.hpp"
#include "sim/scenario/attribute_type.hpp"
#include "sim/scenario/strict_number.hpp"
#include "support/catch.hpp"

using namespace nadir::sim;

TEST_CASE("plain decimals are numbers", "[scenario][number]") {
  const auto [text, value] = GENERATE(table<const char*, double>(
      {{"0", 0.0},
       {"1", 1.0},
       {"-1", -1.0},
       {"+1", 1.0},
       {"1.5", 1.5},
       {"1.", 1.0},
       {".5", 0.5},
       {"-.5", -0.5},
       {"1e3", 1000.0},
       {"1E3", 1000.0},
       {"1e+3", 1000.0},
       {"1e-3", 0.001},
       {"007", 7.0},
       {"1e308", 1e308},
       {"-0", 0.0},
       {"1e-999", 0.0},
       {"0e999", 0.0},
       {"0.1", 0.1},  // the nearest double, as the compiler reads it
       {"0.0000000000000000000000000000000000001e-999999999999999999999", 0.0}}));
  CAPTURE(text);
  REQUIRE(strict_number(text).has_value());
  CHECK(*strict_number(text) == value);
}

TEST_CASE("everything else is not a number", "[scenario][number]") {
  const auto* text = GENERATE("", " ", ".", "+", "-", "e5", ".e5", "1e", "1e+", "1.5x", "1,5",
                              "1 5", "nan", "NaN", "inf", "-inf", "INF", "infinity", "1e999",
                              "-1e999", "1e9999999999999999999999", "0x10", "0x1p3", "1d5", "1_000",
                              "1e5.0", "--1", "+-1", "1.2.3", "one", " 1", "1 ", "\xC2\xBD");
  CAPTURE(text);
  CHECK_FALSE(strict_number(text).has_value());
}

TEST_CASE("whole numbers have a sign and digits", "[scenario][number]") {
  CHECK(strict_integer("12") == 12);
  CHECK(strict_integer("+12") == 12);
  CHECK(strict_integer("-12") == -12);
  CHECK(strict_integer("000000000000000000000000000012") == 12);
  CHECK(strict_integer("2147483647") == 2147483647);
  for (const char* text :
       {"", "+", "1.0", "1e3", "0x1", "2147483648", "99999999999999999999", "1x"}) {
    CAPTURE(text);
    CHECK_FALSE(strict_integer(text).has_value());
  }
}

TEST_CASE("an attribute's number says what was expected", "[scenario][number]") {
  const auto* text = GENERATE("1.5x", "1,5", "nan", "inf", "1e999", "0x10", "", "91", "-90.0001");
  CAPTURE(text);
  const std::string given = std::string{"latitude_deg=\""} + text + "\"";
  CHECK(nadir::test::mistake_lines(
            nadir::test::replaced(nadir::test::minimal_text(), "latitude_deg=\"36\"", given)) ==
        "5:9: attribute \"latitude_deg\" of <site>: \"" + std::string{text} +
            "\", expected a number from -90 to 90 [deg]\n");
}

TEST_CASE("every kind of attribute takes what it says and nothing else", "[scenario][number]") {
  const auto taken = [](const AttributeType& type, const char* text) {
    return parse_attribute(type, text).value() != nullptr;
  };
  const NumberType open{0.0, 1.0, true, true};
  CHECK(taken(open, " 0.5\n"));
  CHECK_FALSE(taken(open, "0"));
  CHECK_FALSE(taken(open, "1"));
  CHECK_FALSE(taken(open, "1e-999"));  // too small for a double: it is 0
  const VectorType three{{-1.0, 1.0, false, false}, false};
  CHECK(taken(three, " 0  0.5\t1 "));
  CHECK_FALSE(taken(three, "0 0"));
  CHECK_FALSE(taken(three, "0 0 0 0"));
  CHECK_FALSE(taken(three, "0,0,0"));
  CHECK_FALSE(taken(three, "0 0 2"));
  CHECK_FALSE(taken(three, "1"));
  CHECK(taken(VectorType{{-1.0, 1.0, false, false}, true}, "1"));
  CHECK(taken(NameType{}, "a-b.c_9"));
  for (const char* bad : {"", "-a", ".a", "a b", "a/b", "\xC3\xA4"})
    CHECK_FALSE(taken(NameType{}, bad));
  CHECK(taken(NamesType{3}, "a b c"));
  CHECK_FALSE(taken(NamesType{3}, "a b c d"));
  CHECK_FALSE(taken(NamesType{3}, " "));
  CHECK(taken(boolean(), "true"));
  CHECK_FALSE(taken(boolean(), "True"));
  CHECK_FALSE(taken(boolean(), "1"));
  const PathType mesh{{".obj", ".ply"}};
  CHECK(taken(mesh, "a/b.OBJ"));
  CHECK_FALSE(taken(mesh, ".obj"));
  CHECK_FALSE(taken(mesh, "a.stl"));
  CHECK(taken(ColumnType{}, "library:a.csv#R 1"));
  for (const char* bad : {"a.csv#", "a.csv#b#c", "a#b.csv", "a.txt", ".csv", "0.5"}) {
    CAPTURE(bad);
    CHECK_FALSE(taken(ColumnType{}, bad));
  }
  CHECK(taken(SpectralType{{0.0, 1.0, false, false}}, "0.5"));
  CHECK(taken(SpectralType{{0.0, 1.0, false, false}}, "5.csv"));
  CHECK_FALSE(taken(SpectralType{{0.0, 1.0, false, false}}, "5"));
  CHECK_FALSE(taken(TextType{}, " \t"));
}

TEST_CASE("numbers in messages are short and exact", "[scenario][number]") {
  CHECK(number_text(0.0) == "0");
  CHECK(number_text(-90.0) == "-90");
  CHECK(number_text(0.25) == "0.25");
  CHECK(number_text(100000.0) == "100000");
  CHECK(number_text(1e9) == "1e9");
  CHECK(number_text(-2.5e8) == "-2.5e8");
}
