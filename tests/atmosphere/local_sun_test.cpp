#include <array>
#include <cmath>

#include "atmosphere/hand_made_air.hpp"
#include "atmosphere/make/local_body.hpp"
#include "atmosphere/synthetic_air.hpp"
#include "support/catch.hpp"

namespace nadir::atmosphere::test {
namespace {

constexpr double range_m = 1200e3, top_m = 100e3, scale_m = 8e3;

/// A camera in space north of the scene, at an elevation over it.
struct Camera {
  double elevation_deg = 30.0;
  [[nodiscard]] Vec3 towards() const {
    return {0.0, std::cos(elevation_deg * degree), std::sin(elevation_deg * degree)};
  }
};

TableJob job_under(const HandMadeAir& air, double sun_deg, double sun_azimuth_deg) {
  TableJob job = job_of(air, 0.55);
  job.bodies = {body_at(sun_deg, sun_azimuth_deg)};
  job.settings.streams = 4;
  job.settings.zenith_nodes = 24;
  job.settings.share_nodes = 8;
  job.settings.azimuth_nodes = 5;
  return job;
}

/// What the air adds to a black scene.
double seen(const HandMadeAir& air, double sun_deg, double sun_azimuth_deg, Camera camera) {
  const BoundAirTable table = bound(filled_table(job_under(air, sun_deg, sun_azimuth_deg)));
  const Vec3 to = camera.towards();
  return static_cast<double>(table.path(to * range_m, to * -1.0, range_m).radiance[0]);
}

double height_m(Vec3 p) { return std::hypot(p.x, p.y, p.z + earth_radius_m) - earth_radius_m; }

/// Way from a place in the air to its top.
double way_out_m(Vec3 p, Vec3 direction) {
  const Vec3 from_centre{p.x, p.y, p.z + earth_radius_m};
  const double b = dot(from_centre, direction), r = earth_radius_m + top_m;
  return -b + std::sqrt(b * b - dot(from_centre, from_centre) + r * r);
}

/// int exp(-h / 8 km) ds out of the air: closer steps near the start; or the earth is in the way.
double air_m(Vec3 p, Vec3 direction) {
  constexpr int count = 300;
  const double way = way_out_m(p, direction);
  double sum = 0.0, before = std::exp(-height_m(p) / scale_m), at = 0.0;
  for (int i = 1; i <= count; ++i) {
    const double x = static_cast<double>(i) / count, next = way * x * x;
    const double h = height_m(p + direction * next);
    if (h < -1e-3) return 1e12;
    const double density = std::exp(-h / scale_m);
    sum += 0.5 * (density + before) * (next - at);
    before = density;
    at = next;
  }
  return sum;
}

/// Light scattered once, by a plain sum along the straight way through exponential air in the
/// scene's axes, with one direction to the sun for all of it.
double scattered_once(const HandMadeAir& air, double sun_deg, double sun_azimuth_deg,
                      Camera camera) {
  constexpr int count = 300;
  const Vec3 to = camera.towards(), sun = body_at(sun_deg, sun_azimuth_deg).direction_enu;
  const double per_m = (air.rayleigh + air.absorption) / scale_m;
  const double way = way_out_m({}, to), whole = air_m({}, to);
  double sum = 0.0, before = 0.0, at = 0.0, behind = 0.0, density = 1.0;
  for (int i = 0; i <= count; ++i) {
    const double x = static_cast<double>(i) / count, next = way * x * std::sqrt(x);
    const Vec3 p = to * next;
    const double here = std::exp(-height_m(p) / scale_m);
    behind += 0.5 * (density + here) * (next - at);
    const double left = std::exp(-per_m * (air_m(p, sun) + whole - behind));
    if (i > 0) sum += 0.5 * (before + here * left) * (next - at);
    before = here * left;
    density = here;
    at = next;
  }
  return sum * air.rayleigh / scale_m * PhaseFunction::rayleigh(0.0).at(-dot(to, sun));
}

}  // namespace

TEST_CASE("Seen from space, a low sun stands over what is looked at", "[atmosphere][sun]") {
  // Air that absorbs most of what it takes: light scattered again is below 1 %. Not lower than -2
  // degrees, where the table makes up twilight.
  const HandMadeAir air{.rayleigh = 0.002, .absorption = 0.1};
  const Camera camera{GENERATE(15.0, 30.0)};
  const double sun_deg = GENERATE(-1.5, 3.0, 8.0, 13.0);
  CAPTURE(camera.elevation_deg, sun_deg);
  const double on = seen(air, sun_deg, 0.0, camera), off = seen(air, sun_deg, 180.0, camera);
  const double on_once = scattered_once(air, sun_deg, 0.0, camera);
  const double off_once = scattered_once(air, sun_deg, 180.0, camera);
  // Shells, and steps of 0.5 degrees in local height. With the sun over the way into the air the
  // ratio would be 0.7 of it at 30 degrees, sun at 3.
  CHECK(on / off == Approx(on_once / off_once).epsilon(0.02));
  CHECK(on == Approx(on_once).epsilon(0.03));
}

TEST_CASE("From space no light jumps as a sun rises out of the low ones", "[atmosphere][sun]") {
  const HandMadeAir air{.rayleigh = 0.2, .haze = 0.2};
  const Camera camera{15.0};
  const double azimuth_deg = GENERATE(0.0, 180.0);
  // Around mu0 = 0.2 and 0.25, where local heights begin to give way and have.
  for (const double middle : {11.537, 14.478}) {
    const double below = seen(air, middle - 0.01, azimuth_deg, camera);
    const double above = seen(air, middle + 0.01, azimuth_deg, camera);
    CAPTURE(azimuth_deg, middle);
    // 0.02 degrees are worth 0.1 %; the two treatments differ by 0.5 %.
    CHECK(above == Approx(below).epsilon(0.002));
  }
}

TEST_CASE("The local height of a low body gives way smoothly", "[atmosphere][sun]") {
  CHECK(local_share(-0.1) == 1.0);
  CHECK(local_share(0.2) == 1.0);
  CHECK(local_share(0.225) == Approx(0.5).epsilon(1e-12));
  CHECK(local_share(0.25) == 0.0);
}

TEST_CASE("A path's anchor is what is looked at from space, else the eye", "[atmosphere][sun]") {
  const Shells shells{HandMadeAir::levels_m(), DirectionGrid{4}};
  const double horizon = std::acos(horizon_mu(0.0, top_m));
  const auto path = [&](double eye_m, double zenith, Side side) {
    return view_path(shells, eye_m, zenith, side, {0.0, 1.0});
  };
  const ViewPath down = path(top_m, 150.0 * degree, Side::below);
  // Law of sines: r sin(z) is the same at both ends.
  const double end =
      std::asin((earth_radius_m + top_m) / earth_radius_m * std::sin(150.0 * degree));
  CHECK(down.anchor_rad == Approx(150.0 * degree - (std::numbers::pi - end)).epsilon(1e-9));
  CHECK(down.start.away == Approx(-std::sin(down.anchor_rad)).epsilon(1e-9));
  CHECK(down.steps.back().out.away == Approx(0.0).margin(1e-9));
  CHECK(down.steps.back().out.up == Approx(1.0).epsilon(1e-12));
  // On either side of the horizon the same place; past it the lowest point, where the way is level.
  CHECK(path(top_m, horizon, Side::below).anchor_rad ==
        Approx(path(top_m, horizon, Side::above).anchor_rad).epsilon(1e-3));
  CHECK(path(top_m, 95.0 * degree, Side::above).scene_zenith_rad() ==
        Approx(90.0 * degree).epsilon(1e-12));
  CHECK(path(10e3, 120.0 * degree, Side::below).anchor_rad == 0.0);
  CHECK(path(0.0, 60.0 * degree, Side::above).anchor_rad == 0.0);
}

}  // namespace nadir::atmosphere::test
