// Real clouds, the thickest fog and thin cirrus through all of a table's making.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "atmosphere/table/bound_air_table.hpp"
#include "sim/lowtran_air.hpp"
#include "spectral/planck.hpp"
#include "support/catch.hpp"

namespace nadir::sim::test {
namespace {

using namespace atmosphere;
using std::numbers::pi;

constexpr double degree = pi / 180.0;

/// Air at one wavelength under a sun of irradiance 1000 (or none), as rays see it: the sum over the
/// lanes of its terms.
class Day {
 public:
  Day(const Layered& air, double wavelength_um, double elevation_deg,
      double observer_height_m = 2.0) {
    const std::vector<Micrometres> wavelengths{Micrometres{wavelength_um}};
    AirSettings settings;
    settings.observer_height_m = observer_height_m;
    settings.term_tolerance = 2e-3;
    lanes_ = split_lanes(air, settings, wavelengths, {});
    const double h = elevation_deg * degree;
    ephemeris::Illumination bodies;
    if (elevation_deg > 0.0) {
      bodies.push_back({"sun",
                        {0.0, std::cos(h), std::sin(h)},
                        Angle{0.00465},
                        spectral::Curve::constant(1000.0)});
    }
    table_ = std::make_shared<const AirTable>(
        make_air_table(air, settings, lanes_, wavelengths, bodies));
    check(*table_);
    std::vector<Micrometres> all(lanes_.size(), wavelengths.front());
    std::vector<spectral::AbsorptionLane> absorption;
    for (const SplitLane& lane : lanes_) absorption.push_back(lane.absorption);
    const std::vector<float> dark(lanes_.size(), 0.0F);
    bound_ = std::make_shared<const BoundAirTable>(table_, GroundLight{dark, dark},
                                                   spectral::Lanes{all, absorption});
  }
  [[nodiscard]] double sky(double zenith_deg, double azimuth_deg) const {
    return sum(bound_->sky(towards(zenith_deg, azimuth_deg)));
  }
  [[nodiscard]] double direct(double elevation_deg) const {
    return sum(bound_->direct_transmittance(towards(90.0 - elevation_deg, 0.0)));
  }
  [[nodiscard]] double passed(double zenith_deg, double length_m) const {
    return sum(bound_->path({0.0, 0.0, 2.0}, towards(zenith_deg, 120.0), length_m).transmittance);
  }
  [[nodiscard]] double path_radiance(double zenith_deg, double azimuth_deg, double length_m) const {
    return sum(bound_->path({0.0, 0.0, 2.0}, towards(zenith_deg, azimuth_deg), length_m).radiance);
  }
  [[nodiscard]] double ground_irradiance() const {
    double total = 0.0;
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
      total += lanes_[i].weight * static_cast<double>(table_->bodies.at(0).ground_irradiance[i]);
    }
    return total;
  }
  [[nodiscard]] double spherical_albedo() const {
    return static_cast<double>(table_->spherical_albedo[0]);
  }

 private:
  [[nodiscard]] double sum(const spectral::Spectrum& light) const {
    double total = 0.0;
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
      total += lanes_[i].weight * static_cast<double>(light[static_cast<int>(i)]);
    }
    return total;
  }
  [[nodiscard]] static Vec3 towards(double zenith_deg, double azimuth_deg) {
    const double z = zenith_deg * degree, a = azimuth_deg * degree;
    return {std::sin(z) * std::sin(a), std::sin(z) * std::cos(a), std::cos(z)};
  }

  std::vector<SplitLane> lanes_;
  std::shared_ptr<const AirTable> table_;
  std::shared_ptr<const BoundAirTable> bound_;
};

Layered cloudy(Cloud cloud) {
  Layered air = lowtran_air("us_standard_1976", AerosolType::none);
  if (cloud.optical_depth_550 > 0.0) air.clouds = {std::move(cloud)};
  return air;
}

Cloud stratus(double depth) { return {"stratus", 500.0, 1200.0, depth}; }

}  // namespace

TEST_CASE("Under stratus the sky is darker towards the horizon and shows no sun", "[sim][air]") {
  // Moon & Spencer (1942), the CIE's overcast sky (ISO 15469): (1 + 2 cos z) / 3 of the zenith, 1 /
  // 3 at the horizon over snowless ground. Black ground makes it 3.1 at 87 degrees.
  const Day day{cloudy(stratus(20.0)), 0.55, 40.0};
  const double zenith = day.sky(0.0, 0.0);
  for (const double z : {30.0, 60.0, 80.0}) {
    CAPTURE(z);
    CHECK(day.sky(z, 90.0) / zenith ==
          Approx((1.0 + 2.0 * std::cos(z * degree)) / 3.0).epsilon(0.15));
  }
  const double ratio = zenith / day.sky(87.0, 90.0);
  CHECK(ratio > 2.0);
  CHECK(ratio < 3.3);
  // exp(-20 / sin 40): 1e-13. Where the sun stands it is not 10 % brighter than as high elsewhere.
  CHECK(day.direct(40.0) < 1e-12);
  const double at_sun = day.sky(50.0, 0.0);
  CHECK(at_sun < 1.1 * day.sky(50.0, 20.0));
  CHECK(at_sun < 1.2 * day.sky(50.0, 180.0));
  CHECK(at_sun > 0.999 * day.sky(50.0, 180.0));
}

TEST_CASE("Stratus lets through what two streams say", "[sim][air]") {
  // Shettle & Weinman, J. Atmos. Sci. 27, 1048 (1970), delta-scaled, for conservative clouds over
  // black ground: T = ((2 + 3 mu) + (2 - 3 mu) exp(-t' / mu)) / (4 + 3 (1 - g') t'), where
  // (1 - g') t' = (1 - g) t, 1 - 4 / (4 + 3 (1 - g) t) for the albedo under even light. What the
  // air above sends back, S of it, comes again. 4 %: two streams' own error is 1 to 5 % (King &
  // Harshvardhan, J. Atmos. Sci. 43, 784, 1986).
  const double depth = GENERATE(10.0, 20.0, 50.0);
  const double elevation = GENERATE(30.0, 60.0);
  const double mu = std::sin(elevation * degree);
  const Layered air = cloudy(stratus(depth));
  const Particles cloud{air.particles, air.aerosol, air.clouds, {100e3, 1200.0, 500.0, 0.0}};
  const KindOptics optics = cloud.optics(0, Micrometres{0.55});
  REQUIRE(optics.absorption < 1e-4);
  const double g = optics.phase->asymmetry();
  CHECK(g == Approx(0.85).margin(0.03));  // of all water clouds in the visible
  const Day day{air, 0.55, elevation};
  const Day clear{cloudy(stratus(0.0)), 0.55, elevation};
  const double scaled = (1.0 - g * g) * depth;
  const double expected = ((2.0 + 3.0 * mu) + (2.0 - 3.0 * mu) * std::exp(-scaled / mu)) /
                          (4.0 + 3.0 * (1.0 - g) * depth);
  CAPTURE(depth, elevation);
  const double albedo = 1.0 - 4.0 / (4.0 + 3.0 * (1.0 - g) * depth);
  const double again = 1.0 / (1.0 - clear.spherical_albedo() * albedo);
  CHECK(day.ground_irradiance() / clear.ground_irradiance() ==
        Approx(expected * again).epsilon(0.04));
}

TEST_CASE("In fog of 50 m visibility nothing shows beyond", "[sim][air]") {
  Layered air = lowtran_air("us_standard_1976", AerosolType::fog_radiation);
  air.aerosol.visibility_km = 0.05;
  const Day day{air, 0.55, 40.0};
  // Koschmieder: 2 % of contrast over the visibility, whatever the direction near the ground.
  CHECK(day.passed(90.0, 50.0) == Approx(0.02).epsilon(0.1));
  CHECK(day.passed(90.0, 5.0) == Approx(std::exp(-0.3912)).epsilon(0.01));
  CHECK(day.passed(90.0, 1000.0) < 1e-20);
  // After 150 m there is nothing but fog, and its light no longer changes.
  const double fog = day.path_radiance(90.0, 120.0, 150.0);
  CHECK(fog > 0.0);
  CHECK(day.path_radiance(90.0, 120.0, 5000.0) == Approx(fog).epsilon(0.02));
  CHECK(day.direct(40.0) < 1e-20);
  // Some light comes down: 1 / (1 + 3/4 (1 - g) 140) of it, a few per cent.
  CHECK(day.ground_irradiance() > 0.01 * 643.0);
  CHECK(day.ground_irradiance() < 0.2 * 643.0);
  CHECK(day.sky(0.0, 0.0) > day.sky(80.0, 90.0));
}

TEST_CASE("Cirrus veils the sun and brightens the sky about it", "[sim][air]") {
  const double depth = 0.5, elevation = 50.0;
  const Day veiled{cloudy({"cirrus", 9000.0, 10'000.0, depth}), 0.55, elevation};
  const Day clear{cloudy({}), 0.55, elevation};
  // Beer's law to a float and the terms; at 50 degrees the earth's curvature is 1e-3 of the depth.
  CHECK(veiled.direct(elevation) / clear.direct(elevation) ==
        Approx(std::exp(-depth / std::sin(elevation * degree))).epsilon(2e-3));
  CHECK(veiled.sky(35.0, 0.0) > 3.0 * clear.sky(35.0, 0.0));
  CHECK(veiled.sky(45.0, 180.0) < 3.0 * clear.sky(45.0, 180.0));
  // Forward scattering reaches the ground: far less is lost than the sun loses.
  CHECK(veiled.ground_irradiance() < clear.ground_irradiance());
  CHECK(veiled.ground_irradiance() > 0.85 * clear.ground_irradiance());
}

TEST_CASE("Stratus is warm from below", "[sim][air]") {
  // Thick at 10.5 um, where little is left over the window: Planck at the base's 285 K, to 4 % for
  // what it reflects and the colder air above its face. A clear sky there is a fifth of that.
  const Day cloud{cloudy(stratus(30.0)), 10.5, 0.0}, clear{cloudy({}), 10.5, 0.0};
  const double base = spectral::planck(Micrometres{10.5}, Kelvin{288.15 - 6.5 * 0.5}).value;
  CHECK(cloud.sky(0.0, 0.0) == Approx(base).epsilon(0.04));
  CHECK(clear.sky(0.0, 0.0) < 0.3 * base);
}

}  // namespace nadir::sim::test
