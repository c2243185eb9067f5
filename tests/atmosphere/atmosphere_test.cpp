#include "atmosphere/atmosphere.hpp"

#include "core/error.hpp"
#include "spectral/planck.hpp"
#include "support/catch.hpp"

namespace nadir::atmosphere {
namespace {

const spectral::Lanes lanes{{0.55_um, 4.0_um, 10.9_um}};
constexpr Vec3 up{0.0, 0.0, 1.0};

Uniform uniform(double transmittance, Kelvin air) {
  const auto constant = [](double v) { return spectral::Curve::constant(v); };
  return {constant(3.0), 250.0_K, constant(0.8), constant(transmittance), constant(0.5), air};
}

TEST_CASE("without air the sky is black and nothing is lost", "[atmosphere]") {
  const BoundAtmosphere air{None{}, lanes};
  const PathTerms path = air.path({}, up, 1e6);
  for (int lane = 0; lane < lanes.count(); ++lane) {
    CHECK(air.sky(up)[lane] == 0.0F);
    CHECK(air.direct_transmittance(up)[lane] == 1.0F);
    CHECK(path.transmittance[lane] == 1.0F);
    CHECK(path.radiance[lane] == 0.0F);
  }
}

TEST_CASE("a uniform sky adds its emission to its radiance", "[atmosphere]") {
  const BoundAtmosphere air{uniform(1.0, Kelvin{0.0}), lanes};
  for (int lane = 0; lane < lanes.count(); ++lane) {
    const double expected = 3.0 + spectral::planck(lanes[lane], 250.0_K).value;
    CHECK(air.sky(up)[lane] == Approx(expected).epsilon(1e-6));  // float lanes
    CHECK(air.direct_transmittance(up)[lane] == 0.8F);
  }
}

TEST_CASE("a path in equilibrium with what it looks at changes nothing but what it scatters",
          "[atmosphere]") {
  // Second law: air and background of one temperature look like that temperature.
  const double transmittance = GENERATE(0.0, 0.3, 0.9, 1.0);
  const PathTerms path = BoundAtmosphere{uniform(transmittance, 290.0_K), lanes}.path({}, up, 1e3);
  const auto background = spectral::planck(lanes, 290.0_K);
  for (int lane = 0; lane < lanes.count(); ++lane) {
    const double seen =
        static_cast<double>(path.transmittance[lane] * background[lane] + path.radiance[lane]);
    CHECK(seen == Approx(static_cast<double>(background[lane]) + 0.5).epsilon(1e-6));
  }
}

TEST_CASE("air that is not tabulated at the bands' wavelengths is an error", "[atmosphere]") {
  Uniform air = uniform(1.0, Kelvin{0.0});
  air.path_radiance = spectral::Curve{{0.4, 1.0}, {1.0, 1.0}, spectral::Outside::reject};
  CHECK_THROWS_AS((BoundAtmosphere{air, lanes}), InputError);
}

}  // namespace
}  // namespace nadir::atmosphere
