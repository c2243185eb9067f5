#include "ephemeris/refraction.hpp"

#include <cmath>

#include "support/catch.hpp"

namespace {

using namespace nadir;
using namespace nadir::ephemeris;

double arcminutes(double elevation_deg, const AirAtSite& air = {}) {
  return to_degrees(refraction(degrees(elevation_deg), air)) * 60.0;
}

}  // namespace

// The almanacs' 34': a body whose geometric elevation is -34' appears on the horizon. The formula
// gives 33.8' there.
TEST_CASE("the horizon is lifted by 34 arcminutes", "[ephemeris][refraction]") {
  CHECK(arcminutes(-34.0 / 60.0) == Approx(34.0).epsilon(0).margin(0.5));
}

// Meeus, Astronomical Algorithms, example 16.a: the sun's lower limb appears at 30'; its true
// elevation is 1.20' by Bennett's formula, 28.754' of refraction. Saemundsson's formula is its
// inverse to 0.1' (Meeus, chapter 16).
TEST_CASE("refraction at 30 arcminutes is that of Meeus' example", "[ephemeris][refraction]") {
  CHECK(arcminutes(1.246 / 60.0) == Approx(28.754).epsilon(0).margin(0.1));
}

// High up any air refracts (n - 1) tan z: n - 1 = 2.83e-4 at 1010 hPa and 10 C gives 58.3". The
// formula's own error there is 3".
TEST_CASE("refraction at 45 degrees is that of the refractive index", "[ephemeris][refraction]") {
  CHECK(arcminutes(45.0) * 60.0 == Approx(58.3).epsilon(0).margin(4.0));
}

TEST_CASE("refraction vanishes in the zenith and far below the horizon",
          "[ephemeris][refraction]") {
  CHECK(arcminutes(90.0) == Approx(0.0).margin(1e-5));
  CHECK(arcminutes(-2.0) == 0.0);
  CHECK(arcminutes(-45.0) == 0.0);
  CHECK(arcminutes(-90.0) == 0.0);
}

TEST_CASE("refraction is continuous and falls with elevation", "[ephemeris][refraction]") {
  constexpr double step_deg = 0.01;
  double previous = arcminutes(-3.0);
  for (double h_deg = -3.0 + step_deg; h_deg < 90.0; h_deg += step_deg) {
    const double here = arcminutes(h_deg);
    CAPTURE(h_deg);
    // steepest on the fade: 38.8' in one degree
    REQUIRE(std::abs(here - previous) < 40.0 * step_deg);
    if (h_deg > -1.0 + step_deg) REQUIRE(here <= previous);
    // a higher body appears higher
    REQUIRE(here / 60.0 + step_deg > previous / 60.0);
    REQUIRE(here >= 0.0);
    previous = here;
  }
}

TEST_CASE("refraction follows the density of the air", "[ephemeris][refraction]") {
  CHECK(arcminutes(10.0, {0.0, 10.0}) == 0.0);
  CHECK(arcminutes(10.0, {505.0, 10.0}) == Approx(arcminutes(10.0) / 2.0).epsilon(1e-12));
  CHECK(arcminutes(10.0, {1010.0, 293.0}) == Approx(arcminutes(10.0) / 2.0).epsilon(1e-12));
}
