#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "core/error.hpp"
#include "scenario_support.hpp"
#include "sim/run/air_stage.hpp"
#include "sim/run/air_stage_check.hpp"
#include "support/catch.hpp"

// From the scenario's words to the air that is solved, and the lanes at which it is.

namespace nadir::test {
namespace {

using spectral::BoxResponse;

sim::Scenario with_air(const std::string& air) {
  Diagnostics diagnostics;
  return sim::parse_scenario(replaced(minimal_text(), "<none/>", air), data_folder() / "test.xml",
                             diagnostics);
}

sim::LayeredTask task_of(const std::string& air) {
  Diagnostics diagnostics;
  sim::InputFiles files;
  return *sim::load_air_task(with_air(air), files, diagnostics)->layered;
}

sensor::DetectorArray array_of(const std::vector<std::pair<double, double>>& boxes) {
  sensor::DetectorArray array;
  for (const auto& [lo, hi] : boxes) {
    array.bands.push_back({"b", BoxResponse{Micrometres{lo}, Micrometres{hi}}});
  }
  return array;
}

sim::CameraPlan plan_of(const std::vector<sensor::DetectorArray>& arrays, int wavelengths = 3) {
  const sim::LayeredTask task = task_of("<layered/>");
  return sim::plan_camera(arrays, wavelengths, task.air, task.settings);
}

}  // namespace

TEST_CASE("the lanes of each band weigh 1 together, and each node what it did", "[sim][air]") {
  const auto plan = plan_of({array_of({{0.55, 0.57}, {0.75, 0.78}, {8.0, 12.0}})});
  REQUIRE(plan.arrays.size() == 1);
  const sim::ArrayPlan& array = plan.arrays[0];
  for (std::size_t band = 0; band < 3; ++band) {
    double sum = 0.0;
    std::vector<double> by_node(3, 0.0);
    for (const auto& term : array.lanes.bands[band]) {
      const spectral::Lanes& lanes = array.lanes.blocks[static_cast<std::size_t>(term.block)];
      const auto& nodes = array.quadratures[band].wavelengths;
      const auto node = std::find(nodes.begin(), nodes.end(), lanes[term.lane]);
      REQUIRE(node != nodes.end());
      CHECK(term.weight > 0.0);
      by_node[static_cast<std::size_t>(node - nodes.begin())] += term.weight;
      sum += term.weight;
      // A lane's interval holds its wavelength and lies in the band.
      const auto interval = lanes.absorption(term.lane);
      CHECK(interval.lo_um < lanes[term.lane].value);
      CHECK(interval.hi_um > lanes[term.lane].value);
    }
    CHECK(sum == Approx(1.0).epsilon(1e-12));
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(by_node[i] == Approx(array.quadratures[band].weights[i]).epsilon(1e-12));
    }
  }
  // The window at 8 to 12 um, with ozone's band in it, needs more terms than green light.
  CHECK(array.lanes.bands[2].size() > array.lanes.bands[0].size());
}

TEST_CASE("what arrays have in common is solved once, like wavelengths of others are not",
          "[sim][air]") {
  const auto one = plan_of({array_of({{0.5, 0.6}})});
  const auto twice = plan_of({array_of({{0.5, 0.6}}), array_of({{0.5, 0.6}})});
  CHECK(twice.air.lanes.size() == one.air.lanes.size());
  CHECK(twice.arrays[1].lanes.blocks[0].count() == one.arrays[0].lanes.blocks[0].count());
  // The middle node of either band lies at 0.55 um, but stands for another interval.
  const auto nested = plan_of({array_of({{0.5, 0.6}, {0.54, 0.56}})});
  CHECK(nested.air.wavelengths.size() == 6);
}

TEST_CASE("every lane of an array is one of the air's", "[sim][air]") {
  const auto plan = plan_of({array_of({{0.45, 0.5}, {0.9, 1.0}}), array_of({{3.0, 5.0}})});
  std::set<std::pair<double, spectral::AbsorptionLane>> known;
  for (const auto& lane : plan.air.lanes) {
    const auto source = static_cast<std::size_t>(lane.source);
    CHECK(known.emplace(plan.air.wavelengths[source].value, lane.absorption).second);
  }
  std::size_t found = 0;
  for (const sim::ArrayPlan& array : plan.arrays) {
    for (const spectral::Lanes& lanes : array.lanes.blocks) {
      for (int i = 0; i < lanes.count(); ++i, ++found) {
        CHECK(known.contains({lanes[i].value, lanes.absorption(i)}));
      }
    }
  }
  CHECK(found == known.size());
}

TEST_CASE("a table of other bands is refused, one of plain wavelengths needs no split",
          "[sim][air]") {
  atmosphere::AirTable table;
  table.lanes = {{0.5, {}, 1.0}, {0.6, {}, 1.0}};
  const std::vector<sensor::DetectorArray> arrays{array_of({{0.5, 0.6}})};
  CHECK(sim::plan_camera(arrays, 1, table).arrays[0].lanes.blocks[0].count() == 1);
  const double node = sim::plan_camera(arrays, 1).arrays[0].quadratures[0].wavelengths[0].value;
  table.lanes = {{node, {0.5, 0.6, 0}, 0.75}, {node, {0.5, 0.6, 1}, 0.25}};
  const auto plan = sim::plan_camera(arrays, 1, table);
  REQUIRE(plan.arrays[0].lanes.bands[0].size() == 2);
  CHECK(plan.arrays[0].lanes.bands[0][0].weight == 0.75);
  table.lanes = {{node, {0.5, 0.61, 0}, 1.0}};
  CHECK_THROWS_WITH(sim::plan_camera(arrays, 1, table),
                    "error: the table of the air was made for other bands: it has no lanes for "
                    "0.55 um\n");
}

TEST_CASE("figures of the air are opened for layered air alone", "[sim][air]") {
  const auto opened = [](const std::string& air) {
    Diagnostics diagnostics;
    sim::InputFiles files;
    const auto scenario = with_air(air);
    static_cast<void>(sim::load_atmosphere(scenario, files));
    static_cast<void>(sim::load_air_task(scenario, files, diagnostics));
    return files.all().size();
  };
  CHECK(opened("<none/>") == 0);
  CHECK(opened("<uniform sky_radiance=\"10\"/>") == 0);
  CHECK(opened("<layered night_sky=\"false\"/>") ==
        5);                          // gases, continua, sets, profiles, particles
  CHECK(opened("<layered/>") == 7);  // airglow and starlight
}

TEST_CASE("amounts of gas follow the scenario", "[sim][air]") {
  const double above_m = 300.0;  // the site
  const auto water = [&](const std::string& attributes) {
    return water_column(task_of("<layered " + attributes + "/>").air.profile, above_m);
  };
  const double standard = water("");
  CHECK(standard > 1.0);
  CHECK(standard < 1.42);  // the standard profile's from sea level
  CHECK(water("water_vapour_factor=\"0.5\"") == Approx(0.5 * standard).epsilon(1e-9));
  CHECK(water("water_vapour_g_cm2=\"0.7\"") == Approx(0.7).epsilon(1e-6));
  CHECK(ozone_column(task_of("<layered ozone_du=\"250\"/>").air.profile, above_m) ==
        Approx(250.0).epsilon(1e-6));
  CHECK(task_of("<layered co2_ppm=\"800\"/>").air.profile.levels[0].mixing(atmosphere::Gas::co2) ==
        Approx(800.0).epsilon(1e-3));
}

TEST_CASE("more vapour than the air can hold is told of", "[sim][air]") {
  Diagnostics diagnostics;
  sim::InputFiles files;
  static_cast<void>(
      sim::load_air_task(with_air("<layered water_vapour_g_cm2=\"8\"/>"), files, diagnostics));
  REQUIRE(diagnostics.messages().size() == 1);
  CHECK(diagnostics.messages()[0].find("relative humidity of 100 % and the column ") !=
        std::string::npos);
}

TEST_CASE("whatever the table depends on changes its key", "[sim][air]") {
  const auto plan = plan_of({array_of({{0.5, 0.6}})}, 1);
  const auto key = [&](const sim::LayeredTask& task, double irradiance = 1.0,
                       const std::string& figures = "f") {
    const ephemeris::Illumination bodies{
        {"sun", {0.0, 0.6, 0.8}, degrees(0.27), spectral::Curve::constant(irradiance)}};
    return sim::air_key(task.air, task.settings, plan.air, bodies, figures);
  };
  std::set<std::string> keys;
  std::size_t made = 0;
  const auto differs = [&](const std::string& text) { return keys.insert(text).second && ++made; };
  for (const char* air :
       {"<layered/>", "<layered profile=\"tropical\"/>", "<layered mode=\"fast\"/>",
        "<layered streams=\"16\"/>", "<layered ozone_factor=\"1.001\"/>",
        "<layered co2_ppm=\"421\"/>", "<layered night_sky=\"false\"/>",
        "<layered><aerosol visibility_km=\"22\"/></layered>",
        "<layered><aerosol type=\"urban\"/></layered>",
        "<layered><aerosol volcanic=\"high\"/></layered>",
        "<layered><aerosol season=\"autumn_winter\"/></layered>",
        "<layered><aerosol relative_humidity_percent=\"71\"/></layered>",
        "<layered><urban_glow radiance=\"1e-6\"/></layered>",
        "<layered><cloud type=\"stratus\" base_m=\"500\" top_m=\"900\" optical_depth_550=\"9\"/>"
        "</layered>"}) {
    CAPTURE(air);
    CHECK(differs(key(task_of(air))));
  }
  sim::LayeredTask task = task_of("<layered/>");
  CHECK(differs(key(task, 1.001)));
  CHECK(differs(key(task, 1.0, "g")));
  task.settings.observer_height_m = 1.0;
  CHECK(differs(key(task)));
  task.air.ground_height_m += 1e-9;
  CHECK(differs(key(task)));
  // The ground about and refraction are not in the table.
  CHECK_FALSE(differs(key(task_of("<layered ground_reflectance=\"0.9\" refraction=\"true\"/>"))));
  CHECK(made == keys.size());
}

TEST_CASE("heights above the sea follow the round earth", "[sim][air]") {
  CHECK(sim::height_above_sea_m({0.0, 0.0, 1200.0}, 300.0) == Approx(1500.0).epsilon(1e-12));
  // 10 km away on the tangent plane: d^2 / 2 R = 7.848 m.
  CHECK(sim::height_above_sea_m({6000.0, 8000.0, 0.0}, 0.0) == Approx(7.848).epsilon(1e-4));
  const double radius = 6371008.8;
  CHECK(sim::height_above_sea_m({radius, 0.0, 0.0}, 0.0) ==
        Approx((std::sqrt(2.0) - 1.0) * radius).epsilon(1e-12));
}

}  // namespace nadir::test
