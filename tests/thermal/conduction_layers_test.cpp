#include "thermal/conduction/layers.hpp"

#include <limits>
#include <numbers>

#include "core/error.hpp"
#include "support/catch.hpp"

namespace nadir::thermal {
namespace {

const Substance asphalt{0.75, 2110.0, 920.0};
const Substance concrete{1.51, 2400.0, 880.0};
const Substance insulation{0.03, 30.0, 1400.0};
const Substance steel{45.0, 7800.0, 500.0};
const Substance glass{1.0, 2500.0, 750.0};

std::string refusal(const LayerStack& stack) {
  try {
    check(stack);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

// Independent figures: daily damping depths of the five solids in conduction_closed_forms_test.cpp
// come from another program; six digits are printed, so half a unit of the last.
TEST_CASE("the damping depth of a day is that of handbooks", "[thermal][conduction]") {
  CHECK(damping_depth(asphalt, Seconds{86400.0}).value == Approx(0.103081).margin(5e-7));
  CHECK(damping_depth(concrete, Seconds{86400.0}).value == Approx(0.140224).margin(5e-7));
  // a year's wave goes sqrt(365) as deep; rounding only
  CHECK(damping_depth(concrete, Seconds{365.0 * 86400.0}) /
            damping_depth(concrete, Seconds{86400.0}) ==
        Approx(std::sqrt(365.0)).epsilon(1e-14));
}

TEST_CASE("stacks that make no sense are refused by name", "[thermal][conduction]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(refusal({}), Catch::Matchers::Contains("at least one layer"));
  CHECK_THAT(refusal({{{asphalt, 0.1, 0.0}, {asphalt, -0.1, 0.0}}, AdiabaticBack{}}),
             Catch::Matchers::Contains("the thickness of layer 2 must be positive"));
  CHECK_THAT(refusal({{{{0.0, 1.0, 1.0}, 0.1, 0.0}}, AdiabaticBack{}}),
             Catch::Matchers::Contains("the conductivity of layer 1"));
  CHECK_THAT(refusal({{{{1.0, nan, 1.0}, 0.1, 0.0}}, AdiabaticBack{}}),
             Catch::Matchers::Contains("the density of layer 1"));
  CHECK_THAT(refusal({{{{1.0, 1.0, 1.0 / 0.0}, 0.1, 0.0}}, AdiabaticBack{}}),
             Catch::Matchers::Contains("the specific heat of layer 1"));
  CHECK_THAT(refusal({{{asphalt, 0.1, nan}}, AdiabaticBack{}}),
             Catch::Matchers::Contains("heat released of layer 1"));
  CHECK_THAT(refusal({{{asphalt, 0.1, 0.0}}, FixedBack{Kelvin{2.0}}}),
             Catch::Matchers::Contains("temperature of the back"));
  CHECK_THAT(refusal({{{asphalt, 0.1, 0.0}}, RoomBack{Kelvin{3000.0}, 0.0, 8.3}}),
             Catch::Matchers::Contains("temperature of the room"));
  CHECK_THAT(refusal({{{asphalt, 0.1, 0.0}}, RoomBack{std::nullopt, 0.0, 0.0}}),
             Catch::Matchers::Contains("film coefficient of the room"));
  CHECK_THAT(refusal({{{asphalt, 0.1, 0.0}}, RoomBack{std::nullopt, nan, 8.3}}),
             Catch::Matchers::Contains("offset of the room"));
  CHECK(refusal({{{asphalt, 0.1, 20.0}}, RoomBack{std::nullopt, -3.0, 8.3}}).empty());
  CHECK(refusal({{{asphalt, 0.1, -300.0}}, AdiabaticBack{}}).empty());  // cooled by pipes
}

TEST_CASE("only sheets of one temperature may have weather on both sides",
          "[thermal][conduction]") {
  CHECK(refusal({{{steel, 0.005, 0.0}}, OpenBack{}}).empty());
  CHECK(refusal({{{glass, 0.004, 0.0}}, OpenBack{}}).empty());  // Biot number of half of it: 0.05
  CHECK_THAT(refusal({{{insulation, 0.01, 0.0}}, OpenBack{}}),
             Catch::Matchers::Contains("open back"));
  // Biot number of half the sheet at 25 W m^-2 K^-1: 0.1 at 8 mm of glass
  CHECK(refusal({{{glass, 0.00799, 0.0}}, OpenBack{}}).empty());
  CHECK_FALSE(refusal({{{glass, 0.00801, 0.0}}, OpenBack{}}).empty());
}

TEST_CASE("a stack's memory is the slower of diffusion and discharge", "[thermal][conduction]") {
  // Closed forms, rounding only.
  const double film = 15.0;
  const double alpha = asphalt.diffusivity_m2_s();
  // thick: L^2 / alpha
  CHECK(memory_of({{{asphalt, 1.0, 0.0}}, AdiabaticBack{}}, film).value ==
        Approx(1.0 / alpha).epsilon(1e-12));
  // thin: C / film, half of it with weather on both sides (the sheet's own half resistance: 1e-4)
  const double sheet = 7800.0 * 500.0 * 0.001 / film;
  CHECK(memory_of({{{steel, 0.001, 0.0}}, AdiabaticBack{}}, film).value ==
        Approx(sheet).epsilon(1e-3));
  CHECK(memory_of({{{steel, 0.001, 0.0}}, OpenBack{}}, film).value ==
        Approx(sheet / 2.0).epsilon(1e-3));
}

TEST_CASE("mass behind insulation remembers for long unless a room takes its heat",
          "[thermal][conduction]") {
  const Layer outside{insulation, 0.1, 0.0}, mass{concrete, 0.1, 0.0};
  const double heat = concrete.heat_capacity_j_m3_k() * 0.1, resistance = 0.1 / 0.03;
  // C R, but for the insulation's own heat (2 % of the concrete's) and the film (2 % of R)
  CHECK(memory_of({{outside, mass}, AdiabaticBack{}}).value ==
        Approx(heat * resistance).epsilon(0.05));
  // by way of the room's film: 8.3 W m^-2 K^-1 and half the concrete
  CHECK(memory_of({{outside, mass}, RoomBack{}}).value < 0.1 * heat * resistance);
}

}  // namespace nadir::thermal
