// What a path's way out of the camera costs, from a plain camera that stands still to a pushbroom
// on an orbit; and what finding a place in the image costs.
//
//     camera_rays
//
// Prints nanoseconds a call. "arithmetic alone" is what a plain pinhole needs at least: one point
// of the sampler, a turn, a square root.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "sensor/camera/projection.hpp"

using namespace nadir;
using namespace nadir::sensor;

namespace {

template <class Call>
void report(const std::string& name, int calls, const Call& call) {
  double best = 1e300, sum = 0.0;
  for (int round = 0; round < 5; ++round) {
    const std::clock_t start = std::clock();  // processor time: other programs do not count
    for (int i = 0; i < calls; ++i) sum += call(static_cast<std::uint32_t>(i));
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    best = std::min(best, 1e9 * seconds / calls);
  }
  // The sum keeps the compiler from leaving the calls out.
  std::printf("%-44s %8.1f ns   %c\n", name.c_str(), best, sum == 0.123 ? '!' : ' ');
}

double first_of(const geometry::Ray& ray) { return ray.direction.x + ray.origin.z; }

DetectorArray frame() { return {"a", 1000, 1000, Perspective{0.1}, 1e-5, 0.0, 0.0, {}}; }

Platform orbit() {
  std::vector<double> times;
  std::vector<Vec3> places;
  TabulatedAttitude turning;
  for (int i = -60; i <= 60; ++i) {
    const double angle = 1.06e-3 * i;
    const Vec3 up{0.0, std::sin(angle), std::cos(angle)}, way{0.0, up.z, -up.y};
    times.push_back(i);
    places.push_back(7.083e6 * up);
    turning.orientations.push_back(to_quaternion(Mat3{cross(way, -up), way, -up}));
  }
  turning.times_s = times;
  PlatformDescription description;
  description.track = Track{times, places};
  description.attitude = turning;
  return Platform{description, geometry::LocalFrame{{0.0, 0.0, 0.0}}, -20.0, 20.0};
}

void report_paths(const std::string& name, const DetectorArray& array, const Platform& platform) {
  report(name, 1'000'000, [&](std::uint32_t i) {
    const int sample = static_cast<int>(i % 1000), line = static_cast<int>((i * 7) % 1000);
    return first_of(path_view(array, platform, sample, line, Sampler{i, 3}).ray);
  });
}

void report_search(const std::string& name, const DetectorArray& array, const Platform& platform,
                   double distance) {
  const geometry::Ray ray = image_view(array, platform, {310.2, 722.7}).ray;
  report(name, 100'000, [&](std::uint32_t i) {
    const Vec3 place = ray.origin + (distance + 1e-3 * i) * ray.direction;
    return image_of(array, platform, place)->line;
  });
}

}  // namespace

int main() {
  const Platform still{from_euler({1.0, 2.0, 3.0}, Mat3{}, Angle{0.3}, Angle{-1.0}, Angle{0.1})};
  const Platform moving = orbit();
  const Pose pose = still.at(0.0);
  report("one point of the sampler", 1'000'000, [](std::uint32_t i) {
    return Sampler{i, 3}.point(0).x;
  });
  report("arithmetic alone", 1'000'000, [&](std::uint32_t i) {
    const Vec2 inside = Sampler{i, 3}.point(0);
    const double x = (i % 1000 + inside.x - 500.0) * 1e-5, y = (i % 999 + inside.y - 500.0) * 1e-5;
    return first_of({pose.position, normalised(pose.axes * Vec3{x, y, 0.1})});
  });
  DetectorArray array = frame();
  report_paths("plain pinhole, fixed", array, still);
  report_search("  image_of", array, still, 100.0);
  const Distortion lens{.k1 = -0.3, .k2 = 0.12, .p1 = 1e-3, .p2 = -2e-3};
  report("undistorted", 1'000'000, [&](std::uint32_t i) {
    return undistorted(lens, {1e-4 * (i % 1000) - 0.05, 3e-4 * (i % 999) - 0.15}).x;
  });
  array.projection = Perspective{0.02, lens};
  report_paths("with distortion", array, still);
  report_search("  image_of", array, still, 100.0);
  SpreadDescription blur;
  blur.diffraction = DiffractionSpread{6.4, 0.2};
  blur.gaussians = {{3e-6, 3e-6}};
  const std::vector<spectral::Response> bands{
      spectral::BoxResponse{Micrometres{0.5}, Micrometres{0.6}}};
  array.spread = std::make_shared<const PointSpread>(blur, bands);
  report_paths("with distortion, diffraction and blur", array, still);
  array = frame();
  array.timing = {Pushbroom{-5.0, 0.01}, 0.008};
  report_paths("pushbroom on an orbit", array, moving);
  report_search("  image_of", array, moving, 705e3);
  array.timing.tdi_stages = 8;
  array.modules = {{0, 500, 0.0, 1e-4, 1e-5}, {500, 500, 0.0, -1e-4, -1e-5}};
  array.spread = std::make_shared<const PointSpread>(blur, bands);
  report_paths("  with TDI, modules, diffraction and blur", array, moving);
  report_search("  image_of, two modules", array, moving, 705e3);
}
