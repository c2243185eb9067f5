#include "sensor/orbit/sgp4.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "support/catch.hpp"

namespace nadir::sensor {
namespace {

using Catch::Matchers::Contains;

struct Moment {
  double minutes = 0.0;
  StateVector teme_km;
};
struct Case {
  TwoLineElements elements;
  std::vector<Moment> states;
  std::vector<double> errors;  // minutes for which there is no state
};

std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> values;
  const char* const end = line.data() + line.size();
  for (const char* at = line.data() + line.find(',') + 1; at < end;) {
    double value = 0.0;
    at = std::from_chars(at, end, value).ptr + 1;
    values.push_back(value);
  }
  return values;
}

TwoLineElements elements_of(const std::vector<double>& v) {
  TwoLineElements set;
  set.catalogue_number = static_cast<int>(v.at(0));
  set.epoch_year = static_cast<int>(v.at(1));
  set.epoch_day = v.at(2);
  set.drag_term = v.at(3);
  set.inclination_deg = v.at(4);
  set.ascending_node_deg = v.at(5);
  set.eccentricity = v.at(6);
  set.argument_of_perigee_deg = v.at(7);
  set.mean_anomaly_deg = v.at(8);
  set.mean_motion_rev_day = v.at(9);
  return set;
}

std::vector<Case> read_cases() {
  std::ifstream file{NADIR_SOURCE_DIR "/tests/sensor/data/sgp4_verification.csv"};
  std::vector<Case> cases;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::vector<double> v = numbers_of(line);
    if (line.rfind("orbit", 0) == 0) {
      cases.push_back({elements_of(v), {}, {}});
    } else if (line.rfind("error", 0) == 0) {
      cases.back().errors.push_back(v.at(0));
    } else {
      cases.back().states.push_back(
          {v.at(0), {{v.at(1), v.at(2), v.at(3)}, {v.at(4), v.at(5), v.at(6)}}});
    }
  }
  return cases;
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all = read_cases();
  return all;
}

const Case& case_of(int catalogue_number) {
  for (const Case& one : cases()) {
    if (one.elements.catalogue_number == catalogue_number) return one;
  }
  throw std::out_of_range{"no such orbit"};
}

}  // namespace

TEST_CASE("the verification set has all its orbits", "[sensor][sgp4]") {
  std::size_t states = 0, errors = 0;
  for (const Case& one : cases()) {
    states += one.states.size();
    errors += one.errors.size();
  }
  CHECK(cases().size() == 33);
  CHECK(states == 666);
  CHECK(errors == 1);
}

// Printed to 1e-8 km and 1e-9 km/s. Measured: 3e-7 km for 20413 three and a half years from its
// epoch, 8.1e-8 km at most else; 8.6e-10 km/s, all of it rounding of the print. The other way of
// Lyddane's quadrants (the one of AFSPC's programs) would put 23599 off by 1 km.
TEST_CASE("every state of the verification set is met", "[sensor][sgp4]") {
  for (const Case& one : cases()) {
    const Sgp4 orbit{one.elements};
    for (const Moment& moment : one.states) {
      CAPTURE(one.elements.catalogue_number, moment.minutes);
      const StateVector found = orbit.teme_km(moment.minutes);
      CHECK(length(found.position - moment.teme_km.position) < 1e-6);
      CHECK(length(found.velocity - moment.teme_km.velocity) < 1e-9);
    }
  }
}

// The set has no orbit between 1.2 and 3 degrees, where sun and moon leave the node's mean drift
// alone. Value: python-sgp4 2.15 (Debian), WGS-72, "improved" mode.
TEST_CASE("near the equator's plane the node does not drift by sun and moon", "[sensor][sgp4]") {
  TwoLineElements set = case_of(24208).elements;
  set.inclination_deg = 2.0;
  const StateVector found = Sgp4{set}.teme_km(14400.0);
  CHECK(length(found.position - Vec3{-12806.284031576744, 39989.66574967734, 709.1784774985555}) <
        1e-6);
  CHECK(length(found.velocity -
               Vec3{-2.935503246923781, -0.9334424719118943, 0.09638296952527259}) < 1e-9);
}

// The messages that the source's own program has for these orbits: codes 3, 1, 6 and 4.
TEST_CASE("where there is no state SGP4 says why", "[sensor][sgp4]") {
  for (const Case& one : cases()) {
    const Sgp4 orbit{one.elements};
    for (const double minutes : one.errors) {
      CHECK(one.elements.catalogue_number == 33334);
      CHECK_THROWS_AS(orbit.teme_km(minutes), PropagationError);
      CHECK_THROWS_WITH(
          orbit.teme_km(minutes),
          Contains("SGP4: the perturbed eccentricity is -122.2171") && Contains("outside 0 to 1"));
    }
  }
  CHECK_THROWS_WITH(Sgp4{case_of(22312).elements}.teme_km(494.2028672),
                    Contains("the mean eccentricity is -0.00132"));
  CHECK_THROWS_WITH(Sgp4{case_of(28872).elements}.teme_km(55.0), Contains("has decayed"));
  CHECK_THROWS_WITH(Sgp4{case_of(29141).elements}.teme_km(440.0), Contains("has decayed"));
  CHECK_THROWS_WITH(Sgp4{case_of(33333).elements}.teme_km(25.0),
                    Contains("the semi-latus rectum is negative"));
}

TEST_CASE("elements that describe no orbit are refused", "[sensor][sgp4]") {
  TwoLineElements wrong = case_of(5).elements;
  wrong.mean_motion_rev_day = 0.0;
  CHECK_THROWS_WITH(Sgp4{wrong}, Contains("the mean motion is 0 revolutions a day"));
  wrong = case_of(5).elements;
  wrong.eccentricity = 1.0;
  CHECK_THROWS_WITH(Sgp4{wrong}, Contains("the eccentricity is 1; it must lie in [0, 1)"));
  wrong = case_of(5).elements;
  wrong.epoch_year = 2001;
  wrong.epoch_day = 366.5;
  CHECK_THROWS_WITH(Sgp4{wrong}, Contains("day 366.5 is not one of the year 2001"));
}

TEST_CASE("the epoch is a moment of UTC", "[sensor][sgp4]") {
  TwoLineElements set = case_of(5).elements;
  CHECK(Sgp4{set}.epoch().to_string().substr(0, 23) == "2000-06-27T18:50:19.733");
  set.epoch_year = 2016;
  set.epoch_day = 366.5;
  CHECK(Sgp4{set}.epoch().to_string() == "2016-12-31T12:00:00Z");
  set.epoch_day = 1.0;
  CHECK(Sgp4{set}.epoch().to_string() == "2016-01-01T00:00:00Z");
}

// SGP4's velocity is not the exact derivative of its position: it leaves out how the mean elements
// drift and the long-period terms change. Measured: 1.2e-3 km/s for 5, 5.5e-4 or less for the
// others. The differences' own error over a second is below 1e-6.
TEST_CASE("velocity is nearly the position's change", "[sensor][sgp4]") {
  for (const int number : {5, 6251, 28057, 9880, 24208, 8195}) {
    CAPTURE(number);
    const Sgp4 orbit{case_of(number).elements};
    for (const double minutes : {0.0, 77.0, 600.0}) {
      constexpr double h = 1.0 / 60.0;
      const Vec3 change =
          (orbit.teme_km(minutes + h).position - orbit.teme_km(minutes - h).position) /
          (2.0 * 60.0 * h);
      CHECK(length(change - orbit.teme_km(minutes).velocity) < 2e-3);
    }
  }
}

TEST_CASE("a state in earth-fixed axes is that in TEME turned", "[sensor][sgp4]") {
  const Sgp4 orbit{case_of(6251).elements};
  const ephemeris::Instant at = orbit.epoch() + Seconds{120.0 * 60.0};
  const StateVector ecef = orbit_state(orbit, at), teme = teme_from_ecef(ecef, at);
  CHECK(length(teme.position / 1e3 - orbit.teme_km(120.0).position) < 1e-8);
  CHECK(length(teme.velocity / 1e3 - orbit.teme_km(120.0).velocity) < 1e-11);
}

}  // namespace nadir::sensor
