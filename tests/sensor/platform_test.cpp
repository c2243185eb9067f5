#include "sensor/platform/platform.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/random.hpp"
#include "sensor/platform/flight.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace nadir;
using geometry::LocalFrame;
using sensor::Mount;
using sensor::Platform;
using sensor::PlatformDescription;
using sensor::Pose;
using sensor::ScanMount;
using sensor::Track;
using sensor::TrackAttitude;

namespace {

const LocalFrame scene{{45.0, 10.0, 200.0}};

double distance(const Mat3& a, const Mat3& b) {
  return length(a.x - b.x) + length(a.y - b.y) + length(a.z - b.z);
}

Quaternion about(Vec3 axis, double angle_rad) {
  const double s = std::sin(0.5 * angle_rad);
  return {std::cos(0.5 * angle_rad), s * axis.x, s * axis.y, s * axis.z};
}

Mat3 random_axes(Rng& rng) { return rotation(support::random_on_sphere(rng), 6.0 * rng.next()); }

/// A circular orbit of 705 km over the scene, inclined, the earth turning below.
Track low_orbit(double last_s) {
  const Vec3 up = scene.ecef({}) / length(scene.ecef({}));
  const Vec3 along = normalised(cross(up, normalised(Vec3{0.3, -0.2, 0.9})));
  const sensor::PositionLaw law = [=](double t) {
    const double angle = 1.059e-3 * (t - 4.0), earth = -7.292e-5 * t;
    const Vec3 inertial = 7.083e6 * (std::cos(angle) * up + std::sin(angle) * along);
    return rotation({0, 0, 1}, earth) * inertial;
  };
  return sensor::tabulated(law, scene, 0.0, last_s);
}

Track circling() {
  const sensor::CirclingFlight flight{{45.001, 10.0, 600.0}, 150.0, 25.0, 0.0, true};
  return sensor::tabulated([=](double t) { return scene.ecef(scene.enu(place_at(flight, t))); },
                           scene, 0.0, 30.0);
}

/// Largest angle between a platform and the law that it stands for, rad.
double worst_angle(const PlatformDescription& description, const Platform& platform) {
  double worst = 0.0;
  const double span = platform.last_s() - platform.first_s();
  for (int i = 0; i <= 500; ++i) {
    const double t = platform.first_s() + span * std::min(1.0, i * 0.00200007);
    const Mat3 exact = sensor::axes(description.attitude, scene, description.track.at(t), t);
    worst =
        std::max(worst, angle_between(to_quaternion(exact), to_quaternion(platform.at(t).axes)));
  }
  return worst;
}

std::string message_of(const PlatformDescription& description, double first_s, double last_s) {
  try {
    const Platform platform{description, scene, first_s, last_s};
  } catch (const InputError& error) {
    return error.issues().front().message;
  }
  return {};
}

}  // namespace

TEST_CASE("a platform without a description stands still", "[sensor][platform]") {
  Rng rng{111};
  const Pose pose{{1, 2, 3}, random_axes(rng)};
  const Platform platform{pose};
  CHECK(platform.is_fixed());
  for (const double t : {-1e9, 0.0, 1e9}) {
    CHECK(platform.at(t).position == pose.position);
    CHECK(distance(platform.at(t).axes, pose.axes) == 0.0);
  }
  CHECK(platform.shaken(0.0, {3, 3, 3}).position == pose.position);
  CHECK(platform.first_s() < -1e300);
  CHECK(platform.last_s() > 1e300);
}

TEST_CASE("between its steps a platform is within 1e-9 rad of its law", "[sensor][platform]") {
  using Aim = TrackAttitude::Aim;
  const std::vector<sensor::Attitude> laws{
      TrackAttitude{}, TrackAttitude{Aim::velocity, true, 0.1_rad, 0.2_rad, 0.3_rad},
      sensor::LookAtAttitude{{3e4, 4e4, 5}, {}}, sensor::EulerAttitude{0.4_rad, -1.0_rad, {}}};
  for (const sensor::Attitude& law : laws) {
    for (const bool orbits : {true, false}) {
      const PlatformDescription description{orbits ? low_orbit(10.0) : circling(), law, {}, {}};
      const Platform platform{description, scene, 0.0, 10.0};
      CAPTURE(law.index(), orbits);
      CHECK(worst_angle(description, platform) < 1e-9);
      CHECK(length(platform.at(5.4321).position - description.track.at(5.4321).position) < 1e-8);
      CHECK_FALSE(platform.is_fixed());
    }
  }
}

TEST_CASE("the turning of a table at constant rate is exact", "[sensor][platform]") {
  const Vec3 axis = normalised(Vec3{1, -1, 2});
  sensor::TabulatedAttitude table;
  for (int i = 0; i <= 11; ++i) {
    table.times_s.push_back(i * i * 0.1);
    const Quaternion q = about(axis, 0.4 * table.times_s.back());
    table.orientations.push_back(i % 3 == 0 ? q : -q);
  }
  PlatformDescription description;
  description.attitude = table;
  const Platform platform{description, scene, 0.05, 12.0};
  CHECK_FALSE(platform.is_fixed());
  for (double t = 0.05; t < 12.0; t += 0.1234) {
    CHECK(distance(platform.at(t).axes, rotation(axis, 0.4 * t)) < 1e-14);
  }
}

// The rate jumps at an entry of the table: it must be a node, or 0.1 rad/s x step / 8 is lost.
TEST_CASE("a table that turns unevenly is met between all its entries", "[sensor][platform]") {
  Rng rng{112};
  sensor::TabulatedAttitude table;
  for (int i = 0; i < 40; ++i) {
    table.times_s.push_back(0.37 * i + 0.2 * rng.next());
    table.orientations.push_back(about(support::random_on_sphere(rng), 0.3 * rng.next()));
  }
  for (const auto reference : {sensor::Reference::scene, sensor::Reference::orbit}) {
    table.reference = reference;
    PlatformDescription description{low_orbit(16.0), sensor::checked(table), {}, {}};
    const Platform platform{description, scene, 0.25, 14.0};
    // In the scene's axes the table itself is what turns evenly: rounding alone.
    const double bound = reference == sensor::Reference::scene ? 5e-15 : 1e-9;
    CHECK(worst_angle(description, platform) < bound);
    if (reference == sensor::Reference::orbit) continue;
    for (std::size_t i = 1; i + 4 < table.times_s.size(); ++i) {
      const Quaternion found = to_quaternion(platform.at(table.times_s[i]).axes);
      CHECK(angle_between(found, table.orientations[i]) < 5e-15);
    }
  }
}

// North, then east: the line of sight's frame turns at once at the way point, and not before.
TEST_CASE("at a way point the platform turns at once", "[sensor][platform]") {
  const Track track{{0, 2, 4}, {{0, 0, 100}, {0, 20, 100}, {20, 20, 100}}, 2};
  const Platform platform{{track, TrackAttitude{}, {}, {}}, scene, 0.0, 4.0};
  // 1e-5: the scene's horizontal plane and the platform's differ by 30 m / R.
  CHECK(length(platform.at(1.9999999).axes.y - Vec3{0, 1, 0}) < 1e-5);
  CHECK(length(platform.at(2.0000001).axes.y - Vec3{1, 0, 0}) < 1e-5);
  CHECK(length(platform.at(2.0).axes.y - Vec3{1, 0, 0}) < 1e-5);
  CHECK(length(platform.at(4.0).axes.y - Vec3{1, 0, 0}) < 1e-5);
}

// Straight over the target the image's top, as high as it goes, changes sides; for the 10
// microseconds between, within 1e-6 rad of the vertical, it is north (look_at).
TEST_CASE("a law that jumps between the moments of its track is found to a microsecond",
          "[sensor][platform]") {
  const Track track{{-10, 10}, {{-1000, 0, 500}, {1000, 0, 500}}, 2};
  const PlatformDescription description{track, sensor::LookAtAttitude{{0, 0, 0}, {}}, {}, {}};
  const Platform platform{description, scene, -10.0, 10.0};
  for (const double t : {-1e-4, -8e-6, 0.0, 8e-6, 1e-4, 3.0}) {
    const Mat3 exact = sensor::axes(description.attitude, scene, track.at(t), t);
    CHECK(distance(platform.at(t).axes, exact) < 3e-9);
  }
}

TEST_CASE("mounts follow one another from the platform outwards", "[sensor][platform]") {
  Rng rng{113};
  PlatformDescription description{low_orbit(10.0), TrackAttitude{}, {}, {}};
  const Platform bare{description, scene, 0.0, 10.0};
  description.mounts = {{{1, 2, 3}, random_axes(rng)},
                        {{0, 0, 2}, random_axes(rng)},
                        {{0, 1, 0},
                         random_axes(rng),
                         ScanMount{ScanMount::Motion::sweep, {1, 0, 0}, -0.3, 0.3, 0, 2, 2}},
                        {{3, 0, 0}, random_axes(rng), sensor::StareMount{{50, 60, 7}}},
                        {{3, 1, 0}, random_axes(rng)}};
  const Platform platform{description, scene, 0.0, 10.0};
  for (const double t : {0.0, 3.3, 9.9}) {
    Pose pose = bare.at(t);
    for (const Mount& mount : description.mounts) pose = sensor::carried(pose, mount, t);
    CHECK(length(platform.at(t).position - pose.position) < 5e-8);  // 10 m x 1e-9 rad, 1 nm
    CHECK(distance(platform.at(t).axes, pose.axes) < 4e-9);
  }
}

TEST_CASE("what stands still costs nothing, whatever it stands on", "[sensor][platform]") {
  Rng rng{114};
  PlatformDescription description;
  description.track = Track{Vec3{1, 2, 300}};
  description.attitude = sensor::EulerAttitude{0.4_rad, -1.0_rad, 0.1_rad};
  description.mounts = {{{1, 2, 3}, random_axes(rng)},
                        {{3, 0, 0}, random_axes(rng), sensor::StareMount{{50, 60, 7}}},
                        {{3, 1, 0}, random_axes(rng)}};
  const Platform platform{description, scene, -5.0, 10.0};
  CHECK(platform.is_fixed());
  Pose pose{{1, 2, 300}, sensor::axes(description.attitude, scene, {{1, 2, 300}, {}}, 0.0)};
  for (const Mount& mount : description.mounts) pose = sensor::carried(pose, mount, 0.0);
  CHECK(length(platform.at(3.0).position - pose.position) < 1e-12);
  CHECK(distance(platform.at(3.0).axes, pose.axes) < 1e-14);

  description.mounts[0].law = ScanMount{};
  CHECK_FALSE(Platform{description, scene, 0.0, 1.0}.is_fixed());
  description.mounts.clear();
  description.jitter.white_rms_rad.x = 1e-6;
  CHECK_FALSE(Platform{description, scene, 0.0, 1.0}.is_fixed());
}

TEST_CASE("jitter turns the camera about its own axes", "[sensor][platform]") {
  PlatformDescription description;
  description.attitude = sensor::EulerAttitude{0.4_rad, -1.0_rad, 0.1_rad};
  description.jitter.white_rms_rad = {1e-5, 2e-5, 3e-5};
  description.jitter.spectra[0] = {{1.0, 20.0}, {1e-12, 1e-12}};
  const Platform platform{description, scene, 0.0, 2.0};
  CHECK(platform.has_white_jitter());
  const double t = 1.234;
  const Mat3 still = platform.steady(t).axes;
  const double coloured = platform.jitter().angles_rad(t).x;
  REQUIRE(std::abs(coloured) > 1e-8);
  // 1e-13: what the cubes and squares of angles of 1e-5 leave, and rounding.
  CHECK(distance(platform.at(t).axes, still * rotation({1, 0, 0}, coloured)) < 1e-14);
  const Vec3 normal{0.5, -1.5, 2.0};
  const Vec3 angles{coloured + 0.5e-5, -3e-5, 6e-5};
  const Mat3 exact = still * rotation(normalised(angles), length(angles));
  CHECK(distance(platform.shaken(t, normal).axes, exact) < 2e-13);
  CHECK(distance(platform.steady(0.1).axes, still) == 0.0);
}

TEST_CASE("one moment is a span", "[sensor][platform]") {
  const PlatformDescription description{low_orbit(10.0), TrackAttitude{}, {}, {}};
  const Platform platform{description, scene, 3.0, 3.0};
  const auto state = description.track.at(3.0);
  CHECK(length(platform.at(3.0).position - state.position) < 1e-8);
  CHECK(distance(platform.at(3.0).axes, sensor::axes(TrackAttitude{}, scene, state, 3.0)) < 1e-14);
}

TEST_CASE("what does not cover the span, or means nothing there, is refused",
          "[sensor][platform]") {
  const Track track{{0, 2, 4}, {{0, 0, 100}, {0, 20, 100}, {20, 20, 100}}, 2};
  PlatformDescription description{track, TrackAttitude{}, {}, {}};
  CHECK(message_of(description, 1.0, 4.5) ==
        "the platform's track runs from 0 to 4 s, but the images need 1 to 4.5 s");
  CHECK(message_of(description, -0.5, 3.0) ==
        "the platform's track runs from 0 to 4 s, but the images need -0.5 to 3 s");
  CHECK(message_of(description, 3.0, 2.0) ==
        "the span of a platform must be finite and not end before it begins");
  description.attitude = sensor::TabulatedAttitude{sensor::Reference::scene, {1, 2}, {{}, {}}};
  CHECK(message_of(description, 0.0, 2.0) ==
        "the table of attitudes runs from 1 to 2 s, but the images need 0 to 2 s");
  CHECK(message_of(description, 1.0, 2.0 + 1e-10).empty());
  description = {Track{Vec3{0, 0, 100}}, TrackAttitude{}, {}, {}};
  CHECK(message_of(description, 0.0, 1.0) == "the platform stands still: no way to follow");
  description.attitude = sensor::LookAtAttitude{{0, 0, 100}, {}};
  CHECK(message_of(description, 0.0, 1.0) == "the camera looks at its own position");
  description.attitude = sensor::EulerAttitude{};
  description.mounts = {{{}, scaling({1, 1, -1})}};
  CHECK(message_of(description, 0.0, 1.0) ==
        "the axes of a mount must be orthonormal and right-handed");
}
