#include "sim/run/progress.hpp"

#include <cstdio>

#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

std::string shown(Progress::Style style, std::size_t steps) {
  const support::ScratchFolder scratch;
  const auto file = scratch / "log";
  std::FILE* stream = std::fopen(file.c_str(), "w");
  REQUIRE(stream != nullptr);
  {
    Progress progress{stream, style};
    for (std::size_t done = 1; done <= steps; ++done) progress.update(done, steps);
  }
  std::fclose(stream);
  return support::content_of(file);
}

TEST_CASE("durations read as a person would say them", "[sim][progress]") {
  CHECK(readable_duration(0.2) == "1 s");
  CHECK(readable_duration(59.0) == "59 s");
  CHECK(readable_duration(125.0) == "2 min 05 s");
  CHECK(readable_duration(4200.0) == "1 h 10 min");
}

TEST_CASE("a log gets one plain line for every tenth", "[sim][progress]") {
  const std::string log = shown(Progress::Style::lines, 40);
  std::size_t lines = 0;
  for (const char c : log) lines += c == '\n' ? 1 : 0;
  CHECK(lines == 10);
  CHECK(log.find("rendering:  10 %, ") == 0);
  CHECK(log.find("rendering: 100 %, 0 s left\n") != std::string::npos);
  CHECK(log.find('\r') == std::string::npos);
}

TEST_CASE("a terminal gets a bar that ends full, on its own line", "[sim][progress]") {
  const std::string bar = shown(Progress::Style::bar, 3);
  CHECK(bar.find("\rrendering [") == 0);
  CHECK(bar.find("[========================================] 100 %") != std::string::npos);
  CHECK(bar.back() == '\n');
}

TEST_CASE("a quiet run shows nothing, and a file is not a terminal", "[sim][progress]") {
  CHECK(shown(Progress::Style::none, 5).empty());
  CHECK(Progress::style_for(stderr, true) == Progress::Style::none);
}

}  // namespace
}  // namespace nadir::sim
