#include "sensor/platform/attitude.hpp"

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/random.hpp"
#include "sensor/orbit/earth_frames.hpp"
#include "sensor/platform/pose.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace nadir;
using geometry::LocalFrame;
using sensor::Attitude;
using sensor::TrackAttitude;
using sensor::TrackState;

namespace {

// Above the equator the scene's axes are those of the place below a platform at (0, 0, h).
const LocalFrame equator{{0.0, 30.0, 0.0}};
const TrackState northwards{{0, 0, 7e5}, {0, 7000, 0}};

double distance(const Mat3& a, const Mat3& b) {
  return length(a.x - b.x) + length(a.y - b.y) + length(a.z - b.z);
}

TrackState random_state(Rng& rng) {
  return {1e5 * support::random_on_sphere(rng) + Vec3{0, 0, 2e5 + 5e5 * rng.next()},
          7000.0 * support::random_on_sphere(rng)};
}

Quaternion about(Vec3 axis, double angle_rad) {
  const double s = std::sin(0.5 * angle_rad);
  return {std::cos(0.5 * angle_rad), s * axis.x, s * axis.y, s * axis.z};
}

sensor::TabulatedAttitude constant_table(sensor::Reference reference, const Quaternion& q) {
  return {reference, {0.0}, {q}};
}

std::vector<Attitude> every_law() {
  using Aim = TrackAttitude::Aim;
  std::vector<Attitude> laws{
      sensor::EulerAttitude{0.3_rad, -1.2_rad, 0.4_rad},
      sensor::LookAtAttitude{{100, -200, 3}, 0.7_rad},
      TrackAttitude{},
      TrackAttitude{Aim::nadir, true, 0.1_rad, 0.2_rad, -0.3_rad},
      TrackAttitude{Aim::velocity, false, 0.0_rad, 0.1_rad, 0.0_rad},
      TrackAttitude{Aim::velocity, true},
  };
  using sensor::Reference;
  for (const auto reference :
       {Reference::scene, Reference::earth, Reference::local, Reference::orbit}) {
    laws.emplace_back(constant_table(reference, about(normalised(Vec3{1, 2, 3}), 0.9)));
  }
  return laws;
}

std::string message_of(const Attitude& attitude) {
  try {
    (void)sensor::checked(attitude);
  } catch (const InputError& error) {
    return error.issues().front().message;
  }
  return {};
}

std::string message_of(const Attitude& attitude, const TrackState& state, double time_s) {
  try {
    (void)sensor::axes(sensor::checked(attitude), equator, state, time_s);
  } catch (const InputError& error) {
    return error.issues().front().message;
  }
  return {};
}

}  // namespace

// Products of up to five rotations, each entry rounded a few times: 1e-14.
TEST_CASE("the axes of every law are orthonormal and right-handed", "[sensor][attitude]") {
  Rng rng{91};
  const LocalFrame frame{{51.0, -114.0, 1100.0}};
  for (const Attitude& law : every_law()) {
    for (int i = 0; i < 20; ++i) {
      const Mat3 a = sensor::axes(sensor::checked(law), frame, random_state(rng), 0.0);
      CAPTURE(law.index());
      CHECK(distance(a.transposed() * a, Mat3{}) < 1e-14);
      CHECK(a.determinant() == Approx(1.0).epsilon(1e-14));
    }
  }
}

TEST_CASE("the nadir attitude looks down, lines run ahead, samples to the left",
          "[sensor][attitude]") {
  const Mat3 a = sensor::axes(TrackAttitude{}, equator, northwards, 0.0);
  CHECK(length(a.z - Vec3{0, 0, -1}) < 1e-15);
  CHECK(length(a.y - Vec3{0, 1, 0}) < 1e-15);
  CHECK(length(a.x - Vec3{-1, 0, 0}) < 1e-15);  // west
  // Southwards, as morning orbits come over land: samples to the east, a picture with north up.
  const Mat3 b = sensor::axes(TrackAttitude{}, equator, {{0, 0, 7e5}, {0, -7000, 0}}, 0.0);
  CHECK(length(b.x - Vec3{1, 0, 0}) < 1e-15);
  // Climbing leaves z down and y level.
  const Mat3 c = sensor::axes(TrackAttitude{}, equator, {{0, 0, 7e5}, {0, 70, 30}}, 0.0);
  CHECK(distance(a, c) < 1e-15);
}

TEST_CASE("yaw turns right, pitch ahead, roll to the right of the way", "[sensor][attitude]") {
  const double s = std::sin(0.2), c = std::cos(0.2);
  TrackAttitude yaw, pitch, roll;
  yaw.yaw = pitch.pitch = roll.roll = 0.2_rad;
  const Mat3 yawed = sensor::axes(yaw, equator, northwards, 0.0);
  CHECK(length(yawed.y - Vec3{s, c, 0}) < 1e-15);  // north goes towards east
  CHECK(length(yawed.z - Vec3{0, 0, -1}) < 1e-15);
  const Mat3 pitched = sensor::axes(pitch, equator, northwards, 0.0);
  CHECK(length(pitched.z - Vec3{0, s, -c}) < 1e-15);
  CHECK(length(pitched.x - Vec3{-1, 0, 0}) < 1e-15);
  const Mat3 rolled = sensor::axes(roll, equator, northwards, 0.0);
  CHECK(length(rolled.z - Vec3{s, 0, -c}) < 1e-15);  // east is right of north
  CHECK(length(rolled.y - Vec3{0, 1, 0}) < 1e-15);
  // Each about the axes that the former leave: after a yaw of 90 degrees, pitch raises to the east.
  TrackAttitude both;
  both.yaw = 90.0_deg;
  both.pitch = 0.2_rad;
  CHECK(length(sensor::axes(both, equator, northwards, 0.0).z - Vec3{s, 0, -c}) < 1e-15);
}

TEST_CASE("a ray along nadir meets the ellipsoid below", "[sensor][attitude]") {
  Rng rng{92};
  const LocalFrame frame{{51.0, -114.0, 1100.0}};
  for (int i = 0; i < 50; ++i) {
    const TrackState state = random_state(rng);
    const Mat3 a = sensor::axes(TrackAttitude{}, frame, state, 0.0);
    geometry::Geodetic below = frame.geodetic(state.position);
    const double height_m = below.height_m;
    below.height_m = 0.0;
    // 700 km times a few roundings, and GeographicLib's nanometres.
    CHECK(length(state.position + a.z * height_m - frame.enu(below)) < 1e-8);
    CHECK(std::abs(dot(cross(a.y, normalised(state.velocity)), a.x)) < 1.0);
    CHECK(dot(a.y, state.velocity) > 0.0);
    CHECK(dot(a.x, state.velocity) == Approx(0.0).margin(1e-10));
  }
}

TEST_CASE("the velocity attitude keeps y on the way and z as low as it goes",
          "[sensor][attitude]") {
  const Mat3 a = sensor::axes(TrackAttitude{TrackAttitude::Aim::velocity}, equator,
                              {{0, 0, 1000}, {0, 40, 30}}, 0.0);
  CHECK(length(a.y - Vec3{0, 0.8, 0.6}) < 1e-15);
  CHECK(length(a.z - Vec3{0, 0.6, -0.8}) < 1e-15);
  CHECK(length(a.x - Vec3{-1, 0, 0}) < 1e-15);
}

// Eastwards the earth moves by omega (a + h) at the equator; 6378137 m is WGS84's a.
TEST_CASE("the inertial way adds the turning of the earth", "[sensor][attitude]") {
  const double east_m_s = sensor::earth_rate_rad_s * (6378137.0 + 7e5);
  const double angle = std::atan2(east_m_s, 7000.0);
  for (const auto aim : {TrackAttitude::Aim::nadir, TrackAttitude::Aim::velocity}) {
    const Mat3 a = sensor::axes(TrackAttitude{aim, true}, equator, northwards, 0.0);
    CHECK(length(a.y - Vec3{std::sin(angle), std::cos(angle), 0}) < 1e-14);
    CHECK(length(a.z - Vec3{0, 0, -1}) < 1e-14);
  }
}

TEST_CASE("an attitude that looks at a target has it in the middle", "[sensor][attitude]") {
  Rng rng{93};
  const sensor::LookAtAttitude law{{100, -200, 3}, 0.7_rad};
  for (int i = 0; i < 50; ++i) {
    const TrackState state = random_state(rng);
    const Mat3 a = sensor::axes(law, equator, state, 0.0);
    CHECK(length(cross(a.z, normalised(law.target - state.position))) < 1e-15);
    CHECK(dot(a.z, law.target - state.position) > 0.0);
  }
}

TEST_CASE("angles count about the platform's own east, north and up", "[sensor][attitude]") {
  const LocalFrame frame{{40.0, 10.0, 0.0}};
  const geometry::Geodetic far{47.0, 25.0, 9000.0};
  const TrackState state{frame.enu(far), {}};
  const sensor::EulerAttitude law{90.0_deg, -20.0_deg, 0.0_deg};
  const Mat3 local = frame.axes_at(far);
  const Mat3 a = sensor::axes(law, frame, state, 0.0);
  const double c = std::cos(degrees(20.0).value), s = std::sin(degrees(20.0).value);
  // 1e-14: the place comes back from its cartesian coordinates.
  CHECK(length(a.z - local * Vec3{c, 0, -s}) < 1e-14);  // eastwards, 20 degrees down
  CHECK(length(a.x - local * Vec3{0, -1, 0}) < 1e-14);  // right of east is south
}

TEST_CASE("orientations are given in any of the references", "[sensor][attitude]") {
  Rng rng{94};
  const LocalFrame frame{{51.0, -114.0, 1100.0}};
  const TrackState state = random_state(rng);
  const Quaternion q = about(support::random_on_sphere(rng), 1.3);
  const auto found = [&](sensor::Reference reference) {
    return sensor::axes(constant_table(reference, q), frame, state, 17.0) *
           to_matrix(q).transposed();
  };
  using sensor::Reference;
  CHECK(distance(found(Reference::scene), Mat3{}) < 1e-14);
  CHECK(distance(found(Reference::local), frame.axes_at(frame.geodetic(state.position))) < 1e-14);
  CHECK(distance(found(Reference::orbit), sensor::axes(TrackAttitude{}, frame, state, 0)) < 1e-14);
  // The earth's axes by differences of places: 1e-9 m of 1e7.
  const Mat3 earth = found(Reference::earth);
  const Vec3 zero = frame.enu_from_ecef({});
  CHECK(length(earth.x - (frame.enu_from_ecef({1e7, 0, 0}) - zero) / 1e7) < 1e-15 * 2);
  CHECK(length(earth.y - (frame.enu_from_ecef({0, 1e7, 0}) - zero) / 1e7) < 1e-15 * 2);
  CHECK(length(earth.z - (frame.enu_from_ecef({0, 0, 1e7}) - zero) / 1e7) < 1e-15 * 2);
}

TEST_CASE("between the entries of a table it turns evenly, whatever their signs",
          "[sensor][attitude]") {
  const Vec3 axis = normalised(Vec3{1, -1, 2});
  sensor::TabulatedAttitude table;
  for (int i = 0; i <= 20; ++i) {
    table.times_s.push_back(i * i * 0.1);
    const Quaternion q = about(axis, 0.4 * table.times_s.back());
    table.orientations.push_back(i % 3 == 0 ? q : -q);
  }
  table.times_s.resize(12);
  table.orientations.resize(12);
  const Attitude law = sensor::checked(table);
  for (double t = 0.0; t < table.times_s.back(); t += 0.1234) {
    CHECK(distance(sensor::axes(law, equator, northwards, t), rotation(axis, 0.4 * t)) < 1e-14);
  }
}

TEST_CASE("tables that are none are refused", "[sensor][attitude]") {
  using sensor::TabulatedAttitude;
  const auto scene = sensor::Reference::scene;
  const Quaternion one;
  CHECK(message_of(TabulatedAttitude{}) == "the table of attitudes is empty");
  CHECK(message_of(TabulatedAttitude{scene, {0, 1}, {one}}) ==
        "the table of attitudes has 2 times but 1 quaternions");
  CHECK(message_of(TabulatedAttitude{scene, {1, 1}, {one, one}}) ==
        "the times of the table of attitudes must ascend: 1 s follows 1 s");
  CHECK(message_of(TabulatedAttitude{scene, {std::nan("")}, {one}}) ==
        "time 1 of the table of attitudes is not finite");
  CHECK(message_of(TabulatedAttitude{scene, {0.0}, {{1, 0.5, 0, 0}}}) ==
        "quaternion 1 of the table of attitudes has length 1.118033988749895, not 1");
  CHECK(message_of(TabulatedAttitude{scene, {0, 2.5}, {one, about({1, 0, 0}, 1.6)}}) ==
        "the table of attitudes has a gap: it turns by 92 degrees between 0 and 2.5 s, more than "
        "90");
  CHECK(message_of(TabulatedAttitude{scene, {0, 2.5}, {one, about({1, 0, 0}, 1.57)}}).empty());
  CHECK(message_of(sensor::EulerAttitude{Angle{std::nan("")}, {}, {}}) ==
        "the angles of an attitude must be finite");
}

TEST_CASE("where a law means nothing it says so", "[sensor][attitude]") {
  const TrackState stands{{0, 0, 100}, {}}, climbs{{0, 0, 100}, {0, 0, 5}};
  const TrackAttitude nadir, velocity{TrackAttitude::Aim::velocity};
  CHECK(message_of(nadir, stands, 0) == "the platform stands still: no way to follow");
  CHECK(message_of(nadir, climbs, 0) == "the platform moves straight up or down: no way to follow");
  CHECK(message_of(velocity, climbs, 0) ==
        "the platform moves straight up or down: no side is down");
  CHECK(message_of(sensor::LookAtAttitude{{0, 0, 100}, {}}, stands, 0) ==
        "the camera looks at its own position");
  const sensor::TabulatedAttitude table{sensor::Reference::scene, {0, 1}, {{}, {}}};
  CHECK(message_of(table, stands, 1.5) ==
        "the table of attitudes runs from 0 to 1 s, not to 1.5 s");
  CHECK(message_of(table, stands, 1.0).empty());
}
