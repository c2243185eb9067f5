#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "end_to_end/air_run.hpp"
#include "support/catch.hpp"

// Air in layers through the whole command: computed once, kept, used again, and never touched where
// a scenario does not call for it.

namespace nadir::end_to_end {

TEST_CASE("the sky of a clear day is blue, and the report tells of the air", "[end_to_end][air]") {
  const AirFolder folder;
  TinyScenario scenario = day();
  scenario.atmosphere = "<layered/>";
  const AirRun up = run_air(folder, looking_up(scenario));
  // Clear sky far from the sun: 2 to 5 times as bright at 0.45 um as at 0.65 um.
  CHECK(up.radiance(0) > 1.5 * up.radiance(1));
  CHECK(up.radiance(1) > 5.0);    // W m^-2 sr^-1 um^-1; black would be 0,
  CHECK(up.radiance(0) < 300.0);  // snow under this sun some 400
  for (const char* entry : {"\"model\": \"layered\"", "\"mode\": \"accurate\"", "\"streams\": 8",
                            "\"from_cache\": false", "\"wavelengths\": 2",
                            "\"lanes\":", "\"interpolation_error\":", "\"name\": \"air\""}) {
    CAPTURE(entry);
    CHECK(up.says(entry));
  }
  // From 50 m up nothing much is lost or added on the way down: E cos 45 rho / pi and a little sky.
  const AirRun down = run_air(folder, scenario.text());
  CHECK(down.radiance(0) > 100.0);
  CHECK(down.radiance(0) < 330.0);
}

TEST_CASE("a second run takes the table from the cache and gives the same bytes",
          "[end_to_end][air]") {
  const AirFolder folder;
  const AirRun first = run_air(folder, looking_up(day()));
  CHECK(first.says("\"from_cache\": false"));
  const AirRun second = run_air(folder, looking_up(day()));
  CHECK(second.says("\"from_cache\": true"));
  CHECK(second.says("\"beam_solves\": 0"));
  CHECK((second.planes == first.planes));

  SECTION("a damaged one is made anew") {
    const fs::path kept = folder.table();
    const std::string bytes = content_of(kept);
    std::string damaged = bytes;
    damaged[damaged.size() / 2] ^= 1;
    write_file(kept, damaged);
    const AirRun third = run_air(folder, looking_up(day()));
    CHECK(third.says("\"from_cache\": false"));
    CHECK(third.says("is damaged and made anew"));
    CHECK((third.planes == first.planes));
    CHECK((content_of(kept) == bytes));
  }
  SECTION("one of another sun is not taken") {
    TinyScenario lower = day();
    lower.bodies.replace(lower.bodies.find("45"), 2, "44");
    CHECK(run_air(folder, looking_up(lower)).says("\"from_cache\": false"));
  }
}

TEST_CASE("bands that share a wavelength run beside each other", "[end_to_end][air]") {
  const AirFolder folder;
  TinyScenario scenario = day();
  scenario.band = R"(<band_box name="wide" lo_um="0.5" hi_um="0.7"/>)"
                  R"(<band_box name="narrow" lo_um="0.55" hi_um="0.65"/>)";
  const AirRun both = run_air(folder, looking_up(scenario));  // one node a band: 0.6 um in both
  CHECK(both.radiance(0) > 5.0);
  CHECK(std::abs(both.radiance(1) / both.radiance(0) - 1.0) < 0.2);  // ozone and the sun differ
  CHECK(run_air(folder, looking_up(scenario)).says("\"from_cache\": true"));
}

TEST_CASE("by night nothing is solved for a body", "[end_to_end][air]") {
  const AirFolder folder;
  TinyScenario scenario = day();
  scenario.bodies = "";
  scenario.band = window;
  const AirRun up = run_air(folder, looking_up(scenario));
  CHECK(up.says("\"beam_solves\": 0"));
  CHECK_FALSE(up.says("\"thermal_solves\": 0"));
  const AirRun down = run_air(folder, scenario.text());
  // Black bodies at 10.7 um: 9.5 at 300 K, 1.5 at 210 K. The ground is grey (0.5) at 300 K under a
  // sky between them.
  CHECK(up.radiance(0) > 0.2);
  CHECK(up.radiance(0) < 0.5 * down.radiance(0));
  CHECK(down.radiance(0) > 4.5);
  CHECK(down.radiance(0) < 9.6);
}

TEST_CASE("in daylight the visible sees no emission", "[end_to_end][air]") {
  const AirFolder folder;
  const AirRun up = run_air(folder, looking_up(day()));
  CHECK(up.says("\"thermal_solves\": 0"));
  CHECK_FALSE(up.says("\"beam_solves\": 0"));
}

TEST_CASE("none and uniform air make no table and open no figures of air", "[end_to_end][air]") {
  const AirFolder folder;
  TinyScenario scenario = day();
  for (const char* air : {"<none/>", R"(<uniform sky_radiance="20" transmittance="0.9"/>)"}) {
    scenario.atmosphere = air;
    const AirRun run = run_air(folder, scenario.text());
    CHECK_FALSE(run.says("\n  \"air\": {"));
    CHECK_FALSE(run.says("library/atmosphere"));
    CHECK_FALSE(fs::exists(folder.cache()));
  }
}

TEST_CASE("validate reads the air but does not compute it", "[end_to_end][air]") {
  const AirFolder folder;
  write_file(folder.folder() / "tiny.xml", day().text());
  const auto result = run_nadir("validate " + (folder.folder() / "tiny.xml").string());
  CAPTURE(result.err);
  CHECK(result.exit_code == 0);
  CHECK_FALSE(fs::exists(folder.cache()));
}

TEST_CASE("a kept table may stand for the air it was made of", "[end_to_end][air]") {
  const AirFolder folder;
  TinyScenario scenario = day();
  const AirRun computed = run_air(folder, looking_up(scenario));
  fs::copy_file(folder.table(), folder.folder() / "day.air");
  scenario.atmosphere = R"(<table file="day.air"/>)";
  const AirRun read = run_air(folder, looking_up(scenario));
  CHECK(read.says("\"model\": \"table\""));
  CHECK((read.planes == computed.planes));

  fs::remove_all(folder.folder() / "out");
  SECTION("but not under another sun") {
    scenario.bodies.replace(scenario.bodies.find("45"), 2, "20");
    CHECK(
        refusal(folder.folder(), scenario)
            .find(
                "tiny.xml:5:13: error: the table of the air does not cover the sun's place in the "
                "sky, elevation 20.00, azimuth 180.00 deg: it was made for elevation 45.00, "
                "azimuth "
                "180.00 deg") == 0);
  }
  SECTION("nor in a band that it does not reach") {
    scenario.band = window;
    CHECK(
        refusal(folder.folder(), scenario) ==
        "tiny.xml:5:13: error: the table of the air was made for other bands: it has no lanes for "
        "10.7 um");
  }
  SECTION("nor at another height") {
    std::string text = scenario.text();
    text.replace(text.find("height_m=\"300\""), 14, "height_m=\"1300\"");
    write_file(folder.folder() / "high.xml", text);
    const auto result = run_nadir("validate " + (folder.folder() / "high.xml").string());
    CHECK(result.exit_code == 2);
    CHECK(result.err.find("high.xml:5:13: error: the table of the air was made for ground 300 m "
                          "above the sea, the site lies at 1300 m") != std::string::npos);
  }
}

TEST_CASE("air that cannot be is refused with its place", "[end_to_end][air]") {
  const AirFolder folder;
  TinyScenario scenario = day();
  const auto said = [&](const std::string& atmosphere) {
    scenario.atmosphere = atmosphere;
    return refusal(folder.folder(), scenario);
  };
  const std::string head = "height_m,pressure_hpa,temperature_k,relative_humidity_percent\n";
  SECTION("a sounding out of order") {
    write_file(folder.folder() / "s.csv",
               head + "0,1013,288,50\n2000,795,275,50\n1900,790,281,50\n");
    CHECK(said(R"(<layered sounding="s.csv"/>)") ==
          "s.csv:4:1: error: heights must ascend: 1900 m follows 2000 m");
  }
  SECTION("a sounding that is wetter than saturated air") {
    write_file(folder.folder() / "s.csv", head + "0,1013,288,50\n1000,900,281,150\n");
    CHECK(said(R"(<layered sounding="s.csv"/>)").find("s.csv:3:") == 0);
  }
  SECTION("a sounding that begins above the site") {
    write_file(folder.folder() / "s.csv", head + "2500,760,275,50\n4000,616,262,50\n");
    CHECK(said(R"(<layered sounding="s.csv"/>)").find("tiny.xml:5:13: error: ") == 0);
  }
  SECTION("visibility 0") {
    CHECK(
        said(R"(<layered><aerosol visibility_km="0"/></layered>)") ==
        "tiny.xml:5:31: error: attribute \"visibility_km\" of <aerosol>: \"0\", expected a number "
        "above 0 and at most 336 [km]");
  }
  SECTION("haze thinner than the air above the haze") {
    CHECK(said(R"(<layered><aerosol optical_depth_550="0.0001"/></layered>)")
              .find("tiny.xml:5:13: error: the haze cannot have an optical depth of 1e-04 at 0.55 "
                    "um: ") == 0);
  }
  SECTION("a cloud upside down") {
    CHECK(said(R"(<layered><cloud type="cumulus" base_m="900" top_m="800" )"
               R"(optical_depth_550="5"/></layered>)")
              .find("tiny.xml:5:57: error: the top of the cloud at 800 m does not lie above its "
                    "base at 900 m") == 0);
  }
  SECTION("a site below the air") {
    std::string text = scenario.text();
    text.replace(text.find("height_m=\"300\""), 14, "height_m=\"-900\"");
    write_file(folder.folder() / "low.xml", text);
    const auto result = run_nadir("validate " + (folder.folder() / "low.xml").string());
    CHECK(result.exit_code == 2);
    CHECK(result.err.find("low.xml:5:13: error: ") != std::string::npos);
    CHECK(result.err.find("-900") != std::string::npos);
  }
  SECTION("a camera inside the ground") {
    scenario.geometry = R"(<plane material="grey" size_x_m="200" size_y_m="200" up_m="60"/>)";
    CHECK(said("<layered/>") == "tiny.xml:11:1: error: the camera lies inside the ground");
  }
  SECTION("a camera below the site") {
    std::string text = scenario.text();
    text.replace(text.find("up_m=\"50\""), 9, "up_m=\"-5\"");
    write_file(folder.folder() / "low.xml", text);
    const auto result = run_nadir("validate " + (folder.folder() / "low.xml").string());
    CHECK(result.exit_code == 2);
    CHECK(result.err.find("low.xml:11:1: error: the camera lies 5.0 m below the height of the "
                          "site, which is that of the ground under the air") != std::string::npos);
    CHECK(result.err.find("hint: set the site's height to the lowest ground of the scene") !=
          std::string::npos);
  }
  SECTION("a ground whose spectrum ends before the band") {
    write_file(folder.folder() / "g.csv", "wavelength_um,r\n0.3,0.1\n0.5,0.2\n");
    CHECK(said(R"(<layered ground_reflectance="g.csv"/>)")
              .find("tiny.xml:5:13: error: the reflectance of the ground about") == 0);
  }
  SECTION("a table that is none") {
    write_file(folder.folder() / "day.air", "wavelength_um,r\n0.3,0.1\n");
    CHECK(said(R"(<table file="day.air"/>)").find("day.air: error: this is no table of the air") ==
          0);
  }
}

/// A scenario that tells ranges and the sun's elevation; parts replaced as a test wants.
std::string with_truth(const TinyScenario& scenario,
                       const std::vector<std::pair<std::string, std::string>>& changes) {
  std::string text = scenario.text();
  const auto replace = [&](const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    text.replace(at, from.size(), to);
  };
  replace("truth=\"false\"", "truth=\"true\"");
  for (const auto& [from, to] : changes) replace(from, to);
  return text;
}

/// Of the only pixel: plane 0 is the range, 2 the sun's elevation.
double truth(const AirFolder& folder, std::size_t plane) {
  const auto image = sim::read_envi(folder.folder() / "out" / "a_truth.img");
  return static_cast<double>(
      std::get<std::vector<std::vector<float>>>(image.planes).at(plane).front());
}

TEST_CASE("low rays bend down where the scenario asks for it", "[end_to_end][air]") {
  const AirFolder folder;
  TinyScenario scenario = day();
  scenario.geometry = R"(<plane material="grey" size_x_m="2000" size_y_m="40000"/>)";
  const std::vector<std::pair<std::string, std::string>> level = {
      {"pitch_deg=\"-90\"", "pitch_deg=\"-0.3\""}};
  const AirRun straight = run_air(folder, with_truth(scenario, level));
  CHECK(straight.says("\"from_cache\": false"));
  CHECK_FALSE(straight.says("rays_bend"));
  const double sine = std::sin(0.3 * std::numbers::pi / 180.0);
  CHECK(truth(folder, 0) == Approx(50.0 / sine).epsilon(1e-3));  // the pixel is 1 cm high

  scenario.atmosphere = R"(<layered mode="fast" refraction="true"/>)";
  const AirRun bent = run_air(folder, with_truth(scenario, level));
  CHECK(bent.says("\"from_cache\": true"));     // the light of the air is that of straight rays
  CHECK(bent.says("straight lines of sight"));  // a warning: files with geometry hold those
  CHECK(bent.says("\"rays_bend\": true"));
  // The ray's curvature is -dn/dh = (n - 1) / 10.3 km with n - 1 = 2.69e-4 at 325 m (density falls
  // with 10.3 km in the lowest layer of the standard atmosphere): it meets the plane where
  // 50 = L sin 0.3 + L^2 curvature / 2. The curvature to 5 %: the range to 0.15 %.
  const double curvature = 2.69e-4 / 10.3e3;
  const double range = (std::sqrt(sine * sine + 2.0 * 50.0 * curvature) - sine) / curvature;
  CHECK(truth(folder, 0) == Approx(range).epsilon(3e-3));
}

TEST_CASE("refraction that nobody would see costs nothing", "[end_to_end][air]") {
  const AirFolder folder;
  TinyScenario scenario = day();
  const AirRun without = run_air(folder, scenario.text());
  scenario.atmosphere = R"(<layered mode="fast" refraction="true"/>)";
  const AirRun with = run_air(folder, scenario.text());
  CHECK(with.says("\"rays_bend\": false"));
  CHECK_FALSE(with.says("straight lines of sight"));
  CHECK((with.planes == without.planes));
}

TEST_CASE("refraction lifts the sun of the ephemeris", "[end_to_end][air]") {
  const AirFolder folder;
  TinyScenario scenario = day();
  const std::vector<std::pair<std::string, std::string>> evening = {
      {"2026-06-21T16:00:00Z", "2026-06-22T00:10:00Z"},
      {"<fixed>" + noon + "</fixed>", "<ephemeris lunar_irradiance=\"0\"/>"}};
  run_air(folder, with_truth(scenario, evening));
  const double geometric = truth(folder, 2);
  scenario.atmosphere = R"(<layered mode="fast" refraction="true"/>)";
  run_air(folder, with_truth(scenario, evening));
  const double apparent = truth(folder, 2);
  CAPTURE(geometric, apparent);
  REQUIRE(geometric > 3.0);
  REQUIRE(geometric < 12.0);
  // Bennett's formula (J. Navigation 35, 255, 1982) at 0.96 of sea level's pressure, to 0.1'.
  const double degree = std::numbers::pi / 180.0;
  const double lifted =
      1.0 / std::tan((apparent + 7.31 / (apparent + 4.4)) * degree) / 60.0 * 978.0 / 1010.0;
  CHECK(apparent - geometric == Approx(lifted).margin(0.1 / 60.0 + 0.002));
}

}  // namespace nadir::end_to_end
