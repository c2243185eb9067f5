#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>

#include "air_table_support.hpp"
#include "core/error.hpp"
#include "random_bytes.hpp"
#include "sim/files/air_table_file.hpp"
#include "sim/files/modtran_csv.hpp"
#include "sim/files/modtran_tape7.hpp"
#include "sim/files/uvspec_output.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

namespace {

/// One to three edits: a byte changed to any other or to one that means something, a piece cut out
/// or doubled.
std::string mutated(std::string text, sim::support::RandomBytes& random) {
  const std::string meaningful = "=.,-+eExX0123456789 \n\t#_@\xFF";
  for (std::size_t edits = 1 + random.below(3); edits > 0 && !text.empty(); --edits) {
    const std::size_t at = random.below(text.size());
    const std::size_t length = std::min<std::size_t>(1 + random.below(30), text.size() - at);
    switch (random.below(4)) {
      case 0:
        text[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        text[at] = meaningful[random.below(meaningful.size())];
        break;
      case 2:
        text.erase(at, length);
        break;
      default:
        text.insert(at, text.substr(at, length));
        break;
    }
  }
  return text;
}

/// How many of the damaged texts are taken; the others must be told as mistakes of input. Any other
/// exception, or a crash, fails the test; the sanitizers watch it in their build.
int taken(const std::string& good, const std::function<void(const std::string&)>& read) {
  read(good);
  sim::support::RandomBytes random{20260621};
  int count = 0;
  for (int i = 0; i < 400; ++i) {
    const std::string text = mutated(good, random);
    try {
      read(text);
      ++count;
    } catch (const InputError& error) {
      CAPTURE(text);
      REQUIRE_FALSE(error.issues().empty());
      REQUIRE_FALSE(error.issues().front().message.empty());
    }
  }
  return count;
}

const AirRunSettings on_sea{0.0, 100'000.0, 0.5, 1.0};

const char* const tape7 =
    "T F 6    3    2    1    6    6    6    6    6    6    1    0    0   0.000   0.00\n"
    "   36STANDARD\n"
    "   0.00000 100.00000  20.00000 106.31252   0.32202   0.00000    0        0.00000\n"
    "    2    2    1    0\n"
    "  90.00000  40.00000   0.00000   0.00000   0.00000   0.00000   0.00000   0.00000\n"
    "    1000.0    2000.0       1.0       1.0NW\n"
    "    0   0    0.000  0    0.000  0    1.000\n"
    "    FREQ  TOT_TRANS  PTH_THRML   SOL_SCAT  TOTAL_RAD  REF_SOL  SOL@OBS    TOA_SUN\n"
    " 1000.00 0.50000000 2.0000E-06 1.0000E-06 3.0000E-06 1.00E-06 2.00E-06 4.0000E-06\n"
    " 2000.00 0.60000000 2.0000E-06 0.0000E+00 2.0000E-06 1.00E-06 2.00E-06 4.0000E-06\n"
    " -9999.\n";

const char* const csv =
    "run 1\nfreq,path_trans,path_emiss,total_rad\ncm-1,,\n1000,0.5,1e-6,1e-6\n2000,0.6,2e-6,2e-6\n"
    "-9999.\n";

const char* const uvspec_input =
    "source solar\nsza 30\numu -1 -0.5 0.5\nphi 0 90\nzout 0 5 TOA\n"
    "output_user lambda edir edn uu\n";
const char* const uvspec_output =
    "500 800 90 1 2 3 4 5 6\n500 900 90 1 2 3 4 5 6\n500 1000 90 1 2 3 4 5 6\n";

}  // namespace

TEST_CASE("a damaged table of the air is taken or its mistakes are told", "[air_table][fuzz]") {
  const std::string good = air_table_bytes({support::some_table(), "abc"});
  const auto read = [](const std::string& text) {
    static_cast<void>(parse_air_table(text, "fuzz.air"));
  };
  CHECK(taken(good, read) == 0);
  // The same with a head whose checksum was made anew: now its reader is met.
  const std::size_t head = good.find("payload_bytes");
  const auto read_head = [&](const std::string& text) {
    read(support::sealed(text + good.substr(head)));
  };
  const int count = taken(good.substr(0, head), read_head);
  CHECK(count > 2);  // a changed note, a changed angle
  CHECK(count < 390);
}

TEST_CASE("damaged runs of other programs are taken or their mistakes are told",
          "[modtran][uvspec][fuzz]") {
  const auto table = [](const AirRunSet& set) { static_cast<void>(table_of_runs(set, on_sea)); };
  CHECK(taken(tape7, [&](const std::string& text) {
          table(parse_modtran_tape7(text, "fuzz.tp7", on_sea));
        }) > 10);
  const RunGeometry up;
  CHECK(taken(csv, [&](const std::string& text) {
          table(parse_modtran_csv(text, "fuzz.csv", std::span{&up, 1}, on_sea));
        }) > 10);
  CHECK(taken(uvspec_input, [&](const std::string& text) {
          table(parse_uvspec({"fuzz.inp", text}, {"fuzz.out", uvspec_output}, on_sea, {}));
        }) > 10);
  CHECK(taken(uvspec_output, [&](const std::string& text) {
          table(parse_uvspec({"fuzz.inp", uvspec_input}, {"fuzz.out", text}, on_sea, {}));
        }) > 10);
}
