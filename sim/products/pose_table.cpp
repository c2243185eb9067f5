#include "sim/products/pose_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace nadir::sim {
namespace {

constexpr int points = 8;
constexpr int beyond = 5;  // steps outside the span
constexpr double tolerance_px = 1e-4;
constexpr double finest_step_s = 0x1p-20;  // times of 1e9 s keep such steps exactly
constexpr std::size_t most_poses = 20000;

struct EarthPose {
  Vec3 position;
  Quaternion orientation;
};

/// Lagrange's weights for a place among eight even nodes 0 ... 7.
std::array<double, points> weights(double place) {
  std::array<double, points> w{};
  for (int i = 0; i < points; ++i) {
    double product = 1.0;
    for (int j = 0; j < points; ++j) {
      if (j != i) product *= (place - j) / (i - j);
    }
    w[static_cast<std::size_t>(i)] = product;
  }
  return w;
}

/// @param first  of the eight poses
EarthPose blended(const std::vector<EarthPose>& poses, std::size_t first, double place) {
  const auto w = weights(place);
  EarthPose sum{{}, {0.0, 0.0, 0.0, 0.0}};
  for (std::size_t i = 0; i < w.size(); ++i) {
    const EarthPose& pose = poses[first + i];
    sum.position += w[i] * pose.position;
    sum.orientation.w += w[i] * pose.orientation.w;
    sum.orientation.x += w[i] * pose.orientation.x;
    sum.orientation.y += w[i] * pose.orientation.y;
    sum.orientation.z += w[i] * pose.orientation.z;
  }
  sum.orientation = unit(sum.orientation);
  return sum;
}

class PoseSource {
 public:
  explicit PoseSource(const ProductGeometry& geometry)
      : geometry_{&geometry}, to_earth_{scene_axes_ecef(geometry.frame)} {}

  [[nodiscard]] EarthPose at(double time_s) const {
    const sensor::Platform& platform = geometry_->camera->platform;
    const sensor::Pose pose =
        platform.steady(std::clamp(time_s, platform.first_s(), platform.last_s()));
    return {geometry_->frame.ecef(pose.position), to_quaternion(to_earth_ * pose.axes)};
  }

 private:
  const ProductGeometry* geometry_;
  Mat3 to_earth_;
};

void make_continuous(std::vector<EarthPose>& poses) {
  for (std::size_t i = 1; i < poses.size(); ++i) {
    Quaternion& q = poses[i].orientation;
    if (dot(poses[i - 1].orientation, q) < 0.0) q = {-q.w, -q.x, -q.y, -q.z};
  }
}

/// Poses at whole steps from the middle, as far as the span goes, and on as their polynomial goes.
struct Sampled {
  std::vector<EarthPose> poses;
  double first_s = 0.0;
};

Sampled sampled(const PoseSource& source, const PoseSpan& span, double step_s) {
  const int before = static_cast<int>(std::floor((span.middle_s - span.first_s) / step_s));
  const int after = static_cast<int>(std::floor((span.last_s - span.middle_s) / step_s));
  std::vector<EarthPose> inside;
  for (int k = -before; k <= after; ++k) inside.push_back(source.at(span.middle_s + k * step_s));
  make_continuous(inside);
  Sampled all{{}, span.middle_s - (before + beyond) * step_s};
  for (int k = -beyond; k < 0; ++k) all.poses.push_back(blended(inside, 0, k));
  all.poses.insert(all.poses.end(), inside.begin(), inside.end());
  for (int k = 1; k <= beyond; ++k) {
    all.poses.push_back(blended(inside, inside.size() - points, points - 1 + k));
  }
  return all;
}

/// At places all over the span that no step divides.
double error_px(const PoseSource& source, const Sampled& table, const PoseSpan& span,
                double step_s) {
  constexpr int tried = 397;
  double largest = 0.0;
  for (int i = 0; i <= tried; ++i) {
    const double time_s = span.first_s + (span.last_s - span.first_s) * i / tried;
    const double place = (time_s - table.first_s) / step_s;
    const auto first = static_cast<std::size_t>(
        std::clamp(std::floor(place) - 3.0, 0.0, static_cast<double>(table.poses.size() - points)));
    const EarthPose found = blended(table.poses, first, place - static_cast<double>(first));
    const EarthPose exact = source.at(time_s);
    largest =
        std::max(largest, length(found.position - exact.position) / span.pixel_m +
                              angle_between(found.orientation, exact.orientation) / span.pixel_rad);
  }
  return largest;
}

/// Turning rate that leads from one orientation to another.
Vec3 turning_rate(const Quaternion& from, const Quaternion& to, double elapsed_s) {
  const Quaternion turn = to * conjugate(from);
  return Vec3{turn.x, turn.y, turn.z} * (2.0 * (turn.w < 0.0 ? -1.0 : 1.0) / elapsed_s);
}

PoseTable with_rates(const Sampled& sampled, double step_s) {
  PoseTable table;
  table.first_s = sampled.first_s;
  table.step_s = step_s;
  const auto& poses = sampled.poses;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::size_t a = i == 0 ? 0 : i - 1, b = std::min(i + 1, poses.size() - 1);
    const double elapsed_s = static_cast<double>(b - a) * step_s;
    table.positions_m.push_back(poses[i].position);
    table.camera_to_earth.push_back(poses[i].orientation);
    table.velocities_m_s.push_back((poses[b].position - poses[a].position) / elapsed_s);
    table.angular_velocities_rad_s.push_back(
        turning_rate(poses[a].orientation, poses[b].orientation, elapsed_s));
  }
  return table;
}

}  // namespace

Mat3 scene_axes_ecef(const geometry::LocalFrame& frame) {
  constexpr double radians = 3.14159265358979323846 / 180.0;
  const double latitude = frame.origin().latitude_deg * radians;
  const double longitude = frame.origin().longitude_deg * radians;
  const double sp = std::sin(latitude), cp = std::cos(latitude);
  const double sl = std::sin(longitude), cl = std::cos(longitude);
  return {{-sl, cl, 0.0}, {-sp * cl, -sp * sl, cp}, {cp * cl, cp * sl, sp}};
}

PoseTable pose_table(const ProductGeometry& geometry, const PoseSpan& span) {
  const PoseSource source{geometry};
  // Twelve steps at least, so that each side of the middle has some.
  double step_s = std::exp2(std::floor(std::log2((span.last_s - span.first_s) / 12.0)));
  step_s = std::max(step_s, finest_step_s);
  while (true) {
    const Sampled table = sampled(source, span, step_s);
    const double error = error_px(source, table, span, step_s);
    const bool finest = step_s <= finest_step_s || 2 * table.poses.size() > most_poses;
    if (error <= tolerance_px || finest) {
      PoseTable done = with_rates(table, step_s);
      done.error_px = error;
      return done;
    }
    step_s *= 0.5;
  }
}

PoseTable single_pose(const ProductGeometry& geometry, double time_s) {
  const PoseSource source{geometry};
  const EarthPose pose = source.at(time_s);
  PoseTable table;
  table.first_s = time_s;
  table.positions_m = {pose.position};
  table.camera_to_earth = {pose.orientation};
  table.velocities_m_s = {Vec3{}};
  table.angular_velocities_rad_s = {Vec3{}};
  const sensor::Platform& platform = geometry.camera->platform;
  if (platform.is_fixed()) return table;
  const double a_s = std::max(platform.first_s(), time_s - 0.01);
  const double b_s = std::min(platform.last_s(), time_s + 0.01);
  if (!(b_s > a_s)) return table;
  const EarthPose a = source.at(a_s), b = source.at(b_s);
  table.velocities_m_s = {(b.position - a.position) / (b_s - a_s)};
  table.angular_velocities_rad_s = {turning_rate(a.orientation, b.orientation, b_s - a_s)};
  return table;
}

}  // namespace nadir::sim
