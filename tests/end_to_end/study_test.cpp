#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "end_to_end/command.hpp"
#include "end_to_end/tiny_scenario.hpp"
#include "support/catch.hpp"

namespace nadir::end_to_end {
namespace {

using sim::support::content_of;
using sim::support::ScratchFolder;

/// A white and a grey box on grey ground in the sun, some hundred pixels.
TinyScenario small_street() {
  TinyScenario scenario;
  scenario.bodies = R"(<body name="sun" azimuth_deg="140" elevation_deg="40" irradiance="1000"/>)";
  scenario.atmosphere = R"(<uniform sky_radiance="60"/>)";
  scenario.materials = R"(<material name="grey" reflectance="0.3"/>)"
                       R"(<material name="white" reflectance="0.7"/>)";
  scenario.geometry = R"(<plane material="grey" size_x_m="200" size_y_m="200"/>)"
                      R"(<box material="white" lo_m="-6 -6 0" hi_m="-2 6 8"/>)"
                      R"(<box material="grey" lo_m="2 -6 0" hi_m="6 6 6"/>)";
  scenario.array = R"(samples="24" lines="16" ground_pitch_m="1")";
  return scenario;
}

std::filesystem::path write_street(const ScratchFolder& folder) {
  const auto file = folder / "street.xml";
  write_file(file, small_street().text());
  return file;
}

CommandResult study(const std::filesystem::path& scenario, const std::filesystem::path& out,
                    const std::string& options) {
  return run_nadir("study " + scenario.string() + " --threads 2 -o " + out.string() + " " +
                   options);
}

TEST_CASE("the study of a small scene ends within its budget with all its pages", "[end_to_end]") {
  const ScratchFolder folder;
  const auto scenario = write_street(folder), out = folder / "study";
  const auto start = std::chrono::steady_clock::now();
  const auto result = study(scenario, out, "--budget 6s");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  // 5 % and what starting the program takes. A study that is told to take six seconds may be
  // done sooner.
  CHECK(took.count() < 1.05 * 6.0 + 0.5);

  const auto json = nlohmann::json::parse(content_of(out / "study.json"));
  CHECK(json.at("recommendations").size() == 4);
  CHECK(json.at("recommendations").at(0).at("reached") == true);
  CHECK(json.at("rows").size() > 5);
  CHECK(json.at("rows").at(0).at("name") == "path solver");
  CHECK(json.at("pareto").size() > 1);
  CHECK(json.at("spent_s").get<double>() < 1.05 * 6.0);
  CHECK(content_of(out / "study.csv").find("error_percent") != std::string::npos);
  const std::string page = content_of(out / "study.html");
  CHECK(page.find("data:image/png;base64,") != std::string::npos);
  CHECK(page.find("Recommended settings") != std::string::npos);

  // Started again, it has nothing to measure and writes the same pages.
  std::filesystem::remove(out / "study.html");
  const auto again = study(scenario, out, "--budget 6s");
  CAPTURE(again.err);
  REQUIRE(again.exit_code == 0);
  CHECK(again.out.find("had been measured") != std::string::npos);
  CHECK(content_of(out / "study.html") == page);

  // A changed scenario is another study.
  TinyScenario other = small_street();
  other.bodies = R"(<body name="sun" azimuth_deg="140" elevation_deg="50" irradiance="1000"/>)";
  write_file(scenario, other.text());
  const auto changed = study(scenario, out, "--budget 2s");
  REQUIRE(changed.exit_code == 0);
  CHECK(changed.out.find("had been measured") == std::string::npos);
}

TEST_CASE("a study that was killed goes on from its rows", "[end_to_end]") {
  const ScratchFolder folder;
  const auto scenario = write_street(folder), out = folder / "study";
  const std::string command = std::string{"timeout -s KILL 2.5 "} + NADIR_COMMAND + " study " +
                              scenario.string() + " --budget 6s --quiet -o " + out.string();
  CHECK(std::system((command + " 2>/dev/null").c_str()) != 0);
  const std::string rows = content_of(out / "study.rows");
  const std::string whole = rows.substr(0, rows.rfind('\n') + 1);
  REQUIRE(whole.find("\"kind\":\"header\"") != std::string::npos);
  const auto result = study(scenario, out, "--budget 6s");
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  const std::string all = content_of(out / "study.rows");
  CHECK(all.size() > whole.size());
  CHECK(all.substr(0, whole.size()) == whole);
  CHECK(all.find("\"kind\":\"header\"", whole.size()) == std::string::npos);
  CHECK(all.find("\"kind\":\"finished\"") != std::string::npos);
}

TEST_CASE("a study with bad input says so and leaves nothing behind", "[end_to_end]") {
  const ScratchFolder folder;
  const auto out = folder / "study";
  CHECK(study(folder / "none.xml", out, "").exit_code == 2);
  const auto result = study(write_street(folder), out, "--budget soon");
  CHECK(result.exit_code == 2);
  CHECK(result.err.find("--budget is \"soon\"") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(out));
}

/// The headless browser, or an empty text.
std::string browser() {
  const ScratchFolder folder;
  const auto name = folder / "name";
  const std::string line =
      "command -v chromium chromium-browser google-chrome >" + name.string() + " 2>/dev/null";
  static_cast<void>(std::system(line.c_str()));
  const std::string names = content_of(name);
  return names.substr(0, names.find('\n'));
}

/// Opens a page without any network.
CommandResult open_page(const std::string& program, const std::filesystem::path& page,
                        const std::string& options) {
  const ScratchFolder folder;
  const auto out = folder / "out", err = folder / "err";
  const std::string line =
      "timeout 120 " + program + " --headless --no-sandbox --disable-gpu --disable-sync " +
      "--no-first-run --disable-background-networking --host-resolver-rules='MAP * ~NOTFOUND' " +
      "--enable-logging=stderr --window-size=1200,2400 --user-data-dir=" +
      (folder / "profile").string() + " " + options + " file://" + page.string() + " >" +
      out.string() + " 2>" + err.string();
  const int status = std::system(line.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(err)};
}

// Of every picture and plot its size on the page, of every error and request a line.
constexpr const char* measuring_script = R"(<script>
const errors = [];
addEventListener('error', e => errors.push('error ' + e.message), true);
addEventListener('securitypolicyviolation', e => errors.push('refused ' + e.blockedURI));
addEventListener('load', () => {
  const found = { images: [], plots: [], errors, requests: [] };
  for (const image of document.images)
    found.images.push([image.naturalWidth, image.getBoundingClientRect().width]);
  for (const plot of document.querySelectorAll('svg.plot'))
    found.plots.push([plot.getBoundingClientRect().width, plot.getBoundingClientRect().height,
                      plot.querySelectorAll('circle').length]);
  for (const entry of performance.getEntriesByType('resource'))
    if (!entry.name.startsWith('data:')) found.requests.push(entry.name);
  document.body.innerHTML = '<pre id="found">' + JSON.stringify(found) + '</pre>';
});
</script>)";

/// The page with a script in its head that replaces it by what it measured.
std::string with_script(std::string page) {
  const std::string policy = "style-src 'unsafe-inline'";
  page.replace(page.find(policy), policy.size(), policy + "; script-src 'unsafe-inline'");
  const auto head = page.find("<link rel=\"icon\"");
  REQUIRE(head != std::string::npos);
  return page.insert(head, measuring_script);
}

TEST_CASE("a browser without network shows the study's page whole and without errors",
          "[end_to_end]") {
  const std::string program = browser();
  if (program.empty()) {
    WARN("skipped: no chromium here; tools/setup.sh --checks installs it");
    return;
  }
  const ScratchFolder folder;
  const auto out = folder / "study";
  REQUIRE(study(write_street(folder), out, "--budget 5s --quiet").exit_code == 0);
  const std::string page = content_of(out / "study.html");
  CHECK(page.find("http://") == std::string::npos);
  CHECK(page.find("https://") == std::string::npos);

  const auto shot = folder / "shot.png";
  const auto plain = open_page(program, out / "study.html", "--screenshot=" + shot.string());
  CAPTURE(plain.err);
  REQUIRE(plain.exit_code == 0);
  CHECK(plain.err.find(":CONSOLE") == std::string::npos);
  CHECK(std::filesystem::file_size(shot) > 20'000);  // an empty page has 8 kB

  write_file(folder / "measured.html", with_script(page));
  const auto dump = open_page(program, folder / "measured.html", "--dump-dom");
  const std::string begin = "<pre id=\"found\">";
  const auto at = dump.out.rfind(begin);  // the script itself comes before
  CAPTURE(dump.out.substr(0, 500), dump.err);
  REQUIRE(at != std::string::npos);
  const auto end = dump.out.find("</pre>", at);
  const auto found =
      nlohmann::json::parse(dump.out.substr(at + begin.size(), end - at - begin.size()));
  CAPTURE(found.dump());
  CHECK(found.at("errors").empty());
  CHECK(found.at("requests").empty());
  CHECK(found.at("images").size() == 4);
  for (const auto& image : found.at("images")) {
    CHECK(image.at(0).get<double>() >= 16.0);   // its own pixels
    CHECK(image.at(1).get<double>() >= 200.0);  // on the page
  }
  CHECK(found.at("plots").size() == 2);  // error against time of one array, convergence
  for (const auto& plot : found.at("plots")) {
    CHECK(plot.at(0).get<double>() > 500.0);
    CHECK(plot.at(1).get<double>() > 200.0);
    CHECK(plot.at(2).get<double>() > 5.0);  // marks
  }
}

}  // namespace
}  // namespace nadir::end_to_end
