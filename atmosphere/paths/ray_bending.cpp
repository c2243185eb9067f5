#include "atmosphere/paths/ray_bending.hpp"

#include <algorithm>
#include <cmath>

namespace nadir::atmosphere {
namespace {

/// Where a ray is in its own plane through the earth's centre.
struct RayState {
  double height_m = 0.0;
  double mu = 0.0;
  double arc_rad = 0.0;   ///< at the earth's centre, from the eye
  double bend_rad = 0.0;  ///< by which the ray has turned towards the ground
  double way_m = 0.0;
};

class Tracer {
 public:
  Tracer(const Refractivity& air, RayState start) : air_{air}, at_{start} {
    layer_ = air.layer_of(start.height_m);
    // On a level, into the layer that the ray goes to.
    if (start.mu < 0.0 && start.height_m == air.bottom_m(layer_) && layer_ > 0) --layer_;
  }
  [[nodiscard]] const RayState& at() const noexcept { return at_; }
  /// How sharply the ray turns here, m^-1.
  [[nodiscard]] double curvature() const noexcept { return rates(at_).bend; }

  /// One step of at most this length; false once the ray has left the top.
  bool step(double most_m) noexcept {
    advance(std::min(most_m, way_to_level_m()));
    return cross();
  }

 private:
  struct Rates {
    double height, mu, arc, bend;
  };
  static constexpr double level_slack_m = 1e-6;

  [[nodiscard]] Rates rates(const RayState& s) const noexcept {
    const double sine2 = std::max(0.0, 1.0 - s.mu * s.mu), r = earth_radius_m + s.height_m;
    const double sine = std::sqrt(sine2), bending = air_.bending(layer_, s.height_m);
    return {s.mu, sine2 * (1.0 / r + bending), sine / r, -bending * sine};
  }
  [[nodiscard]] static RayState moved(RayState s, const Rates& by, double way) noexcept {
    s.height_m += way * by.height;
    s.mu = std::clamp(s.mu + way * by.mu, -1.0, 1.0);
    s.arc_rad += way * by.arc;
    s.bend_rad += way * by.bend;
    s.way_m += way;
    return s;
  }
  void advance(double way) noexcept {
    const Rates a = rates(at_), b = rates(moved(at_, a, 0.5 * way));
    const Rates c = rates(moved(at_, b, 0.5 * way)), d = rates(moved(at_, c, way));
    const auto mean = [](double w, double x, double y, double z) {
      return (w + 2.0 * x + 2.0 * y + z) / 6.0;
    };
    at_ = moved(at_,
                {mean(a.height, b.height, c.height, d.height), mean(a.mu, b.mu, c.mu, d.mu),
                 mean(a.arc, b.arc, c.arc, d.arc), mean(a.bend, b.bend, c.bend, d.bend)},
                way);
  }

  [[nodiscard]] double lower_m() const noexcept {
    return layer_ == 0 ? -earth_radius_m : air_.bottom_m(layer_);
  }
  [[nodiscard]] double upper_m() const noexcept { return air_.bottom_m(layer_ + 1); }

  /// The nearest way at which the parabola of height, h + mu s + c s^2, leaves the layer. Beyond 10
  /// km it is no good as a forecast, but then nobody steps so far.
  [[nodiscard]] double way_to_level_m() const noexcept {
    const double c = 0.5 * rates(at_).mu;
    return std::min(way_through_m(lower_m() - at_.height_m, c, -1.0),
                    way_through_m(upper_m() - at_.height_m, c, 1.0));
  }
  /// Where that parabola has risen by so much, going up (sense 1) or down (-1).
  [[nodiscard]] double way_through_m(double rise, double c, double sense) const noexcept {
    constexpr double never = 1e9;
    // c s^2 + mu s - rise = 0; its derivative there is +-sqrt(mu^2 + 4 c rise)
    const double square = at_.mu * at_.mu + 4.0 * c * rise;
    if (!(square > 0.0)) return never;
    const double slope = sense * std::sqrt(square);
    // of the two forms the one in which nothing cancels
    const double s =
        at_.mu * sense >= 0.0 ? 2.0 * rise / (at_.mu + slope) : (slope - at_.mu) / (2.0 * c);
    return s >= 0.0 ? s : never;
  }

  /// Into the next layer if the ray has come to a level; false at the top.
  bool cross() noexcept {
    if (at_.mu > 0.0 && at_.height_m > upper_m() - level_slack_m) {
      if (layer_ + 1 == air_.layers()) return false;
      ++layer_;
    } else if (at_.mu < 0.0 && at_.height_m < lower_m() + level_slack_m) {
      --layer_;
    }
    return true;
  }

  const Refractivity& air_;
  RayState at_;
  int layer_ = 0;
};

/// Steps over which d ln n / dh changes by no more than a sixteenth of a scale height.
double smooth_step_m(const RayState& at) noexcept {
  constexpr double rise_m = 500.0, longest_m = 10e3;
  return std::min(longest_m, rise_m / std::max(std::abs(at.mu), 1e-3));
}

/// The plane of a ray, and its eye as the ray's state.
struct Plane {
  Vec3 up, ahead;  ///< unit, scene axes: at the eye, and level towards where the ray goes
  Vec3 centre;     ///< of the earth
  RayState start;
  double floor_m;  ///< below which nobody follows it

  Plane(double ground_m, Vec3 eye, Vec3 direction)
      : centre{0.0, 0.0, -(earth_radius_m + ground_m)}, floor_m{ground_m - 500.0} {
    const double origin_m = earth_radius_m + ground_m;
    const double square = eye.x * eye.x + eye.y * eye.y + eye.z * (2.0 * origin_m + eye.z);
    const double r = std::sqrt(origin_m * origin_m + square);
    up = (eye - centre) / r;
    start.height_m = ground_m + square / (r + origin_m);
    start.mu = std::clamp(dot(up, direction), -1.0, 1.0);
    const Vec3 level = direction - up * start.mu;
    const double sine = length(level);
    ahead = sine > 0.0 ? level / sine : Vec3{};  // a vertical ray stays where it is
  }
  [[nodiscard]] Vec3 position(const RayState& s) const {
    const double r = earth_radius_m + s.height_m, half = std::sin(0.5 * s.arc_rad);
    // up (r cos(arc)) from the centre, as a change from the eye's own height: to 1e-9 m
    const double rise = (s.height_m - start.height_m) - 2.0 * r * half * half;
    return centre + up * (earth_radius_m + start.height_m + rise) +
           ahead * (r * std::sin(s.arc_rad));
  }
  [[nodiscard]] Vec3 direction(const RayState& s) const {
    const double c = std::cos(s.arc_rad), q = std::sin(s.arc_rad);
    const double sine = std::sqrt(std::max(0.0, 1.0 - s.mu * s.mu));
    return up * (s.mu * c - sine * q) + ahead * (s.mu * q + sine * c);
  }
};

/// Puts the points of a ray through the air on a chain.
class Chain {
 public:
  Chain(BentPath& path, double reach_m) : path_{path} {
    const double finite_m = std::isfinite(reach_m) ? reach_m : 0.0;
    sag_m_ = 0.5 * std::max(bent_path_tolerance_m, bent_path_tolerance_share * finite_m);
  }
  /// Steps whose own sag, turn * length / 8, is half of what is allowed.
  [[nodiscard]] double step_m(double curvature) const noexcept {
    return std::sqrt(4.0 * sag_m_ / std::max(std::abs(curvature), 1e-15));
  }
  [[nodiscard]] bool is_due(const RayState& at) const noexcept {
    return std::abs(at.bend_rad - from_bend_) * (at.way_m - from_m_) >= 4.0 * sag_m_;
  }
  void add(const Plane& plane, const RayState& at, double before_m) {
    if (at.way_m > from_m_) path_.points.push_back({plane.position(at), before_m + at.way_m});
    from_m_ = at.way_m;
    from_bend_ = at.bend_rad;
  }

 private:
  BentPath& path_;
  double sag_m_ = 0.0;  // half of the tolerance
  double from_m_ = 0.0, from_bend_ = 0.0;
};

/// Straight on to the reach, if that is finite.
void run_on(BentPath& path, double reach_m) {
  const BentPoint last = path.points.back();
  if (!std::isfinite(reach_m) || !(reach_m > last.way_m)) return;
  path.points.push_back({last.position + path.end_direction * (reach_m - last.way_m), reach_m});
}

/// Way of empty space before a ray enters the air: 0 within it, negative if it never does.
double way_before_air_m(const Refractivity& air, const RayState& eye) noexcept {
  if (eye.height_m < air.top_m()) return 0.0;
  return way_down_to_m({eye.height_m, eye.mu}, air.top_m());
}

/// Follows a ray within the air; true if it leaves the top before its reach.
bool follow(Tracer& tracer, Chain& chain, const Plane& plane, double before_m, double reach_m) {
  bool within = true;
  while (within && before_m + tracer.at().way_m < reach_m) {
    const double left_m = reach_m - before_m - tracer.at().way_m;
    within = tracer.step(
        std::min({left_m, chain.step_m(tracer.curvature()), smooth_step_m(tracer.at())}));
    if (chain.is_due(tracer.at())) chain.add(plane, tracer.at(), before_m);
    if (tracer.at().height_m < plane.floor_m) break;
  }
  chain.add(plane, tracer.at(), before_m);
  return !within;
}

}  // namespace

BentPath bent_path(const Refractivity& air, double ground_m, Vec3 eye, Vec3 direction,
                   double reach_m) {
  BentPath path{{{eye, 0.0}}, direction};
  const double before_m = way_before_air_m(air, Plane{ground_m, eye, direction}.start);
  if (before_m < 0.0 || before_m >= reach_m) {
    run_on(path, reach_m);
    return path;
  }
  // In the air the ray is followed in its plane from where it enters.
  const Vec3 entry = eye + direction * before_m;
  if (before_m > 0.0) path.points.push_back({entry, before_m});
  const Plane plane{ground_m, entry, direction};
  RayState start = plane.start;
  start.height_m = std::min(start.height_m, air.top_m());
  Tracer tracer{air, start};
  Chain chain{path, reach_m};
  const bool left = follow(tracer, chain, plane, before_m, reach_m);
  path.end_direction = plane.direction(tracer.at());
  if (left) run_on(path, reach_m);
  return path;
}

std::optional<double> lift_rad(const Refractivity& air, double ground_m, PathPoint eye) {
  if (eye.height_m >= air.top_m() && eye.mu >= 0.0) return 0.0;
  RayState start{.height_m = eye.height_m, .mu = eye.mu};
  if (eye.height_m > air.top_m()) {
    const double way = way_down_to_m(eye, air.top_m());
    if (way < 0.0) return 0.0;
    start.mu = advanced(eye, way).mu;
    start.height_m = air.top_m();
  }
  Tracer tracer{air, start};
  while (tracer.step(smooth_step_m(tracer.at()))) {
    if (tracer.at().height_m < ground_m && tracer.at().mu < 0.0) return std::nullopt;
  }
  return tracer.at().bend_rad;
}

}  // namespace nadir::atmosphere
