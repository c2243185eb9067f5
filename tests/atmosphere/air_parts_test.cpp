#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "atmosphere/atmosphere.hpp"
#include "atmosphere/hand_made_air.hpp"
#include "support/catch.hpp"

// The parts of the air that a scene leaves out: parts that bring light add up, and what no one
// wants is not solved for.

namespace nadir::atmosphere {
namespace {

using spectral::Spectrum;
using test::degree;
using test::HandMadeAir;

// Where a night sky and the air's warmth are of like size: neither may be taken for the other.
constexpr double both_um = 2.5;

/// Hazy warm air under a sun and a night sky.
TableJob hazy_job(double sun = 0.1) {
  TableJob job = test::job_of({.rayleigh = 0.05,
                               .haze = 0.3,
                               .haze_albedo = 0.9,
                               .absorption = 0.4,
                               .temperature_k = 285.0},
                              both_um);
  job.settings.streams = 4;
  job.settings.zenith_nodes = 6;
  job.settings.azimuth_nodes = 3;
  job.settings.share_nodes = 4;
  if (sun > 0.0) job.bodies = {test::body_at(40.0, 180.0, sun)};
  job.airglow = {5e-3};
  job.starlight = {2e-3};
  job.urban_glow = {1e-3};
  return job;
}

AirParts sky_of(bool scattering, bool emission) {
  return {scattering, emission, false, false, false};
}

std::shared_ptr<const AirTable> made(TableJob job, const AirParts& wanted,
                                     SolveCounts* counts = nullptr) {
  job.wanted = {wanted};
  auto table = std::make_shared<AirTable>(filled_table(job, counts));
  check(*table);
  return table;
}

BoundAirTable bound(const std::shared_ptr<const AirTable>& table, const AirParts& parts) {
  return {table, {{0.3F}, {0.02F}}, spectral::Lanes{{Micrometres{both_um}}}, parts};
}

const AirParts all;
constexpr AirParts scattering{true, false, true, false, true};
constexpr AirParts emission{false, true, false, true, true};

Vec3 looking(double elevation_deg, double azimuth_deg) {
  const double h = elevation_deg * degree, a = azimuth_deg * degree;
  return {std::cos(h) * std::sin(a), std::cos(h) * std::cos(a), std::sin(h)};
}

const Vec3 eye{0.0, 0.0, 100e3};
const std::array directions{looking(80.0, 10.0), looking(35.0, 170.0), looking(5.0, 90.0),
                            looking(0.5, 300.0)};

/// What three ways of looking show of one lane: sky, path and beyond the scene.
struct Seen {
  double sky, path, left, beyond;
};
Seen seen(const BoundAirTable& air, Vec3 up) {
  const Vec3 down{up.x, up.y, -up.z};
  const PathTerms terms = air.path(eye, down, 150e3);
  return {static_cast<double>(air.sky(up)[0]), static_cast<double>(terms.radiance[0]),
          static_cast<double>(terms.transmittance[0]),
          static_cast<double>(air.beyond(eye, down)[0])};
}

}  // namespace

// 2e-6: rounding of float look-ups.
TEST_CASE("scattered and emitted light of the air add up to all of it", "[atmosphere][effect]") {
  const auto table = made(hazy_job(), {});
  for (const Vec3 up : directions) {
    const Seen whole = seen(bound(table, all), up);
    const Seen one = seen(bound(table, scattering), up), other = seen(bound(table, emission), up);
    CHECK(one.sky > 0.01 * whole.sky);
    CHECK(other.sky > 0.01 * whole.sky);
    CHECK(one.sky + other.sky == Approx(whole.sky).epsilon(2e-6));
    CHECK(one.path + other.path == Approx(whole.path).epsilon(2e-6));
    CHECK(one.beyond + other.beyond == Approx(whole.beyond).epsilon(2e-6));
    CHECK(one.left == whole.left);
    CHECK(other.left == whole.left);
  }
  const Spectrum ground = bound(table, all).ground_radiance();
  CHECK(bound(table, scattering).ground_radiance()[0] +
            bound(table, emission).ground_radiance()[0] ==
        Approx(static_cast<double>(ground[0])).epsilon(2e-6));
}

TEST_CASE("the sky and the line of sight are left out apart from each other",
          "[atmosphere][effect]") {
  const auto table = made(hazy_job(), {});
  const Vec3 up = directions[1];
  const Seen whole = seen(bound(table, all), up);
  AirParts parts = all;
  parts.sky_scattering = parts.sky_emission = false;
  Seen part = seen(bound(table, parts), up);
  CHECK(part.sky == 0.0);
  CHECK(part.path == whole.path);
  CHECK(part.beyond == whole.beyond);
  parts = all;
  parts.path_scattering = parts.path_emission = false;
  part = seen(bound(table, parts), up);
  CHECK(part.sky == whole.sky);
  CHECK(part.path == 0.0);
  CHECK(part.beyond == 0.0);
  CHECK(part.left == whole.left);
  parts = all;
  parts.path_transmittance = false;
  part = seen(bound(table, parts), up);
  CHECK(part.left == 1.0);
  CHECK(part.path == whole.path);
  CHECK(part.sky == whole.sky);
}

TEST_CASE("a table made for one origin of light shows what the whole table shows of it",
          "[atmosphere][effect]") {
  const auto whole = made(hazy_job(), {});
  for (const AirParts& parts : {scattering, emission}) {
    const auto own = made(hazy_job(), parts);
    for (const Vec3 up : directions) {
      const Seen expected = seen(bound(whole, parts), up), found = seen(bound(own, all), up);
      CHECK(found.left == Approx(expected.left).epsilon(2e-6));
      // The ground's own emission is there whatever the air was solved for.
      if (parts == emission) {
        CHECK(found.sky == Approx(expected.sky).epsilon(2e-6));
        CHECK(found.path == Approx(expected.path).epsilon(2e-6));
      } else {
        const Seen masked = seen(bound(own, parts), up);
        CHECK(masked.sky == Approx(expected.sky).epsilon(2e-6));
        CHECK(masked.path == Approx(expected.path).epsilon(2e-6));
      }
    }
  }
}

TEST_CASE("only what is wanted of the air is solved for", "[atmosphere][effect]") {
  const auto counted = [](const AirParts& wanted) {
    SolveCounts counts;
    static_cast<void>(made(hazy_job(), wanted, &counts));
    return counts;
  };
  CHECK(counted(all).beam_solves == 1);
  CHECK(counted(all).thermal_solves == 1);
  CHECK(counted(all).sky_solves == 1);
  CHECK(counted(emission).beam_solves == 0);
  CHECK(counted(emission).sky_solves == 0);
  CHECK(counted(emission).thermal_solves == 1);
  CHECK(counted(scattering).beam_solves == 1);
  CHECK(counted(scattering).thermal_solves == 0);
  CHECK(counted(sky_of(true, false)).beam_solves == 1);
  CHECK(counted(AirParts::none()).beam_solves == 0);
  CHECK(counted(AirParts::none()).thermal_solves == 0);
}

TEST_CASE("a table made for nothing but the sun's own light has no views and a dark sky",
          "[atmosphere][effect]") {
  const auto whole = made(hazy_job(), {});
  const auto bare = made(hazy_job(), AirParts::none());
  CHECK(bare->views.empty());
  CHECK(bare->bodies[0].transmittance == whole->bodies[0].transmittance);
  const auto dark = [](const std::vector<float>& v) {
    return std::all_of(v.begin(), v.end(), [](float x) { return x == 0.0F; });
  };
  CHECK(dark(bare->sky.first));
  CHECK(dark(bare->sky.smooth));
  CHECK(dark(bare->sky.even));
  CHECK(dark(bare->sky.ground));
  CHECK(bare->interpolation_error == 0.0);
}

TEST_CASE("a table without a night keeps no room for one", "[atmosphere][effect]") {
  TableJob job = hazy_job();
  job.airglow = job.starlight = job.urban_glow = {0.0};
  const auto table = made(job, {});
  CHECK(table->sky.night.empty());
  CHECK(table->night_ground_irradiance.empty());
  CHECK_FALSE(made(hazy_job(), {})->sky.night.empty());
}

TEST_CASE("before a table without views the sensor sees the sky by its own parts",
          "[atmosphere][effect]") {
  TableJob job = hazy_job();
  job.settings.paths = false;
  const auto table = made(job, {});
  const AirParts only_path{false, false, true, true, true};
  const BoundAirTable air = bound(table, only_path);
  const Vec3 up = directions[0];
  CHECK(air.sky(up)[0] == 0.0F);
  CHECK(air.beyond({}, up)[0] == bound(table, all).sky(up)[0]);
  CHECK(bound(table, sky_of(true, true)).beyond({}, up)[0] == 0.0F);
}

TEST_CASE("uniform air takes its parts from its own figures", "[atmosphere][effect]") {
  const auto curve = [](double v) { return spectral::Curve::constant(v); };
  const Uniform air{curve(0.6), Kelvin{260.0}, curve(0.85),       curve(0.7),
                    curve(0.4), Kelvin{285.0}, SkyShape::overcast};
  const spectral::Lanes lanes{{Micrometres{4.0}}};
  const Vec3 up{0.0, 0.0, 1.0};
  const BoundAtmosphere whole{air, lanes}, one{air, lanes, scattering}, other{air, lanes, emission};
  const auto sky = [&](const BoundAtmosphere& a) { return static_cast<double>(a.sky(up)[0]); };
  CHECK(sky(one) == Approx(0.6 * 9.0 / 7.0).epsilon(1e-6));
  CHECK(sky(one) + sky(other) == Approx(sky(whole)).epsilon(1e-6));
  CHECK(one.path({}, up, 1.0).radiance[0] == 0.4F);
  CHECK(other.even_sky());
  CHECK_FALSE(one.even_sky());
  // What the sun loses on its way to a surface is not the line of sight's.
  const BoundAtmosphere none{air, lanes, AirParts::none()};
  CHECK(none.direct_transmittance(up)[0] == 0.85F);
  CHECK(none.path({}, up, 1.0).transmittance[0] == 1.0F);
  CHECK(none.path({}, up, 1.0).radiance[0] == 0.0F);
  CHECK(none.beyond({}, up)[0] == 0.0F);
}

}  // namespace nadir::atmosphere
