// Laws that the air obeys whatever is in it, on columns made by hand.
#include <cmath>
#include <numbers>

#include "atmosphere/hand_made_air.hpp"
#include "atmosphere/make/path_light.hpp"
#include "atmosphere/paths/path_measure.hpp"
#include "atmosphere/paths/spherical_path.hpp"
#include "spectral/planck.hpp"
#include "support/catch.hpp"

namespace nadir::atmosphere::test {
namespace {

using std::numbers::pi;

/// Measure of the whole way along a node of a view; the horizon's second node looks below it.
double whole_measure(const AirTable& table, const AirTable::View& view, std::size_t zenith) {
  const auto& z = view.zenith_rad;
  const bool second = zenith > 0 && z[zenith] == z[zenith - 1];
  const bool below =
      second || std::cos(z[zenith]) < horizon_mu(table.ground_m, view.height_m) - 1e-12;
  const PathPoint eye{view.height_m, std::cos(z[zenith])};
  double way = below ? way_down_to_m(eye, table.ground_m) : way_up_to_m(eye, table.top_m);
  if (below && way < 0.0) way = -(earth_radius_m + eye.height_m) * eye.mu;
  way = std::max(way, 0.0);
  return air_measure_m(eye.height_m, advanced(eye, way).height_m, way);
}

double transmittance_at(const AirTable& table, const AirTable::View& view, Place at) {
  return std::exp(-value(view.extinction, view, at) * view.share[at.share] *
                  whole_measure(table, view, at.zenith));
}

/// Sky irradiance of level ground from the table's own nodes.
double sky_flux(const AirTable& table, const BodyPlace& body) {
  const AirTable::View& sky = table.sky;
  const std::size_t azimuths = sky.azimuth_rad.size();
  const auto kinds = static_cast<std::size_t>(table.kinds);
  std::vector<double> mean;
  for (std::size_t z = 0; z < sky.zenith_rad.size(); ++z) {
    double sum = 0.0;
    for (std::size_t a = 0; a < azimuths; ++a) {
      double light = value(sky.smooth, sky, {z, 0}, a);
      const double cosine = scattering_cosine(sky.zenith_rad[z], sky.azimuth_rad[a], body);
      for (std::size_t k = 0; k < kinds; ++k) {
        const double x = std::pow(0.5 * (1.0 - cosine), 0.25) * 256.0;
        const auto i = std::min<std::size_t>(255, static_cast<std::size_t>(x));
        const double t = x - static_cast<double>(i);
        const double p = (1.0 - t) * static_cast<double>(table.phase[k * 257 + i]) +
                         t * static_cast<double>(table.phase[k * 257 + i + 1]);
        light += p * value(sky.first, sky, {z, 0}, k);
      }
      sum += light * (a == 0 || a + 1 == azimuths ? 0.5 : 1.0);
    }
    mean.push_back(sum / static_cast<double>(azimuths - 1));
  }
  double flux = 0.0;
  for (std::size_t z = 1; z < mean.size(); ++z) {
    const double a = std::sin(sky.zenith_rad[z - 1]), b = std::sin(sky.zenith_rad[z]);
    flux += 0.5 * (mean[z] + mean[z - 1]) * (b * b - a * a);
  }
  return pi * flux;
}

}  // namespace

TEST_CASE("In a furnace air is invisible along every path", "[atmosphere][air]") {
  // Walls, ground, air and the space outside at one temperature: radiance is Planck's everywhere,
  // whatever scatters or absorbs. What ways add, over 1 - T, is then B; 1e-5 is the promise.
  const double wavelength = GENERATE(4.0, 10.0);
  const double haze = GENERATE(0.0, 0.5, 5.0);
  const double height = GENERATE(0.0, 2.0, 3000.0, 100e3);
  HandMadeAir air{
      .rayleigh = 0.3, .haze = haze, .haze_albedo = 0.8, .absorption = 0.4, .temperature_k = 290.0};
  TableJob job = job_of(air, wavelength);
  job.settings.observer_height_m = height;
  job.settings.streams = 4;
  job.settings.zenith_nodes = 6;
  const double planck = spectral::planck(Micrometres{wavelength}, Kelvin{290.0}).value;
  job.starlight = {planck};
  const AirTable table = filled_table(job);
  CAPTURE(wavelength, haze, height);
  for (std::size_t z = 0; z < table.sky.zenith_rad.size(); ++z) {
    const double seen = value(table.sky.even, table.sky, {z, 0}) +
                        planck * value(table.sky.ground, table.sky, {z, 0});
    CHECK(seen == Approx(planck).epsilon(1e-5));
  }
  const AirTable::View& view = table.views.front();
  const double horizon = std::acos(horizon_mu(0.0, height));
  double worst = 0.0;
  for (std::size_t z = 0; z < view.zenith_rad.size(); ++z) {
    const bool down =
        view.zenith_rad[z] > horizon || (z > 0 && view.zenith_rad[z] == view.zenith_rad[z - 1]);
    for (std::size_t s = 0; s < view.share.size(); ++s) {
      const double t = transmittance_at(table, view, {z, s});
      const double even = value(view.even, view, {z, s});
      const double ground = planck * value(view.ground, view, {z, s});
      // Straight up at the top there is no air.
      if (whole_measure(table, view, z) == 0.0 && !down) continue;
      // The last node looking up sees the space outside as well.
      const bool space = !down && s + 1 == view.share.size();
      const double source = (even + ground) * (space ? 1.0 - t : 1.0);
      worst = std::max(worst, std::abs(source / planck - 1.0));
    }
  }
  CHECK(worst < 1e-5);
  // The ground gets its own light back where the air scatters.
  const double down = static_cast<double>(table.even_ground_irradiance[0]) +
                      pi * planck * static_cast<double>(table.spherical_albedo[0]);
  CHECK(down == Approx(pi * planck).epsilon(1e-5));
}

TEST_CASE("Where there is no air nothing is lost or added", "[atmosphere][air]") {
  TableJob job = job_of({.rayleigh = 0.0}, 0.55);
  job.bodies = {body_at(40.0)};
  const AirTable table = filled_table(job);
  check(table);
  for (const AirTable::View* view : {&table.sky, &table.views.front()}) {
    for (const auto* rows :
         {&view->extinction, &view->first, &view->smooth, &view->even, &view->ground}) {
      for (const float v : *rows) CHECK(v == 0.0F);
    }
  }
  CHECK(table.bodies[0].transmittance[0] == 1.0F);
  CHECK(static_cast<double>(table.bodies[0].ground_irradiance[0]) ==
        Approx(std::sin(40.0 * degree)).epsilon(1e-6));
  CHECK(table.spherical_albedo[0] == 0.0F);
}

TEST_CASE("The sky that is seen brings the flux that was solved for", "[atmosphere][air]") {
  // First scattering from A and P, the rest from M: together the downward flux of the solver. 4 %:
  // the solver's air is plane, where thin air's radiance grows as 1 / cos z, so that each degree of
  // height brings as much flux; the last three degrees lose to the earth's curvature.
  // A missing factor anywhere would show.
  const double elevation = GENERATE(20.0, 50.0, 90.0);
  const double depth = GENERATE(0.02, 0.3, 1.0);
  TableJob job = job_of({.rayleigh = depth}, 0.5);
  job.settings.zenith_nodes = 40;
  job.settings.azimuth_nodes = 25;
  job.bodies = {body_at(elevation)};
  const AirTable table = filled_table(job);
  const double mu0 = std::sin(elevation * degree);
  const double total = static_cast<double>(table.bodies[0].ground_irradiance[0]);
  const double direct = static_cast<double>(table.bodies[0].transmittance[0]) * mu0;
  CAPTURE(elevation, depth);
  CHECK(sky_flux(table, {mu0, 0.0}) == Approx(total - direct).epsilon(0.04));
  CHECK(total < mu0);
}

TEST_CASE("The air returns and lets through all of the ground's light", "[atmosphere][air]") {
  // No absorption: S and the diffuse transmittance of even light from the ground sum to 1.
  const HandMadeAir air{.rayleigh = 0.4, .haze = 0.6};
  const Shells shells{HandMadeAir::levels_m(), DirectionGrid{8}};
  SolveCounts counts;
  const LaneFields fields =
      lane_fields({air.column(), Micrometres{0.5}, {}, 0.0, 0.0, 0.0}, shells, {}, {}, counts);
  CHECK(fields.from_ground.down_at_ground + fields.from_ground.up_at_top ==
        Approx(pi).epsilon(1e-6));  // the solver's promise
  CHECK(fields.from_ground.down_at_ground > 0.1);
}

TEST_CASE("The sky is brightest towards the sun", "[atmosphere][air]") {
  TableJob job = job_of({.rayleigh = 0.1, .haze = 0.3}, 0.55);
  job.bodies = {body_at(30.0)};
  const AirTable table = filled_table(job);
  const AirTable::View& sky = table.sky;
  const std::size_t last = sky.azimuth_rad.size() - 1;
  // The node of zenith nearest the sun's 60 degrees, towards the sun, across and away: also what
  // was scattered more than once keeps its direction.
  std::size_t z = 0;
  while (sky.zenith_rad[z + 1] < 60.0 * degree) ++z;
  const double towards = value(sky.smooth, sky, {z, 0}, 0);
  const double across = value(sky.smooth, sky, {z, 0}, last / 2);
  CHECK(towards > across);
  CHECK(towards > value(sky.smooth, sky, {z, 0}, last));
  // and seen from above it is the other way about: bright ahead, under the sun's side
  CHECK(table.bodies[0].azimuth_rad == Approx(pi).epsilon(1e-9));
}

TEST_CASE("Under a sun in the zenith azimuth does not matter", "[atmosphere][air]") {
  TableJob job = job_of({.rayleigh = 0.2, .haze = 0.4}, 0.55);
  job.bodies = {body_at(90.0)};
  const AirTable table = filled_table(job);
  const AirTable::View& sky = table.sky;
  for (std::size_t z = 0; z < sky.zenith_rad.size(); ++z) {
    const double first = value(sky.smooth, sky, {z, 0}, 0);
    for (std::size_t a = 1; a < sky.azimuth_rad.size(); ++a) {
      CHECK(value(sky.smooth, sky, {z, 0}, a) == Approx(first).epsilon(1e-5));  // floats
    }
  }
}

TEST_CASE("Transmittance to a share of the way is that of the air up to there",
          "[atmosphere][air]") {
  // Straight down through air that falls off with 8 km and nothing else, share and depth are
  // proportional: extinction per measure is one number. 1 %: layers are mixed evenly.
  TableJob job = job_of({.rayleigh = 0.0, .absorption = 0.8}, 0.55);
  const AirTable table = filled_table(job);
  const AirTable::View& view = table.views.front();
  const std::size_t nadir = view.zenith_rad.size() - 1, last = view.share.size() - 1;
  const double whole = value(view.extinction, view, {nadir, last});
  CHECK(whole * whole_measure(table, view, nadir) ==
        Approx(0.8 * (1.0 - std::exp(-100.0 / 8.0))).epsilon(2e-3));
  for (std::size_t s = last - 3; s <= last; ++s) {
    CHECK(value(view.extinction, view, {nadir, s}) == Approx(whole).epsilon(0.01));
  }
}

}  // namespace nadir::atmosphere::test
