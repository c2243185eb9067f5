#include "sensor/platform/mount.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace nadir;
using sensor::Mount;
using sensor::Pose;
using sensor::ScanMount;

namespace {

double distance(const Mat3& a, const Mat3& b) {
  return length(a.x - b.x) + length(a.y - b.y) + length(a.z - b.z);
}

Mat3 random_axes(Rng& rng) { return rotation(support::random_on_sphere(rng), 6.0 * rng.next()); }

std::string message_of(const Mount& mount) {
  try {
    sensor::check(mount);
  } catch (const InputError& error) {
    return error.issues().front().message;
  }
  return {};
}

}  // namespace

TEST_CASE("a chain of mounts is the product of their placements", "[sensor][mount]") {
  Rng rng{101};
  Pose pose{{10, 20, 30}, random_axes(rng)};
  Affine chain{pose.axes, pose.position};
  for (int i = 0; i < 4; ++i) {
    const Mount mount{3.0 * support::random_on_sphere(rng), random_axes(rng)};
    pose = sensor::carried(pose, mount, 0.0);
    chain = chain * Affine{mount.axes, mount.offset_m};
  }
  CHECK(length(pose.position - chain.origin) < 1e-14);
  CHECK(distance(pose.axes, chain.linear) < 1e-14);
}

TEST_CASE("a sweep goes on at constant rate, jumps back and waits", "[sensor][mount]") {
  const ScanMount scan{ScanMount::Motion::sweep, {1, 0, 0}, -0.5, 0.5, 10.0, 2.0, 3.0};
  for (const double periods : {-7.0, 0.0, 4.0}) {
    const double start = 10.0 + 3.0 * periods;
    CHECK(sensor::scan_angle(scan, start) == Approx(-0.5).epsilon(1e-12));
    CHECK(sensor::scan_angle(scan, start + 0.5) == Approx(-0.25).epsilon(1e-12));
    CHECK(sensor::scan_angle(scan, start + 2.0) == Approx(0.5).epsilon(1e-12));
    CHECK(sensor::scan_angle(scan, start + 2.1) == -0.5);
    CHECK(sensor::scan_angle(scan, start + 2.9) == -0.5);
  }
}

TEST_CASE("a swing goes to and fro and waits where it has come to", "[sensor][mount]") {
  const ScanMount scan{ScanMount::Motion::swing, {1, 0, 0}, 0.1, 0.5, 1.0, 2.0, 3.0};
  for (const double turns : {-3.0, 0.0, 5.0}) {
    const double start = 1.0 + 6.0 * turns;
    CHECK(sensor::scan_angle(scan, start) == Approx(0.1).epsilon(1e-12));
    CHECK(sensor::scan_angle(scan, start + 1.0) == Approx(0.3).epsilon(1e-12));
    CHECK(sensor::scan_angle(scan, start + 2.5) == Approx(0.5).epsilon(1e-12));
    CHECK(sensor::scan_angle(scan, start + 3.5) == Approx(0.4).epsilon(1e-12));
    CHECK(sensor::scan_angle(scan, start + 5.5) == Approx(0.1).epsilon(1e-12));
  }
}

TEST_CASE("a scanning mount turns right-handed about its own axis", "[sensor][mount]") {
  Mount mount;
  mount.axes = rotation({0, 0, 1}, 1.0);
  mount.law = ScanMount{ScanMount::Motion::sweep, {0, 1, 0}, 0.0, 1.0, 0.0, 1.0, 1.0};
  const Mat3 a = sensor::carried({}, mount, 0.25).axes;
  CHECK(distance(a, mount.axes * rotation({0, 1, 0}, 0.25)) < 1e-15);
  CHECK(dot(a.z, mount.axes.x) == Approx(std::sin(0.25)).epsilon(1e-14));  // z goes towards x
}

TEST_CASE("a stare has its target in the middle and turns as little as it can", "[sensor][mount]") {
  Rng rng{102};
  for (int i = 0; i < 100; ++i) {
    const Pose carrier{100.0 * support::random_on_sphere(rng), random_axes(rng)};
    const Vec3 target = 500.0 * support::random_on_sphere(rng);
    const Mount mount{{1, 2, 3}, random_axes(rng), sensor::StareMount{target}};
    const Pose pose = sensor::carried(carrier, mount, 0.0);
    CHECK(length(cross(pose.axes.z, normalised(target - pose.position))) < 1e-15);
    CHECK(dot(pose.axes.z, target - pose.position) > 0.0);
    CHECK(distance(pose.axes.transposed() * pose.axes, Mat3{}) < 1e-14);
    CHECK(pose.axes.determinant() == Approx(1.0).epsilon(1e-14));
    // x, its rest and the line of sight lie in a plane, x on the side of its rest: no turn about z
    // brings it nearer.
    const Vec3 rest_x = (carrier.axes * mount.axes).x;
    CHECK(dot(pose.axes.y, rest_x) == Approx(0.0).margin(1e-14));
    CHECK(dot(pose.axes.x, rest_x) > 0.0);
  }
}

TEST_CASE("a stare along its own x axis, or at itself, has axes all the same", "[sensor][mount]") {
  for (const Vec3 target : {Vec3{5, 0, 0}, Vec3{-5, 0, 0}, Vec3{}}) {
    const Pose pose = sensor::carried({}, {{}, {}, sensor::StareMount{target}}, 0.0);
    CHECK(distance(pose.axes.transposed() * pose.axes, Mat3{}) < 1e-15);
    CHECK(pose.axes.determinant() == Approx(1.0).epsilon(1e-15));
    CHECK(length(cross(pose.axes.z, target)) == 0.0);
  }
}

TEST_CASE("mounts that are none are refused", "[sensor][mount]") {
  Mount mount;
  CHECK(message_of(mount).empty());
  mount.axes = scaling({1, 1, -1});
  CHECK(message_of(mount) == "the axes of a mount must be orthonormal and right-handed");
  mount.axes = scaling({1, 1, 1.01});
  CHECK(message_of(mount) == "the axes of a mount must be orthonormal and right-handed");
  mount.axes = {};
  mount.offset_m.y = std::nan("");
  CHECK(message_of(mount) == "the offset of a mount must be finite");
  ScanMount scan;
  scan.axis = {1, 1, 0};
  CHECK(message_of({{}, {}, scan}) == "the axis of a scanning mount must be of length 1");
  scan = {};
  scan.sweep_s = 0.0;
  CHECK(message_of({{}, {}, scan}) ==
        "the sweep of a scanning mount must take more than 0 s, not 0 s");
  scan.sweep_s = 1.5;
  CHECK(message_of({{}, {}, scan}) ==
        "the period of a scanning mount, 1 s, is shorter than its sweep, 1.5 s");
  CHECK(message_of({{}, {}, sensor::StareMount{{std::nan(""), 0, 0}}}) ==
        "the target of a mount must be finite");
}
