#include "sim/files/ies_file.hpp"

#include <numbers>
#include <string>

#include "core/error.hpp"
#include "sim/message_of.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

namespace {

constexpr double ies_pi = std::numbers::pi;

std::string file_text(const std::string& version, const std::string& numbers) {
  return version + "\n[TEST] none\nTILT=NONE\n" + numbers;
}

/// Alike all around, 100 cd everywhere below: 200 pi lm.
std::string even_below() {
  return file_text("IESNA:LM-63-2002", "1 1000 1 3 1 1 2 0 0 0\n1 1 60\n0 45 90\n0\n100 100 100\n");
}

std::string message(const std::string& text) {
  return support::message_of([&] { (void)parse_ies(text, "lamp.ies"); });
}
std::string replaced_ies(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("an even hemisphere of 100 cd is 200 pi lumens", "[sim][ies]") {
  const IesFile file = parse_ies(even_below(), "lamp.ies");
  CHECK(file.lumens == Approx(200.0 * ies_pi).epsilon(1e-14));
  CHECK(file.lamp_lumens == 1000.0);
  CHECK(file.watts == 60.0);
  CHECK(file.candela.vertical_rad == std::vector{0.0, ies_pi / 4, ies_pi / 2});
  CHECK(file.candela.horizontal_rad == std::vector{0.0});
  CHECK(file.candela.value == std::vector{100.0, 100.0, 100.0});
}

TEST_CASE("multiplier and ballast factors scale candela; the second factor ends with 1995",
          "[sim][ies]") {
  const auto lumens = [](const std::string& version) {
    return parse_ies(file_text(version, "2 -1 10 2 1 1 1 0.5 0.5 0\n0.9 0.8 100\n0 180\n0\n1 1\n"),
                     "lamp.ies");
  };
  for (const char* old : {"IESNA91", "IESNA:LM-63-1995", "Luminaire of 1986"}) {
    CHECK(lumens(old).lumens == Approx(4.0 * ies_pi * 7.2).epsilon(1e-14));
  }
  CHECK(lumens("IESNA:LM-63-2002").lumens == Approx(4.0 * ies_pi * 9.0).epsilon(1e-14));
  CHECK(lumens("IESNA91").lamp_lumens == 0.0);  // -1: absolute photometry
}

TEST_CASE("numbers end where they end, not lines; commas, plus signs and DOS are welcome",
          "[sim][ies]") {
  const IesFile file = parse_ies(
      "IESNA91\r\nTILT=NONE\r\n1,+1000.,1E0 2\r\n 2 1 2 0 0 0 1 1 .5 0 90 0\r\n90 1 2\r\n\r\n3 "
      "4\r\n\x1A",
      "lamp.ies");
  CHECK(file.candela.horizontal_rad.size() == 2);
  CHECK(file.candela.value == std::vector{1.0, 2.0, 3.0, 4.0});
}

TEST_CASE("horizontal angles from 90 to 270 are mirrored to a whole turn", "[sim][ies]") {
  const auto candela = [](const std::string& horizontal, const std::string& values, int count) {
    return parse_ies(file_text("IESNA:LM-63-1995", "1 -1 1 2 " + std::to_string(count) +
                                                       " 1 2 0 0 0\n1 1 1\n0 90\n" + horizontal +
                                                       "\n" + values + "\n"),
                     "lamp.ies")
        .candela;
  };
  const auto with_seam = candela("90 180 270", "1 1 2 2 3 3", 3);
  CHECK(with_seam.horizontal_rad ==
        std::vector{0.0, ies_pi / 2, ies_pi, 1.5 * ies_pi, 2.0 * ies_pi});
  CHECK(with_seam.value == std::vector<double>{2, 2, 1, 1, 2, 2, 3, 3, 2, 2});
  const auto without = candela("90 150 210 270", "1 1 3 3 5 5 7 7", 4);
  REQUIRE(without.horizontal_rad.size() == 9);
  CHECK(without.value[0] == 4.0);  // 180 degrees, between 3 and 5
  CHECK(without.horizontal_rad[1] == Approx(ies_pi / 6).epsilon(1e-14));
  CHECK(without.value[2] == 3.0);
  CHECK(without.horizontal_rad[7] == Approx(330.0 / 180.0 * ies_pi).epsilon(1e-14));
  CHECK(without.value[14] == 5.0);
}

TEST_CASE("what is wrong with a photometric file is told in its place", "[sim][ies]") {
  CHECK(message("hello\n") ==
        "lamp.ies: error: no line begins with TILT=: not a photometric file of IES LM-63\n");
  CHECK(message(replaced_ies(even_below(), "TILT=NONE", "TILT=INCLUDE")) ==
        "lamp.ies:3:1: error: expected TILT=NONE, found \"TILT=INCLUDE\"\n"
        "    3 | TILT=INCLUDE\n"
        "      | ^\n"
        "    hint: light that depends on the luminaire's tilt is not supported\n");
  CHECK(message(replaced_ies(even_below(), "3 1 1 2", "3 1 2 2")) ==
        "lamp.ies:4:14: error: expected photometric type 1 (C), found 2\n"
        "    4 | 1 1000 1 3 1 2 2 0 0 0\n"
        "      |              ^\n");
  CHECK(message(replaced_ies(even_below(), "0 45 90", "0 95 90")) ==
        "lamp.ies:6:6: error: the vertical angles must ascend\n"
        "    6 | 0 95 90\n"
        "      |      ^\n");
  CHECK(message(replaced_ies(even_below(), "100 100 100", "100 -1 100")) ==
        "lamp.ies:8:5: error: a candela value is negative\n"
        "    8 | 100 -1 100\n"
        "      |     ^\n");
  CHECK(message(replaced_ies(even_below(), "100 100 100", "100 x 100")) ==
        "lamp.ies:8:5: error: expected a candela value, found \"x\"\n"
        "    8 | 100 x 100\n"
        "      |     ^\n");
  CHECK(message(replaced_ies(even_below(), "100 100 100", "100 100")) ==
        "lamp.ies:8:5: error: the file ends where a candela value is expected\n"
        "    8 | 100 100\n"
        "      |     ^\n");
  CHECK(message(even_below() + "7") ==
        "lamp.ies:9:1: error: the file goes on after its last candela value\n"
        "    9 | 7\n"
        "      | ^\n");
  CHECK(message(replaced_ies(even_below(), "100 100 100", "0 0 0")) ==
        "lamp.ies:8:5: error: the luminaire gives no light: all its candela values are 0\n"
        "    8 | 0 0 0\n"
        "      |     ^\n");
  CHECK(message(replaced_ies(even_below(), "1 1000 1 3", "1 1000 1 1e9"))
            .find("the number of vertical angles must be a whole number from 2 to 10000") !=
        std::string::npos);
  CHECK(message(file_text("IESNA91", "1 1 1 2 2 1 2 0 0 0 1 1 1 0 90 0 45 1 1 1 1"))
            .find("horizontal angles must reach from 0 to 90, 180 or 360 degrees, or from 90 to "
                  "270") != std::string::npos);
  CHECK(message("") ==
        "lamp.ies: error: no line begins with TILT=: not a photometric file of IES LM-63\n");
  CHECK_THROWS_AS(read_ies("/nowhere/lamp.ies"), InputError);
}
