#include "sim/run/view_facts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "sensor/camera/path_view.hpp"

namespace nadir::sim {
namespace {

constexpr int looks = 17;  // along each side

/// A point of the picture's grid, corners included.
sensor::ImagePoint grid_point(const sensor::DetectorArray& array, int i, int j) {
  return {array.samples * i / (looks - 1.0), array.lines * j / (looks - 1.0)};
}

double distance_to(const geometry::Bounds& box, Vec3 eye) {
  const auto beyond = [](double at, double lo, double hi) {
    return std::max({lo - at, at - hi, 0.0});
  };
  return length(Vec3{beyond(eye.x, box.lo.x, box.hi.x), beyond(eye.y, box.lo.y, box.hi.y),
                     beyond(eye.z, box.lo.z, box.hi.z)});
}

/// Area across the line of sight at a distance that a pixel about a place of the image covers.
double pixel_area(const sensor::DetectorArray& array, const sensor::Platform& platform,
                  const sensor::ImagePoint& at, double distance_m) {
  if (std::holds_alternative<sensor::Orthographic>(array.projection)) {
    return array.pitch_m * array.height_m();
  }
  const auto place = [&](double sample, double line) {
    const geometry::Ray ray =
        sensor::image_view(array, platform, {at.sample + sample, at.line + line}).ray;
    return ray.origin + ray.direction * distance_m;
  };
  return length(place(0.5, 0.0) - place(-0.5, 0.0)) * length(place(0.0, 0.5) - place(0.0, -0.5));
}

double secant(Vec3 direction) {
  constexpr double flattest = 1.0 / 40.0;  // a round earth's air has no longer way
  return 1.0 / std::max(std::abs(direction.z), flattest);
}

}  // namespace

ViewFacts view_facts(const geometry::Scene& scene, const sensor::Platform& platform,
                     const sensor::DetectorArray& array) {
  ViewFacts facts;
  std::vector<Vec3> directions;
  Vec3 sum;
  const geometry::Bounds box = scene.bounds();
  double least_area = std::numeric_limits<double>::infinity();
  for (int j = 0; j < looks; ++j) {
    for (int i = 0; i < looks; ++i) {
      const geometry::Ray ray = sensor::image_view(array, platform, grid_point(array, i, j)).ray;
      directions.push_back(ray.direction);
      sum = sum + ray.direction;
      facts.air_mass = std::max(facts.air_mass, secant(ray.direction));
      facts.misses_surfaces = facts.misses_surfaces || !scene.intersect(ray);
    }
  }
  // Pixels change little over an array: its middle and two corners, with half as margin.
  for (const int at : {0, looks / 2, looks - 1}) {
    sensor::ImagePoint place = grid_point(array, at, at);
    place.sample = std::clamp(place.sample, 0.5, array.samples - 0.5);
    place.line = std::clamp(place.line, 0.5, array.lines - 0.5);
    const Vec3 eye = sensor::image_view(array, platform, place).ray.origin;
    least_area = std::min(least_area, pixel_area(array, platform, place, distance_to(box, eye)));
  }
  constexpr double margin = 0.5;
  facts.least_pixel_m2 = margin * array.fill_x * array.fill_y * least_area;
  facts.axis = normalised(sum);
  for (const Vec3& direction : directions) {
    const double cosine = std::clamp(dot(direction, facts.axis), -1.0, 1.0);
    facts.half_angle_rad = std::max(facts.half_angle_rad, std::acos(cosine));
  }
  return facts;
}

double greatest_cosine(const ViewFacts& view, Vec3 direction) noexcept {
  const double angle = std::acos(std::clamp(dot(view.axis, direction), -1.0, 1.0));
  return std::cos(std::max(0.0, angle - view.half_angle_rad));
}

double smear_pixels(const sensor::Platform& platform, const sensor::DetectorArray& array) noexcept {
  const sensor::Timing& timing = array.timing;
  const bool lasts = timing.exposure_s > 0.0 || timing.lag_s > 0.0 || timing.tdi_stages > 1;
  const bool moves = !platform.is_fixed() && lasts;
  return moves || platform.has_white_jitter() ? std::numeric_limits<double>::infinity() : 0.0;
}

}  // namespace nadir::sim
