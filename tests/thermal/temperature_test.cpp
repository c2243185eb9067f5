#include "thermal/temperature.hpp"

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

}  // namespace
}  // namespace nadir::thermal
