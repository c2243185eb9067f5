#include <cmath>
#include <numbers>
#include <string>

#include "end_to_end/tiny_scenario.hpp"
#include "spectral/planck.hpp"
#include "support/catch.hpp"

// Whole runs of the `nadir` command whose radiance has a closed form.

namespace nadir::end_to_end {
namespace {

constexpr double pi = std::numbers::pi;

// Radiance is written as float (6e-8), the sun is a disc of 0.27 degrees whose mean cosine is
// 1 - 1e-5, and directions go through float: 1e-4 has margin.
constexpr double exact = 1e-4;

TEST_CASE("open ground under sun and sky is what both solvers say", "[end_to_end]") {
  TinyScenario scenario;
  scenario.bodies = R"(<body name="sun" azimuth_deg="120" elevation_deg="30" irradiance="1000"/>)";
  scenario.atmosphere = R"(<uniform sky_radiance="40" solar_transmittance="0.8"/>)";
  scenario.samples = 16;
  // rho (E sin(elevation) / pi + L_sky)
  const double expected = 0.5 * (1000.0 * 0.8 * 0.5 / pi + 40.0);
  for (const std::string& solver : {std::string{}, path_method}) {
    scenario.solver = solver;
    const TinyRun run = run_tiny(scenario);
    CAPTURE(solver, run.mean_error());
    CHECK(run.mean_radiance() == Approx(expected).epsilon(exact).margin(4.0 * run.mean_error()));
  }
}

TEST_CASE("generic and path solver agree at the foot of a wall", "[end_to_end]") {
  TinyScenario scenario;
  scenario.bodies = R"(<body name="sun" azimuth_deg="90" elevation_deg="40" irradiance="1000"/>)";
  scenario.atmosphere = R"(<uniform sky_radiance="60"/>)";
  scenario.geometry += R"(<box material="grey" lo_m="-3 -20 0" hi_m="-2 20 10"/>)";
  scenario.array = R"(samples="4" lines="4" ground_pitch_m="0.9")";
  scenario.samples = 24;
  // Light that ground and wall throw to each other more than eight times is below 1e-4 of all.
  scenario.solver = R"(<solver initial_sample_count="12" sample_decay_rate="3" max_bounces="8"/>)";
  const TinyRun generic = run_tiny(scenario);
  scenario.solver = path_method;
  const TinyRun path = run_tiny(scenario);
  const double sigma = std::hypot(generic.mean_error(), path.mean_error());
  CAPTURE(generic.mean_radiance(), path.mean_radiance(), sigma);
  CHECK(std::abs(generic.mean_radiance() - path.mean_radiance()) < 4.0 * sigma);
  // what the wall adds is far more than the errors, so that they agree on something
  CHECK(sigma < 0.01 * path.mean_radiance());
  CHECK(generic.report.find("\"solver\": \"generic\"") != std::string::npos);
  CHECK(path.report.find("\"solver\": \"path\"") != std::string::npos);
  CHECK(generic.counter("full_samples") > 0.0);
  CHECK(generic.counter("path_rays") == 0.0);
  CHECK(path.counter("path_rays") > 0.0);
  CHECK(path.counter("full_samples") == 0.0);
}

TEST_CASE("a point lamp lights the ground by the inverse square and the cosine", "[end_to_end]") {
  TinyScenario scenario;
  scenario.extra = R"(<lamps><point_lamp up_m="4" flux_w_per_um="1000"/></lamps>)";
  for (const std::string& solver : {std::string{}, path_method}) {
    for (const double aside : {0.0, 3.0}) {
      scenario.solver = solver;
      scenario.array = R"(samples="1" lines="1" ground_pitch_m="1e-4" offset_x_m=")" +
                       std::to_string(aside) + "\"";
      const TinyRun run = run_tiny(scenario);
      // E = Phi / (4 pi) h / (h^2 + r^2)^(3/2)
      const double e = 1000.0 / (4.0 * pi) * 4.0 / std::pow(16.0 + aside * aside, 1.5);
      CAPTURE(solver, aside);
      CHECK(run.mean_radiance() == Approx(0.5 / pi * e).epsilon(exact));
      CHECK(run.counter("lamp_rays") > 0.0);
    }
  }
}

TEST_CASE("a clear absorbing slab takes its Beer-Lambert share on both ways", "[end_to_end]") {
  TinyScenario scenario;
  scenario.bodies = sun_overhead;
  scenario.extra = R"(<volumes><volume name="slab" absorption_per_m="0.2">)"
                   R"(<box lo_m="-50 -50 2" hi_m="50 50 7"/></volume></volumes>)";
  for (const std::string& solver : {std::string{}, path_method}) {
    scenario.solver = solver;
    CAPTURE(solver);
    CHECK(run_tiny(scenario).mean_radiance() ==
          Approx(0.5 / pi * 1000.0 * std::exp(-2.0 * 0.2 * 5.0)).epsilon(exact));
  }
}

TEST_CASE("a warm slab over cold ground shines with one minus its transmittance", "[end_to_end]") {
  TinyScenario scenario;
  scenario.materials = R"(<material name="grey" reflectance="0" temperature_k="0"/>)";
  scenario.band = R"(<band_box name="b" lo_um="9.999" hi_um="10.001"/>)";
  scenario.extra = R"(<volumes><volume name="slab" absorption_per_m="0.2" temperature_k="400">)"
                   R"(<box lo_m="-50 -50 2" hi_m="50 50 7"/></volume></volumes>)";
  scenario.samples = 256;
  const double expected =
      (1.0 - std::exp(-0.2 * 5.0)) * spectral::planck(Micrometres{10.0}, Kelvin{400.0}).value;
  for (const std::string& solver : {std::string{}, path_method}) {
    scenario.solver = solver;
    const TinyRun run = run_tiny(scenario);
    CAPTURE(solver, run.mean_error());
    CHECK(run.mean_radiance() == Approx(expected).epsilon(exact).margin(4.0 * run.mean_error()));
    CHECK(run.mean_error() < 0.02 * expected);
  }
}

TEST_CASE("a map of materials gives each pixel the material of its value", "[end_to_end]") {
  const sim::support::ScratchFolder folder;
  write_file(folder / "map.asc",
             "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n2 3\n");
  TinyScenario scenario;
  scenario.bodies = sun_overhead;
  scenario.materials = R"(<material name="dark" reflectance="0.1"/>
<material name="middle" reflectance="0.3"/><material name="bright" reflectance="0.8"/>
<material_map name="map" raster="map.asc" west_m="-1" south_m="-1" east_m="1" north_m="1">
<choice value="1" material="dark"/><choice value="2" material="middle"/>
<choice value="3" material="bright"/></material_map>)";
  scenario.geometry = R"(<plane material="map" size_x_m="20" size_y_m="20"/>)";
  scenario.array = R"(samples="2" lines="2" ground_pitch_m="1")";
  const TinyRun run = run_tiny(folder, scenario);
  REQUIRE(run.radiance.size() == 4);
  const double expected[] = {0.1, 0.3, 0.3, 0.8};  // rows from north to south
  for (std::size_t i = 0; i < 4; ++i) {
    CAPTURE(i);
    CHECK(run.radiance[i] == Approx(expected[i] / pi * 1000.0).epsilon(exact));
  }
}

TEST_CASE("a mixture reflects the weighted sum of its parts", "[end_to_end]") {
  TinyScenario scenario;
  scenario.bodies = sun_overhead;
  scenario.materials = R"(<material name="dark" reflectance="0.1"/>
<material name="bright" reflectance="0.8"/>
<material name="grey"><mixture><part material="dark" weight="0.75"/>)"
                       R"(<part material="bright" weight="0.25"/></mixture></material>)";
  for (const std::string& solver : {std::string{}, path_method}) {
    scenario.solver = solver;
    CAPTURE(solver);
    CHECK(run_tiny(scenario).mean_radiance() ==
          Approx((0.75 * 0.1 + 0.25 * 0.8) / pi * 1000.0).epsilon(exact));
  }
}

/// A symmetric table with its rows at 0, 30 and 60 degrees, so that reciprocity changes nothing.
std::string measured_table() {
  return "# nadir-brdf: 1\n# title: test\n# quantity: brdf\n# zero-azimuth: backward\n"
         "# wavelength: um, vacuum\n# source: made up\n# licence: CC0-1.0\n"
         "incidence_deg,view_deg,relative_azimuth_deg,0.5,0.6\n"
         "0,0,0,0.10,0.20\n0,30,0,0.08,0.16\n0,60,0,0.06,0.12\n"
         "30,0,0,0.08,0.16\n30,30,0,0.09,0.18\n30,30,180,0.07,0.14\n"
         "30,60,0,0.05,0.10\n30,60,180,0.06,0.12\n"
         "60,0,0,0.06,0.12\n60,30,0,0.05,0.10\n60,30,180,0.06,0.12\n"
         "60,60,0,0.07,0.14\n60,60,180,0.09,0.18\n";
}

TEST_CASE("a measured table is met in its own points, between its wavelengths", "[end_to_end]") {
  const sim::support::ScratchFolder folder;
  write_file(folder / "sand.csv", measured_table());
  TinyScenario scenario;
  scenario.materials = R"(<material name="grey"><measured file="sand.csv"/></material>)";
  for (const std::string& solver : {std::string{}, path_method}) {
    scenario.solver = solver;
    // f at 0.55 um is the mean of the two columns: incidence 0 and 30, seen from straight above
    // The sun is made small: the table's slope of 0.7 % a degree would show across its disc.
    scenario.bodies =
        R"(<body name="sun" azimuth_deg="0" elevation_deg="90" irradiance="1000" angular_radius_deg="0.01"/>)";
    CAPTURE(solver);
    CHECK(run_tiny(folder, scenario).mean_radiance() == Approx(0.15 * 1000.0).epsilon(exact));
    scenario.bodies =
        R"(<body name="sun" azimuth_deg="70" elevation_deg="60" irradiance="1000" angular_radius_deg="0.01"/>)";
    CHECK(run_tiny(folder, scenario).mean_radiance() ==
          Approx(0.12 * 1000.0 * std::cos(pi / 6)).epsilon(exact));
  }
}

TEST_CASE("a photometric file shapes the lamp's light", "[end_to_end]") {
  const sim::support::ScratchFolder folder;
  // 100 cd from straight down to the horizon: half of all directions.
  write_file(folder / "half.ies",
             "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 100\n0 90\n0\n100 100\n");
  TinyScenario scenario;
  scenario.solver = path_method;
  scenario.extra = R"(<lamps><point_lamp up_m="4" flux_w_per_um="1000" ies="half.ies"/></lamps>)";
  // Phi / (2 pi) instead of Phi / (4 pi)
  CHECK(run_tiny(folder, scenario).mean_radiance() ==
        Approx(0.5 / pi * 1000.0 / (2.0 * pi) / 16.0).epsilon(exact));
}

}  // namespace
}  // namespace nadir::end_to_end
