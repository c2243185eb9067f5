#include "radiometry/lamps/lamp_spectrum.hpp"

#include <cmath>

#include "core/constants.hpp"
#include "spectral/luminous_efficiency.hpp"
#include "spectral/planck.hpp"
#include "support/catch.hpp"

using namespace nadir;
using radiometry::flux_of_one_lumen;

TEST_CASE("a lumen of any colour temperature is a lumen, in the shape of Planck's law",
          "[radiometry][lamps]") {
  const Kelvin t{GENERATE(1000.0, 2700.0, 6500.0, 25000.0)};
  const auto flux = flux_of_one_lumen(t);
  CHECK(spectral::luminous(flux) == Approx(1.0).epsilon(1e-12));
  const double scale = flux.at(0.6_um) / spectral::planck(0.6_um, t).value;
  for (double w = 0.201; w < 20.0; w *= 1.037) {  // between the knots: the documented 1e-4, twice
    const double expected = scale * spectral::planck(Micrometres{w}, t).value;
    CHECK(flux.at(Micrometres{w}) == Approx(expected).epsilon(2e-4));
  }
}

TEST_CASE("black bodies of 4000 and 7000 K give the known lumens a watt", "[radiometry][lamps]") {
  // All that a black body of T radiates per lumen: scale sigma T^4 / pi. The literature gives 54.7
  // lm/W at 4000 K and 95 at 7000 K, near its maximum (T. W. Murphy, J. Appl. Phys. 111, 104909
  // (2012): 95 lm/W at most), rounded to the digits shown.
  const auto lumens_per_watt = [](Kelvin t) {
    const double scale = flux_of_one_lumen(t).at(0.6_um) / spectral::planck(0.6_um, t).value;
    return 3.14159265358979 / (scale * si::stefan_boltzmann * std::pow(t.value, 4));
  };
  CHECK(lumens_per_watt(4000.0_K) == Approx(54.7).margin(0.2));
  CHECK(lumens_per_watt(7000.0_K) == Approx(95.0).margin(0.5));
}
