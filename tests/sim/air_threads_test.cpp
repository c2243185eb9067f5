// A table of the air does not depend on how many threads made it.
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <cstddef>
#include <string>

#include "sim/files/air_table_file.hpp"
#include "sim/lowtran_air.hpp"
#include "support/catch.hpp"

namespace nadir::sim::test {
namespace {

using namespace atmosphere;

/// The bytes of a table of sun and moon in the visible and of a window in the infrared.
std::string table_by(std::size_t threads) {
  using tbb_control = oneapi::tbb::global_control;
  const tbb_control limit{tbb_control::max_allowed_parallelism, threads};
  Layered air = lowtran_air("midlatitude_summer", AerosolType::rural);
  air.clouds = {{"cirrus", 8000.0, 9000.0, 0.3}};
  air.night.airglow = spectral::Curve::constant(1e-6);
  AirSettings settings;
  settings.streams = 4;
  settings.zenith_nodes = 5;
  settings.azimuth_nodes = 4;
  settings.share_nodes = 4;
  settings.observer_height_m = 3000.0;
  const std::vector<Micrometres> wavelengths{Micrometres{0.55}, Micrometres{0.94},
                                             Micrometres{10.5}};
  const std::vector<spectral::AbsorptionLane> intervals{
      {0.54, 0.56, 0}, {0.93, 0.95, 0}, {10.3, 10.7, 0}};
  const auto light = spectral::Curve::constant(1000.0);
  const ephemeris::Illumination bodies{{"sun", {0.0, 0.8, 0.6}, Angle{0.00465}, light},
                                       {"moon", {0.6, 0.0, 0.8}, Angle{0.0045}, light}};
  const auto lanes = split_lanes(air, settings, wavelengths, intervals);
  REQUIRE(lanes.size() > 12);  // more than threads
  return air_table_bytes({make_air_table(air, settings, lanes, wavelengths, bodies), ""});
}

}  // namespace

TEST_CASE("A table is the same to the last bit by one, two and seven threads", "[sim][air]") {
  const std::string one = table_by(1);
  CHECK(one.size() > 10'000);
  CHECK((table_by(2) == one));
  CHECK((table_by(7) == one));
}

}  // namespace nadir::sim::test
