#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "end_to_end/command.hpp"
#include "support/catch.hpp"

namespace nadir::end_to_end {
namespace {

namespace fs = std::filesystem;

/// Every product by name, but for the report, which holds the clock's readings, and the samples,
/// which lie in the order in which threads made them.
std::map<std::string, std::string> products(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::directory_iterator{folder}) {
    const std::string name = entry.path().filename().string();
    if (name == "report.json" || name == "samples.nadir") continue;
    all[name] = sim::support::content_of(entry.path());
  }
  return all;
}

std::map<std::string, std::string> run_yard(const std::string& options) {
  const sim::support::ScratchFolder scratch;
  const auto result = run_nadir("run " + data_file("yard.xml") + " --quiet --output " +
                                scratch.path().string() + " " + options);
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.empty());
  return products(scratch.path());
}

TEST_CASE("the products are the same bytes for 1, 2 and 7 threads", "[end_to_end]") {
  const auto one = run_yard("--threads 1");
  // Radiance, error, truth, material, object and place as ENVI, EXR, quick look and STAC item of
  // two arrays; brightness temperatures of one; image support data by band.
  REQUIRE(one.size() == 35);
  for (const char* threads : {"2", "7"}) {
    const auto several = run_yard(std::string{"--threads "} + threads);
    REQUIRE(several.size() == one.size());
    for (const auto& [name, content] : one) {
      CAPTURE(threads, name);
      CHECK(several.at(name) == content);
    }
  }
}

TEST_CASE("another seed gives other noise, the same seed the same", "[end_to_end]") {
  const auto first = run_yard("--seed 1"), again = run_yard(""), other = run_yard("--seed 2");
  CHECK(first == again);
  CHECK(first.at("wide_radiance.img") != other.at("wide_radiance.img"));
  CHECK(first.at("wide_radiance.hdr") == other.at("wide_radiance.hdr"));
}

TEST_CASE("an audit of every pixel finds nothing that auto should have kept", "[end_to_end]") {
  // Corners of the picture see the sky, which a uniform air gives no path light of its own.
  run_yard("--audit 1800");  // the audit's warning would be told
}

TEST_CASE("a quiet run prints nothing, a log gets plain lines", "[end_to_end]") {
  const sim::support::ScratchFolder scratch;
  const std::string run = "run " + data_file("yard.xml") + " -o " + scratch.path().string();
  const auto quiet = run_nadir(run + " --quiet");
  CHECK(quiet.out.empty());
  CHECK(quiet.err.empty());
  const auto loud = run_nadir(run);
  CHECK(loud.err.find("rendering: 100 %") != std::string::npos);
  CHECK(loud.err.find('\r') == std::string::npos);
  CHECK(loud.out.find("report.json") != std::string::npos);
}

TEST_CASE("bad input leaves nothing behind and ends with exit code 2", "[end_to_end]") {
  const sim::support::ScratchFolder scratch;
  const fs::path output = scratch / "never";
  const auto result =
      run_nadir("run " + data_file("no_such_scenario.xml") + " -o " + output.string());
  CHECK(result.exit_code == 2);
  CHECK(result.err.find("no_such_scenario.xml: error: ") != std::string::npos);
  CHECK_FALSE(fs::exists(output));
}

TEST_CASE("ten mistakes are ten errors with line and column, and exit code 2", "[end_to_end]") {
  const std::string file =
      std::string{NADIR_SOURCE_DIR} + "/tests/sim/data/scenario/ten_mistakes.xml";
  for (const char* command : {"validate ", "run --quiet "}) {
    const auto result = run_nadir(command + file);
    CHECK(result.exit_code == 2);
    int errors = 0;
    for (auto at = result.err.find(": error: "); at != std::string::npos;
         at = result.err.find(": error: ", at + 1)) {
      ++errors;
    }
    CHECK(errors == 10);
  }
}

TEST_CASE("the shipped demo scenarios are whole", "[end_to_end]") {
  const std::string scenes = std::string{NADIR_SOURCE_DIR} + "/scenes/";
  const auto result =
      run_nadir("validate " + scenes + "jacksboro/day.xml " + scenes + "jacksboro/night.xml " +
                scenes + "showcase/harbour.xml " + scenes + "showcase/harbour_night.xml");
  CAPTURE(result.err, result.out);
  CHECK(result.exit_code == 0);
  CHECK(result.out.find("day.xml: ok (") != std::string::npos);
  CHECK(result.out.find("/night.xml: ok (") != std::string::npos);
  CHECK(result.out.find("harbour.xml: ok (") != std::string::npos);
  CHECK(result.out.find("harbour_night.xml: ok (") != std::string::npos);
  CHECK(result.out.find("\n  ") == std::string::npos);  // a warning
}

TEST_CASE("an output folder that cannot be made is told before the work", "[end_to_end]") {
  const sim::support::ScratchFolder scratch;
  std::ofstream{scratch / "file"} << "taken";
  const auto result =
      run_nadir("run " + data_file("yard.xml") + " -o " + (scratch / "file").string());
  CHECK(result.exit_code == 2);
  CHECK(result.err.find("file: error: this folder cannot be made or written to") !=
        std::string::npos);
  CHECK(result.err.find("rendering") == std::string::npos);
}

TEST_CASE("options that do not exist end with exit code 2, help with 0", "[end_to_end]") {
  CHECK(run_nadir("run --no-such-option").exit_code == 2);
  CHECK(run_nadir("no-such-command").exit_code == 2);
  CHECK(run_nadir("").exit_code == 2);
  CHECK(run_nadir("--help").exit_code == 0);
  CHECK(run_nadir("run --help").exit_code == 0);
  const auto version = run_nadir("--version");
  CHECK(version.exit_code == 0);
  CHECK(version.out == "nadir 0.1.0\n");
}

TEST_CASE("the command does not link the heavy libraries", "[end_to_end]") {
  // OpenImageIO alone would cost 0.3 s at every start.
  const sim::support::ScratchFolder scratch;
  const fs::path list = scratch / "libraries";
  const std::string line = std::string{"ldd "} + NADIR_COMMAND + " >" + list.string();
  REQUIRE(std::system(line.c_str()) == 0);
  const std::string libraries = sim::support::content_of(list);
  CHECK(libraries.find("libembree") != std::string::npos);
  CHECK(libraries.find("libOpenImageIO") == std::string::npos);
  CHECK(libraries.find("libgdal") == std::string::npos);
}

TEST_CASE("materials lists the library, one material, or says which was meant", "[end_to_end]") {
  const auto all = run_nadir("materials");
  CHECK(all.exit_code == 0);
  CHECK(all.out.find("meadow_grass") != std::string::npos);
  const auto one = run_nadir("materials meadow_grass --format json");
  CHECK(one.exit_code == 0);
  CHECK(one.out.find("\"name\": \"meadow_grass\"") != std::string::npos);
  const auto wrong = run_nadir("materials meadow_gras");
  CHECK(wrong.exit_code == 2);
  CHECK(wrong.err ==
        "error: there is no material \"meadow_gras\" in the library\n"
        "    hint: did you mean \"meadow_grass\"?\n");
}

}  // namespace
}  // namespace nadir::end_to_end
