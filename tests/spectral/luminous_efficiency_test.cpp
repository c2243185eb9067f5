#include "spectral/luminous_efficiency.hpp"

#include <cmath>
#include <vector>

#include "spectral/planck.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::spectral;

TEST_CASE("V(lambda) is 1 at 555 nm in air and has its published sum", "[spectral][photometry]") {
  CHECK(luminous_efficiency(Micrometres{0.555 * 1.000278}) == Approx(1.0).epsilon(1e-12));
  CHECK(luminous_efficiency(Micrometres{0.510 * 1.000278}) == Approx(0.503).epsilon(1e-12));
  CHECK(luminous_efficiency(Micrometres{0.3799}) == 0.0);
  CHECK(luminous_efficiency(Micrometres{0.7803}) == 0.0);
  // The sum of ybar of the CIE 1931 observer, which is V, over 380 (5) 780 nm: 21.371327 (CIE
  // 015:2018, table 5). As an integral the ends count half, and wavelengths are those in vacuum.
  const double integral_um = (21.371327 - 0.5 * (0.000039 + 0.000015)) * 5e-3 * 1.000278;
  CHECK(luminous(Curve::constant(1.0)) == Approx(683.0 * integral_um).epsilon(1e-9));
}

TEST_CASE("platinum freezes at 60 cd per square centimetre", "[spectral][photometry]") {
  // The candela's definition of 1948 to 1979: a black body at the freezing point of platinum,
  // 2041.4 K on ITS-90 (2042 K when it was in force), has 60 cd cm^-2. The realisations spread by
  // about 1 %, and 0.6 K are 0.4 % of the luminance.
  std::vector<double> wavelength_um, radiance;
  for (double w = 0.35; w < 0.82; w += 0.001) {
    wavelength_um.push_back(w);
    radiance.push_back(planck(Micrometres{w}, 2042.0_K).value);
  }
  CHECK(luminous(Curve{wavelength_um, radiance, Outside::reject}) == Approx(60e4).epsilon(0.01));
}

TEST_CASE("the luminous integral is exact for lines, whatever their knots",
          "[spectral][photometry]") {
  const Curve line{{0.3, 0.9}, {3.0, 9.0}, Outside::reject};
  const Curve cut{{0.3, 0.41234, 0.5, 0.61, 0.9}, {3.0, 4.1234, 5.0, 6.1, 9.0}, Outside::reject};
  CHECK(luminous(line) == Approx(luminous(cut)).epsilon(1e-13));
  CHECK(std::isnan(luminous(Curve{{0.4, 0.9}, {1.0, 1.0}, Outside::reject})));
}
