#include "spectral/coverage.hpp"

#include <string>

#include "core/error.hpp"
#include "support/catch.hpp"

namespace nadir::spectral {
namespace {

const Curve curve{{0.4, 1.0}, {2.0, 8.0}, Outside::reject};

TEST_CASE("a curve that covers the lanes is taken to them", "[spectral]") {
  const Spectrum s = at_all(curve, Lanes{{0.4_um, 0.7_um, 1.0_um}}, "the sky's radiance");
  CHECK(s[0] == 2.0F);
  CHECK(s[1] == Approx(5.0).epsilon(1e-6));  // float lanes
  CHECK(s[2] == 8.0F);
}

TEST_CASE("a lane that stands for an interval takes the mean over it", "[spectral]") {
  const Curve peak{{0.4, 0.5, 0.6, 1.0}, {0.0, 1.0, 0.0, 0.0}, Outside::reject};
  const Lanes lanes{{0.5_um, 0.7_um}, {{0.4, 0.6, 0}, {0.65, 2.0, 0}}};
  const Spectrum s = mean_at_all(peak, lanes, "the sun's irradiance");
  CHECK(s[0] == 0.5F);
  CHECK(s[1] == 0.0F);  // the curve ends before the interval: at the wavelength
  CHECK(lane_mean(peak, 0.5_um, {}) == 1.0);
}

TEST_CASE("a curve that does not cover the lanes is an error that says both ranges", "[spectral]") {
  try {
    (void)at_all(curve, Lanes{{0.5_um, 10.9_um}}, "the sky's radiance");
    FAIL("no error");
  } catch (const InputError& error) {
    CHECK(std::string{error.what()} ==
          "error: the sky's radiance is tabulated from 0.4 to 1 um, but the bands need it from "
          "0.5 to 10.9 um\n");
  }
}

}  // namespace
}  // namespace nadir::spectral
