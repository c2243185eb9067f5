#include "core/constants.hpp"

#include "core/quantity.hpp"
#include "support/catch.hpp"

using namespace nadir;

// CODATA 2018 prints the first ten digits of these exact but irrational numbers and cuts the rest:
// they lie between the printed number and one unit of its last digit more.
TEST_CASE("derived radiation constants agree with CODATA", "[core][constants]") {
  const auto continues = [](double value, double printed, double unit) {
    return value >= printed && value < printed + unit;
  };
  CHECK(continues(si::stefan_boltzmann, 5.670374419e-8, 1e-17));
  CHECK(continues(si::radiation_c2, 1.438776877e4, 1e-5));  // um K
  // First radiation constant for spectral radiance, 1.191042972e-16 W m^2 sr^-1, in um^4 / m^2.
  CHECK(continues(si::radiation_c1, 1.191042972e8, 1e-1));
}

TEST_CASE("angles convert between degrees and radians", "[core][quantity]") {
  using namespace literals;
  CHECK((180.0_deg).value == Approx(3.14159265358979324).epsilon(1e-15));
  CHECK(to_degrees(degrees(33.25)) == Approx(33.25).epsilon(1e-15));
  CHECK(degrees(-90.0) < 0.0_rad);
}

TEST_CASE("quantities add, scale and divide as their numbers do", "[core][quantity]") {
  using namespace literals;
  Kelvin t = 300.0_K;
  t += 20.0_K;
  t -= 10.0_K;
  CHECK(t == 310.0_K);
  CHECK(2.0 * t / 4.0 == 155.0_K);
  CHECK(-(t - 300.0_K) == Kelvin{-10.0});
  CHECK(t / 155.0_K == 2.0);
  CHECK(sizeof(Kelvin) == sizeof(double));
}
