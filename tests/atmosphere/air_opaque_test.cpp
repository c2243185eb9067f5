// Air that lets nothing through makes a legal table.
#include <cmath>
#include <memory>
#include <vector>

#include "atmosphere/hand_made_air.hpp"
#include "support/catch.hpp"

namespace nadir::atmosphere::test {
namespace {

/// Five thick layers of water vapour's scale height.
OpticalColumn opaque_column(double absorption) {
  OpticalColumn column;
  column.level_height_m = {100e3, 30e3, 10e3, 4e3, 1e3, 0.0};
  column.level_temperature_k.assign(6, 0.0);
  std::vector<double> molecules;
  for (std::size_t k = 0; k < 5; ++k) {
    const double top = column.level_height_m[k], bottom = column.level_height_m[k + 1];
    molecules.push_back(0.05 * (std::exp(-bottom / 8e3) - std::exp(-top / 8e3)));
    column.absorption.push_back(absorption * (std::exp(-bottom / 2e3) - std::exp(-top / 2e3)));
  }
  column.kinds.push_back(
      {molecules, std::make_shared<const PhaseFunction>(PhaseFunction::rayleigh(0.0))});
  return column;
}

}  // namespace

TEST_CASE("What rounds to less than no light on the ground counts as none", "[atmosphere][air]") {
  // The solver's fluxes carry errors of 1e-16 of what goes in; behind depths of 60 and more that is
  // more than what comes out.
  TableJob job = job_of({}, 0.55);
  job.settings.paths = false;
  job.settings.zenith_nodes = 4;
  job.settings.azimuth_nodes = 3;
  job.bodies = {body_at(50.0, 180.0, 1000.0)};
  for (const int streams : {4, 8}) {
    job.settings.streams = streams;
    for (double absorption = 60.0; absorption < 160.0; absorption += 2.5) {
      job.level_m = opaque_column(absorption).level_height_m;
      job.column = [absorption](std::size_t) { return opaque_column(absorption); };
      AirTable table;
      REQUIRE_NOTHROW(table = filled_table(job));
      CHECK_FALSE(std::signbit(table.bodies[0].ground_irradiance[0]));
      CHECK(table.bodies[0].ground_irradiance[0] < 1e-12F);
    }
  }
}

}  // namespace nadir::atmosphere::test
