// The air where it is thinnest and thickest, looked through from everywhere: no NaN, nothing
// negative, nothing brighter than its light.
#include <algorithm>
#include <cmath>
#include <memory>

#include "atmosphere/hand_made_air.hpp"
#include "atmosphere/paths/spherical_path.hpp"
#include "atmosphere/table/bound_air_table.hpp"
#include "support/catch.hpp"

namespace nadir::atmosphere::test {
namespace {

/// Looks through a table in every direction to every range.
void look_everywhere(const AirTable& made, double brightest) {
  check(made);  // finite, not negative
  const auto table = std::make_shared<const AirTable>(made);
  const BoundAirTable bound{
      table, {{0.5F}, {0.1F}}, spectral::Lanes{{Micrometres{made.lanes[0].wavelength_um}}}};
  const double ground = static_cast<double>(bound.ground_radiance()[0]);
  CHECK(std::isfinite(ground));
  const double most = 1.01 * (brightest + ground);
  double worst = 0.0, least = 0.0, over = 0.0;
  const auto take = [&](float radiance) {
    const double r = static_cast<double>(radiance);
    worst = std::isfinite(r) ? std::max(worst, r) : INFINITY;
    least = std::min(least, r);
  };
  for (const double zenith_deg : {0.0, 60.0, 89.9, 90.0, 90.1, 95.0, 120.0, 180.0}) {
    const double z = zenith_deg * degree;
    const Vec3 direction{0.0, std::sin(z), std::cos(z)};
    take(bound.sky(direction)[0]);
    for (const double height : {0.0, 1.7, 1e5, 3.6e7}) {
      take(bound.beyond({0.0, 0.0, height}, direction)[0]);
      const PathPoint eye{height, std::cos(z)};
      const double ground_m = way_down_to_m(eye, 0.0);
      for (const double length : {1e-3, 1.0, 1e4, 1e6, 4e7}) {
        if (eye.mu < 0.0 && ground_m >= 0.0 && length > ground_m) continue;  // into the ground
        const PathTerms path = bound.path({0.0, 0.0, height}, direction, length);
        take(path.radiance[0]);
        over = std::max(over, static_cast<double>(path.transmittance[0]));
        least = std::min(least, static_cast<double>(path.transmittance[0]));
      }
    }
  }
  CHECK(worst <= most);
  CHECK(least >= 0.0);
  CHECK(over <= 1.0);
}

}  // namespace

TEST_CASE("Air of any depth under a sun at any height", "[hard][air]") {
  const double depth = GENERATE(0.0, 1e-8, 1.0, 1e3);
  const double elevation = GENERATE(90.0, 30.0, 0.0, -0.2, -10.0);
  const double height = GENERATE(0.0, 100e3, 3.6e7);
  CAPTURE(depth, elevation, height);
  TableJob job =
      job_of({.rayleigh = 0.3 * depth, .haze = 0.5 * depth, .absorption = 0.2 * depth}, 0.55);
  job.settings.observer_height_m = height;
  job.settings.streams = 4;
  job.bodies = {body_at(elevation, 0.0)};
  // Scattered once into the peak of the phase function of g = 0.7, 1.5 sr^-1, and more.
  look_everywhere(filled_table(job), 2.0);
}

TEST_CASE("Haze of 50 m visibility and a cloud of depth 1000", "[hard][air]") {
  const double haze = GENERATE(156.0, 1000.0);
  const double absorbed = GENERATE(0.0, 0.3);
  TableJob job =
      job_of({.rayleigh = 0.1, .haze = haze, .haze_g = 0.86, .haze_albedo = 1.0 - absorbed}, 0.55);
  job.bodies = {body_at(35.0)};
  const AirTable table = filled_table(job);
  look_everywhere(table, 8.0);
  // What does not absorb lets light through even so: 1 / (1 + 0.75 (1 - g) tau) of it.
  if (absorbed == 0.0) CHECK(table.bodies[0].ground_irradiance[0] > 0.003F);
}

TEST_CASE("Thermal air of any depth and temperature", "[hard][air]") {
  const double depth = GENERATE(0.0, 1e-8, 1.0, 1e3);
  const double kelvin = GENERATE(3.0, 290.0, 6000.0);
  const double wavelength = GENERATE(0.3, 10.0);
  CAPTURE(depth, kelvin, wavelength);
  TableJob job = job_of({.rayleigh = 0.1 * depth,
                         .haze = depth,
                         .haze_albedo = 0.5,
                         .absorption = depth,
                         .temperature_k = kelvin},
                        wavelength);
  job.settings.streams = 4;
  look_everywhere(filled_table(job), 1e9);
}

}  // namespace nadir::atmosphere::test
