#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <random>
#include <string>

#include "end_to_end/killed_run.hpp"
#include "end_to_end/tiny_scenario.hpp"
#include "support/catch.hpp"

namespace nadir::end_to_end {
namespace {

namespace fs = std::filesystem;
using sim::support::ScratchFolder;
using Seconds = std::chrono::duration<double>;

/// A ball on a field under a sky, seen by two arrays one after the other.
TinyScenario ball(int samples, int lines) {
  TinyScenario scenario;
  scenario.bodies = R"(<body name="sun" azimuth_deg="140" elevation_deg="35" irradiance="1500"/>)";
  scenario.atmosphere =
      R"(<uniform sky_radiance="60" sky_temperature_k="250" transmittance="0.9"/>)";
  scenario.geometry = R"(<plane material="grey" size_x_m="400" size_y_m="400"/>)"
                      R"(<sphere name="ball" material="grey" radius_m="8" up_m="8"/>)";
  const std::string size =
      "samples=\"" + std::to_string(samples) + "\" lines=\"" + std::to_string(lines) + "\"";
  scenario.camera = "<orthographic><array name=\"a\" " + size + " ground_pitch_m=\"" +
                    std::to_string(40.0 / samples) + "\">" + scenario.band +
                    R"(<band_gaussian name="t" centre_um="10.9" fwhm_um="0.6"/></array>)"
                    R"(<array name="b" samples="40" lines="40" ground_pitch_m="1">)"
                    R"(<band_box name="c" lo_um="0.6" hi_um="0.7"/></array></orthographic>)";
  scenario.products = R"(quick_look="true" exr="true" sidecars="false")";
  return scenario;
}

/// A scenario in a folder of its own, and runs of it.
struct Runs {
  ScratchFolder scratch;
  fs::path scenario = scratch / "tiny.xml";

  explicit Runs(const TinyScenario& input) { write_file(scenario, input.text()); }
  [[nodiscard]] fs::path folder(const std::string& name) const { return scratch / name; }
  [[nodiscard]] CommandResult run(const std::string& name, const std::string& options = "") const {
    const auto result = run_nadir("run " + scenario.string() + " --audit 0 -o " +
                                  folder(name).string() + " " + options);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return result;
  }
  [[nodiscard]] bool killed(const std::string& name, Seconds after, bool more = false) const {
    std::vector<std::string> line{"run", scenario.string(),    "--audit", "0",
                                  "-o",  folder(name).string()};
    if (more) line.emplace_back("--more");
    return kill_nadir_after(line, after);
  }
  [[nodiscard]] std::vector<float> plane(const std::string& name, const std::string& file) const {
    return first_plane(folder(name) / file);
  }
};

bool says(const CommandResult& result, const std::string& text) {
  return result.err.find(text) != std::string::npos;
}

void check_same_files(const fs::path& a, const fs::path& b) {
  const auto wanted = files_of_run(a), found = files_of_run(b);
  REQUIRE(wanted.size() == found.size());
  for (const auto& [name, content] : wanted) {
    CAPTURE(name);
    CHECK((found.count(name) == 1 && found.at(name) == content));
  }
}

Seconds time_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::steady_clock::now() - start;
}

/// Kills a run at so many moments spread over its length, and resumes each.
void kill_and_resume(const TinyScenario& scenario, int moments) {
  const Runs runs{scenario};
  const Seconds whole = time_of([&] { static_cast<void>(runs.run("whole")); });
  std::mt19937 random{20260621};
  std::uniform_real_distribution<double> within{0.0, 1.0};
  int killed = 0, resumed = 0;
  for (int i = 0; i < moments; ++i) {
    const std::string name = "killed" + std::to_string(i);
    const Seconds moment = whole * ((i + within(random)) / moments);
    CAPTURE(moment.count(), whole.count());
    killed += runs.killed(name, moment) ? 1 : 0;
    const auto result = runs.run(name);
    resumed += says(result, "resumed: ") ? 1 : 0;
    check_same_files(runs.folder("whole"), runs.folder(name));
    fs::remove_all(runs.folder(name));
  }
  CHECK(killed > 0);  // the last moments may come after the end
  CHECK(resumed > 0);
}

TEST_CASE("a run killed at any moment goes on and gives the same bytes", "[end_to_end][resume]") {
  TinyScenario scenario = ball(160, 96);
  scenario.samples = 8;
  kill_and_resume(scenario, 3);
}

TEST_CASE("runs killed at twenty moments give the same bytes", "[.slow][resume]") {
  TinyScenario scenario = ball(1024, 300);  // three strips, then another array
  scenario.samples = 2;
  kill_and_resume(scenario, 20);
}

TEST_CASE("a run that is killed again and again comes to its end", "[.slow][resume]") {
  TinyScenario scenario = ball(320, 300);
  scenario.samples = 16;
  const Runs runs{scenario};
  const Seconds whole = time_of([&] { static_cast<void>(runs.run("whole")); });
  int kills = 0;
  while (runs.killed("often", 0.3 * whole) && kills < 100) ++kills;
  CHECK(kills > 0);
  CHECK(kills < 30);  // 3 or 4, and start and end of each; more on a machine that is busy
  check_same_files(runs.folder("whole"), runs.folder("often"));
}

TEST_CASE("a finished run started again renders nothing", "[end_to_end][resume]") {
  const Runs runs{ball(40, 36)};
  CHECK_FALSE(says(runs.run("a"), "resumed"));
  const auto before = files_of_run(runs.folder("a"));
  CHECK(says(runs.run("a"), "all samples were there: nothing is rendered"));
  CHECK(files_of_run(runs.folder("a")) == before);
}

TEST_CASE("other products of a finished run are written without rendering",
          "[end_to_end][resume]") {
  TinyScenario scenario = ball(40, 36);
  const Runs runs{scenario};
  static_cast<void>(runs.run("a"));
  scenario.products = R"(quick_look="true" exr="true" sidecars="false" geotiff="true")";
  write_file(runs.scenario, scenario.text());
  CHECK(says(runs.run("a"), "all samples were there: nothing is rendered"));
  CHECK(fs::exists(runs.folder("a") / "a_radiance.tif"));
}

TEST_CASE("another scenario or a fresh start renders all", "[end_to_end][resume]") {
  TinyScenario scenario = ball(40, 36);
  const Runs runs{scenario};
  static_cast<void>(runs.run("a"));
  const auto before = files_of_run(runs.folder("a"));
  const auto fresh = runs.run("a", "--fresh");
  CHECK_FALSE(says(fresh, "resumed"));
  CHECK(files_of_run(runs.folder("a")) == before);
  scenario.materials = R"(<material name="grey" reflectance="0.4"/>)";
  write_file(runs.scenario, scenario.text());
  const auto other = runs.run("a");
  CHECK_FALSE(says(other, "resumed"));
  CHECK(says(other,
             "holds samples of another run (not the same: scenario): kept as "
             "samples.nadir.old until this run is finished"));
  CHECK_FALSE(fs::exists(runs.folder("a") / "samples.nadir.old"));
  CHECK(files_of_run(runs.folder("a")) != before);
}

TEST_CASE("samples that are not to be kept are gone when the run is finished",
          "[end_to_end][resume]") {
  TinyScenario scenario = ball(40, 36);
  scenario.products += R"( keep_samples="false")";
  const Runs runs{scenario};
  static_cast<void>(runs.run("a"));
  CHECK_FALSE(fs::exists(runs.folder("a") / "samples.nadir"));
  const auto more =
      run_nadir("run " + runs.scenario.string() + " --more -o " + runs.folder("a").string());
  CHECK(more.exit_code == 2);
  CHECK(says(more, "there are no samples of a run here that more could be added to"));
}

double mean_square(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float value : values) sum += static_cast<double>(value) * value;
  return sum / static_cast<double>(values.size());
}

/// Of pixels whose error is known to nothing worse than chance.
double mean_squared_z(const std::vector<float>& difference, const std::vector<float>& error) {
  double sum = 0.0, weight = 0.0;
  for (std::size_t i = 0; i < difference.size(); ++i) {
    sum += static_cast<double>(difference[i]) * difference[i];
    weight += static_cast<double>(error[i]) * error[i];
  }
  return sum / weight;
}

TEST_CASE("more samples shrink the error by the square root of two", "[end_to_end][resume]") {
  const Runs runs{ball(64, 64)};
  static_cast<void>(runs.run("a"));
  const auto first = runs.plane("a", "a_radiance.img"), error = runs.plane("a", "a_error.img");
  static_cast<void>(runs.run("a", "--more"));
  const auto both = runs.plane("a", "a_radiance.img"), smaller = runs.plane("a", "a_error.img");
  // The variance of the mean of two is the mean variance over two. 4096 pixels with 3 degrees of
  // freedom each know their mean variance to 1.3 % where it is even, to some 4 % where few pixels
  // at the ball's edge have most of it.
  CHECK(mean_square(smaller) / mean_square(error) == Approx(0.5).epsilon(0.15));
  // What was added is (both - first), with variance s^2 / 4 + s^2 / 4 of s^2 at first: one half.
  std::vector<float> added(both.size());
  for (std::size_t i = 0; i < both.size(); ++i) added[i] = both[i] - first[i];
  CHECK(mean_squared_z(added, error) == Approx(0.5).epsilon(0.3));
  // And again: three times the samples.
  static_cast<void>(runs.run("a", "--more"));
  CHECK(mean_square(runs.plane("a", "a_error.img")) / mean_square(error) ==
        Approx(1.0 / 3.0).epsilon(0.15));
}

TEST_CASE("more samples are the same bytes, killed or not", "[end_to_end][resume]") {
  TinyScenario scenario = ball(160, 96);
  scenario.samples = 4;
  const Runs runs{scenario};
  static_cast<void>(runs.run("whole"));
  static_cast<void>(runs.run("killed"));
  const Seconds whole = time_of([&] { static_cast<void>(runs.run("whole", "--more")); });
  CHECK(runs.killed("killed", 0.5 * whole, true));
  static_cast<void>(runs.run("killed", "--more"));  // goes on with these, and adds no others
  check_same_files(runs.folder("whole"), runs.folder("killed"));
  static_cast<void>(runs.run("killed"));
  check_same_files(runs.folder("whole"), runs.folder("killed"));
}

TEST_CASE("runs with two seeds merge into their mean with its error", "[end_to_end][resume]") {
  const Runs runs{ball(40, 36)};
  static_cast<void>(runs.run("a", "--seed 1"));
  static_cast<void>(runs.run("b", "--seed 2"));
  const auto merged = run_nadir("merge " + runs.folder("a").string() + " " +
                                runs.folder("b").string() + " -o " + runs.folder("ab").string());
  INFO(merged.err);
  REQUIRE(merged.exit_code == 0);
  const auto a = runs.plane("a", "a_radiance.img"), b = runs.plane("b", "a_radiance.img"),
             ab = runs.plane("ab", "a_radiance.img"), ea = runs.plane("a", "a_error.img"),
             eb = runs.plane("b", "a_error.img"), eab = runs.plane("ab", "a_error.img");
  REQUIRE(ab.size() == a.size());
  for (std::size_t i = 0; i < ab.size(); ++i) {
    // rounding of floats
    CHECK(ab[i] == Approx(0.5 * (a[i] + b[i])).epsilon(1e-6));
    CHECK(eab[i] == Approx(0.5 * std::hypot(ea[i], eb[i])).epsilon(1e-6).margin(1e-30));
  }
  CHECK(files_of_run(runs.folder("ab")).size() == files_of_run(runs.folder("a")).size());
  // The truth is the first run's.
  CHECK(files_of_run(runs.folder("ab")).at("a_truth.img") ==
        files_of_run(runs.folder("a")).at("a_truth.img"));
}

TEST_CASE("merging the same samples, or another scene, is refused in one sentence",
          "[end_to_end][resume]") {
  TinyScenario scenario = ball(24, 24);
  const Runs runs{scenario};
  static_cast<void>(runs.run("a"));
  static_cast<void>(runs.run("b"));
  const std::string merge = "merge " + runs.folder("a").string() + " ";
  const std::string output = " -o " + runs.folder("ab").string();
  const auto same = run_nadir(merge + runs.folder("b").string() + output);
  CHECK(same.exit_code == 2);
  CHECK(says(same, "both have the samples of seed 1: the same samples cannot count twice"));
  scenario.materials = R"(<material name="grey" reflectance="0.4"/>)";
  write_file(runs.scenario, scenario.text());
  static_cast<void>(runs.run("c", "--seed 2"));
  const auto other = run_nadir(merge + runs.folder("c").string() + output);
  CHECK(other.exit_code == 2);
  CHECK(says(other, "(not the same: scenario)"));
  CHECK_FALSE(fs::exists(runs.folder("ab")));
}

}  // namespace
}  // namespace nadir::end_to_end
