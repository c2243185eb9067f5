#include "thermal/temperature.hpp"

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "support/catch.hpp"

namespace nadir::thermal {
namespace {

TEST_CASE("a hit has its material's temperature", "[thermal]") {
  const TemperatureField field{{ConstantTemperature{290.0_K}, ConstantTemperature{Kelvin{0.0}}}};
  geometry::Hit hit;
  hit.material = 0;
  CHECK(field.at(hit).value == 290.0);
  hit.material = 1;
  CHECK(field.at(hit).value == 0.0);
}

TEST_CASE("temperatures below absolute zero are refused", "[thermal]") {
  const double value = GENERATE(-1.0, -1e-9, std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity());
  CHECK_THROWS_AS(TemperatureField{{ConstantTemperature{Kelvin{value}}}}, InputError);
}

/// Kelvin that grow by 2 from column to column and by 5 from row to row, 3 x 2 pixels of 10 m.
MappedTemperature slope() {
  MappedTemperature map;
  map.frame.origin = {100.0, 50.0};
  map.frame.step = {10.0, -10.0};
  map.frame.columns = 3;
  map.frame.rows = 2;
  map.kelvin = {280.0F, 282.0F, 284.0F, 285.0F, 287.0F, 289.0F};
  return map;
}

Kelvin at_place(const TemperatureField& field, double east_m, double north_m) {
  geometry::Hit hit;
  hit.position = {east_m, north_m, 3.0};
  return field.at(hit);
}

// A plane is interpolated exactly; values of this size are floats to 3e-5.
TEST_CASE("a map of temperatures is linear between pixel centres", "[thermal]") {
  const TemperatureField field{{slope()}};
  CHECK(at_place(field, 105.0, 45.0).value == Approx(280.0).margin(1e-4));
  CHECK(at_place(field, 110.0, 45.0).value == Approx(281.0).margin(1e-4));
  CHECK(at_place(field, 117.0, 41.0).value == Approx(280.0 + 2.0 * 1.2 + 5.0 * 0.4).margin(1e-4));
}

TEST_CASE("beyond its pixels' centres a map of temperatures keeps those of its edge", "[thermal]") {
  const TemperatureField field{{slope()}};
  CHECK(at_place(field, 0.0, 45.0).value == Approx(280.0).margin(1e-4));
  CHECK(at_place(field, 500.0, -90.0).value == Approx(289.0).margin(1e-4));
}

TEST_CASE("a map of temperatures that repeats is interpolated across its edges", "[thermal]") {
  MappedTemperature map = slope();
  map.frame.repeats = true;
  const TemperatureField field{{map}};
  CHECK(at_place(field, 130.0, 45.0).value == Approx(0.5 * (284.0 + 280.0)).margin(1e-4));
  CHECK(at_place(field, 105.0 + 3 * 30.0, 45.0).value == Approx(280.0).margin(1e-4));
}

TEST_CASE("a map of temperatures may follow the mesh's texture", "[thermal]") {
  MappedTemperature map = slope();
  map.frame.by = materials::MapFrame::By::texture;
  map.frame.origin = {0.0, 1.0};
  map.frame.step = {1.0 / 3.0, -0.5};
  const TemperatureField field{{map}};
  geometry::Hit hit;
  hit.texture = {0.5, 0.5};
  CHECK(field.at(hit).value == Approx(284.5).margin(1e-4));
}

TEST_CASE("a map of temperatures knows its coldest and warmest pixel", "[thermal]") {
  const TemperatureField field{{slope(), ConstantTemperature{290.0_K}}};
  CHECK(field.range(0).coldest.value == 280.0);
  CHECK(field.range(0).hottest.value == 289.0);
  CHECK_FALSE(field.constant(0));
  CHECK(field.constant(1)->value == 290.0);
}

TEST_CASE("maps of temperatures that are not full or below 0 K are refused", "[thermal]") {
  MappedTemperature map = slope();
  map.kelvin.pop_back();
  CHECK_THROWS_AS(TemperatureField{{map}}, InputError);
  map = slope();
  map.kelvin[2] = -1.0F;
  CHECK_THROWS_AS(TemperatureField{{map}}, InputError);
}

TEST_CASE("where nobody asks for a temperature there is none", "[thermal]") {
  const TemperatureField field{{UnaskedTemperature{}}};
  CHECK(std::isnan(field.at(geometry::Hit{}).value));
  CHECK_FALSE(field.solved(0));
}

}  // namespace
}  // namespace nadir::thermal
