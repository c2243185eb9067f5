#include <fstream>
#include <iterator>
#include <string>

#include "core/diagnostics.hpp"
#include "core/error.hpp"
#include "sim/scenario/read_scenario.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

std::string shipped_cut(const std::string& name) {
  std::ifstream stream{std::string{NADIR_SOURCE_DIR} + "/scenes/" + name, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

/// Whether a text is refused, and by nothing but an InputError that says where.
bool refused_cut(const std::string& text, const std::string& file) {
  Diagnostics diagnostics;
  try {
    static_cast<void>(parse_scenario(text, file, diagnostics));
    return false;
  } catch (const InputError& error) {
    return !error.issues().empty() && error.issues().front().where.line > 0;
  }
}

}  // namespace

TEST_CASE("a scenario that ends at any byte is refused with the place of the mistake",
          "[sim][scenario]") {
  const std::string folder = std::string{NADIR_SOURCE_DIR} + "/scenes/trials/cut.xml";
  std::string text = shipped_cut("trials/furnace.xml");
  // Without the library, which would be read again for every byte.
  const std::size_t library = text.find("<library");
  text.erase(library, text.find("/>", library) + 2 - library);
  const std::string from = "from=\"compacted_soil\"";
  text.replace(text.find(from), from.size(), "reflectance=\"0.2\"");
  REQUIRE_FALSE(refused_cut(text, folder));
  const std::size_t end = text.rfind('>');
  for (std::size_t length = 0; length <= end; ++length) {
    if (refused_cut(text.substr(0, length), folder)) continue;
    FAIL_CHECK("taken when cut after byte " << length);
  }
}

}  // namespace nadir::sim
