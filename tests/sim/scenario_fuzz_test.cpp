#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "random_bytes.hpp"
#include "scenario_support.hpp"
#include "support/catch.hpp"

using namespace nadir;

namespace {

/// One to four edits: a byte changed to any other or to one that means something in XML, a piece
/// cut out, doubled or moved.
std::string mutated_fuzz(std::string text, sim::support::RandomBytes& random) {
  const std::string meaningful = "<>/=\"'& \t\n!-?[].,0123456789eExX#;:\xFF";
  for (std::uint32_t edits = 1 + random.below(4); edits > 0 && !text.empty(); --edits) {
    const std::size_t at = random.below(text.size());
    const std::size_t length = std::min<std::size_t>(1 + random.below(40), text.size() - at);
    const std::string piece = text.substr(at, length);
    switch (random.below(5)) {
      case 0:
        text[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        text[at] = meaningful[random.below(meaningful.size())];
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(at, piece);
        break;
      default:
        text.insert(random.below(text.size()), piece);
        break;
    }
  }
  return text;
}

bool taken_or_told(const std::string& text) {
  Diagnostics diagnostics;
  try {
    static_cast<void>(sim::parse_scenario(text, test::data_folder() / "fuzz.xml", diagnostics));
    return true;
  } catch (const InputError& error) {
    REQUIRE_FALSE(error.issues().empty());
    for (const InputIssue& issue : error.issues()) {
      REQUIRE(issue.where.line >= 1);
      REQUIRE(issue.where.column >= 1);
      REQUIRE_FALSE(issue.message.empty());
    }
    return false;
  }
}

}  // namespace

// Any other exception, or a crash, fails the test; the sanitizers watch it in their build.
TEST_CASE("a damaged scenario is taken or its mistakes are told with their lines",
          "[scenario][fuzz]") {
  const std::string good = GENERATE(test::minimal_text(), test::full_text(), test::warm_text());
  sim::support::RandomBytes random{20260621};
  int taken = 0;
  for (int i = 0; i < 1500; ++i) taken += taken_or_told(mutated_fuzz(good, random)) ? 1 : 0;
  // Some edits fall into comments, blanks or titles: both outcomes must have been met.
  CHECK(taken > 10);
  CHECK(taken < 1000);
}

// Mistakes of meaning are the reader's alone, so the reverse does not hold.
TEST_CASE("what the reader takes of damaged scenarios the XML schema takes as well",
          "[scenario][fuzz]") {
  if (std::system("xmllint --version >/dev/null 2>&1") != 0) {
    WARN("xmllint (package libxml2-utils) is not there: the XML schema is not checked");
    return;
  }
  const test::TemporaryFolder folder;
  sim::support::RandomBytes random{14};
  std::string command =
      std::string{"xmllint --noout --schema "} + NADIR_SOURCE_DIR + "/scenes/schema/nadir.xsd";
  int taken = 0;
  for (int i = 0; i < 1500; ++i) {
    const std::string text =
        mutated_fuzz(i % 2 == 0 ? test::full_text() : test::warm_text(), random);
    if (!taken_or_told(text)) continue;
    const auto file = folder / (std::to_string(i) + ".xml");
    std::ofstream{file, std::ios::binary} << text;
    command += " " + file.string();
    ++taken;
  }
  CHECK(taken > 10);
  const bool all_valid =
      std::system((command + " >" + (folder / "log").string() + " 2>&1").c_str()) == 0;
  INFO((all_valid ? "" : test::file_text(folder / "log")));
  CHECK(all_valid);
}
