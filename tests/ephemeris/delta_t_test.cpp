#include "ephemeris/delta_t.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::ephemeris;

// Observed values: Espenak and Meeus 2006, table 2-1 and 2-2, to a tenth of a second from 1955.
// The polynomials are within 0.5 s of the table, the accuracy that the header states.
TEST_CASE("Delta T is near its observed values", "[ephemeris][delta_t]") {
  CHECK(delta_t(1900.0).value == Approx(-2.7).margin(0.5));
  CHECK(delta_t(1950.0).value == Approx(29.1).margin(0.5));
  CHECK(delta_t(1955.0).value == Approx(31.1).margin(0.5));
  CHECK(delta_t(1960.0).value == Approx(33.2).margin(0.5));
}

// The pieces were fitted apart; they meet within a few tenths of a second.
TEST_CASE("the pieces of Delta T meet", "[ephemeris][delta_t]") {
  const double year = GENERATE(1920.0, 1941.0);
  CHECK(delta_t(year - 1e-9).value == Approx(delta_t(year).value).epsilon(0).margin(0.3));
}

TEST_CASE("Delta T meets the first UTC", "[ephemeris][delta_t]") {
  // TT - UTC on 1960-01-01 was 32.184 s + 0.943482 s, and UTC then kept within 0.05 s of UT1
  CHECK(delta_t(1960.0).value == Approx(33.127482).epsilon(0).margin(0.1));
}

TEST_CASE("Delta T is not known outside its years", "[ephemeris][delta_t]") {
  CHECK(std::isnan(delta_t(1899.99).value));
  CHECK(std::isnan(delta_t(1961.0).value));
  CHECK(std::isnan(delta_t(std::nan("")).value));
}
