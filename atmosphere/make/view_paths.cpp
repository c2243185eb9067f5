#include "atmosphere/make/view_paths.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "atmosphere/paths/path_measure.hpp"
#include "atmosphere/paths/spherical_path.hpp"

namespace nadir::atmosphere {
namespace {

using std::numbers::pi;

/// Of the angle between a line and the vertical.
double sine_of(PathPoint p) { return std::sqrt(std::max(0.0, 1.0 - p.mu * p.mu)); }

/// Whether an eye's place stands for all those above the air.
bool at_top(const Shells& shells, double height_m) { return height_m >= shells.top_m() - 1.0; }

/// A line of sight being cut.
class Cutter {
 public:
  Cutter(const Shells& shells, PathPoint start, double anchor_rad)
      : shells_{shells},
        start_{start},
        anchor_sine_{std::sin(anchor_rad)},
        anchor_cosine_{std::cos(anchor_rad)} {}

  [[nodiscard]] StepEnd end(int layer, double way_m) const {
    const PathPoint p = advanced(start_, way_m);
    const auto k = static_cast<std::size_t>(layer);
    const double upper = shells_.level_m[k], lower = shells_.level_m[k + 1];
    StepEnd e;
    e.top = std::clamp((p.height_m - lower) / (upper - lower), 0.0, 1.0);
    e.travel = shells_.directions.at(-p.mu);
    const double r = earth_radius_m + p.height_m;
    // Sine and cosine of the arc from the start.
    const double away = way_m * sine_of(start_) / r;
    const double up = (earth_radius_m + start_.height_m + way_m * start_.mu) / r;
    e.away = away * anchor_cosine_ - up * anchor_sine_;
    e.up = up * anchor_cosine_ + away * anchor_sine_;
    return e;
  }

  [[nodiscard]] PathStep step(int layer, double from_m, double to_m) const {
    const auto k = static_cast<std::size_t>(layer);
    const double thickness = shells_.level_m[k] - shells_.level_m[k + 1];
    return {layer, (to_m - from_m) / thickness, end(layer, from_m), end(layer, to_m), -1};
  }

 private:
  const Shells& shells_;
  PathPoint start_;
  double anchor_sine_, anchor_cosine_;
};

/// See ViewPath; `way_m` is the whole way.
double anchor_arc(const Shells& shells, PathPoint start, double way_m, bool meets_ground) {
  if (!at_top(shells, start.height_m) || start.mu >= 0.0) return 0.0;
  const double r = earth_radius_m + start.height_m;
  const double to_m = meets_ground ? way_m : -r * start.mu;
  return std::atan2(to_m * sine_of(start), r + to_m * start.mu);
}

/// Way at which a share of the whole measure is used up. The measure grows along the way.
double way_of_share(PathPoint start, double share, double way_m, double whole_m) {
  double lo = 0.0, hi = way_m;
  for (int i = 0; i < 60 && hi - lo > 1e-9 * way_m; ++i) {
    const double middle = 0.5 * (lo + hi);
    const double m = air_measure_m(start.height_m, advanced(start, middle).height_m, middle);
    (m < share * whole_m ? lo : hi) = middle;
  }
  return 0.5 * (lo + hi);
}

std::vector<double> ways_of_shares(PathPoint start, const std::vector<double>& shares, double way_m,
                                   double whole_m) {
  std::vector<double> ways;
  for (const double share : shares) {
    const bool inside = share > 0.0 && share < 1.0;
    ways.push_back(inside ? way_of_share(start, share, way_m, whole_m) : share * way_m);
  }
  return ways;
}

/// Into how many steps a piece is cut: height must run nearly evenly within each.
int cuts(const PathPiece& piece) {
  const double steepest = std::max(std::abs(piece.mu_in), std::abs(piece.mu_out));
  const double change = std::abs(piece.mu_out - piece.mu_in);
  if (change < 0.25 * steepest) return 1;
  return change < 0.6 * steepest ? 2 : 4;
}

void cut_piece(const Cutter& cutter, const PathPiece& piece, const std::vector<double>& ways,
               std::size_t& next, std::vector<PathStep>& steps) {
  const double last = piece.start_m + piece.length_m;
  const int count = cuts(piece);
  double from = piece.start_m;
  for (int i = 1; i <= count; ++i) {
    const double to = i == count ? last : piece.start_m + piece.length_m * i / count;
    while (next < ways.size() && ways[next] < to) {
      if (ways[next] > from) steps.push_back(cutter.step(piece.layer, from, ways[next]));
      if (!steps.empty()) steps.back().share = static_cast<int>(next);
      from = std::max(from, ways[next++]);
    }
    if (to > from) steps.push_back(cutter.step(piece.layer, from, to));
    from = to;
  }
}

int layer_of(const std::vector<double>& levels, double height_m, bool down) {
  const int last = static_cast<int>(levels.size()) - 2;
  int layer = 0;
  const auto below = [&](int k) { return levels[static_cast<std::size_t>(k) + 1]; };
  while (layer < last && (down ? height_m <= below(layer) : height_m < below(layer))) ++layer;
  return layer;
}

/// Distances from the horizon, 0 to `width`, denser towards 0.
std::vector<double> from_horizon(double width, int nodes) {
  std::vector<double> x;
  for (int i = 0; i < nodes; ++i) {
    x.push_back(width * std::pow(static_cast<double>(i) / (nodes - 1), 2.2));
  }
  return x;
}

}  // namespace

ViewPath view_path(const Shells& shells, double height_m, double zenith_rad, Side side,
                   const std::vector<double>& shares) {
  const double horizon = horizon_mu(shells.ground_m(), height_m);
  double mu = std::cos(zenith_rad);
  if (std::abs(mu) < 1e-12) mu = 0.0;
  // On the horizon itself the last digit must not decide; off it by 1e-9 in the way's lowest
  // point: less than a tenth of a millimetre.
  constexpr double nudge = 1e-9;
  ViewPath path;
  path.zenith_rad = zenith_rad;
  path.meets_ground = side == Side::below;
  mu = path.meets_ground ? std::min(mu, horizon - nudge) : std::max(mu, horizon);
  const PathPoint start{height_m, mu};
  double way_m = way_to_end_m(shells.top_m(), shells.ground_m(), height_m, mu);
  if (!path.meets_ground && mu < 0.0) {
    way_m = std::max(0.0, way_up_to_m(start, shells.top_m()));
  }
  path.measure_m = air_measure_m(height_m, advanced(start, way_m).height_m, way_m);
  path.anchor_rad = anchor_arc(shells, start, way_m, path.meets_ground);
  const Cutter cutter{shells, start, path.anchor_rad};
  path.start_layer = layer_of(shells.level_m, height_m, mu < 0.0);
  path.start = cutter.end(path.start_layer, 0.0);
  path.start_density = air_measure_m(height_m, height_m, 1.0);
  const auto first = static_cast<std::size_t>(path.start_layer);
  path.start_thickness_m = shells.level_m[first] - shells.level_m[first + 1];
  path.empty_shares = shares.size();
  if (way_m <= 0.0) return path;

  const std::vector<double> ways = ways_of_shares(start, shares, way_m, path.measure_m);
  std::size_t next = 0;
  while (next < ways.size() && ways[next] <= 0.0) ++next;
  path.empty_shares = next;
  // Nudged off the ground, a grazing path would else end on its lowest point.
  std::vector<double> levels = shells.level_m;
  if (!path.meets_ground) levels.back() -= 1.0;
  for (const PathPiece& piece : path_through(levels, height_m, mu, way_m)) {
    cut_piece(cutter, piece, ways, next, path.steps);
  }
  if (!path.steps.empty()) {
    path.steps.back().share = static_cast<int>(shares.size()) - 1;
  }
  return path;
}

ZenithAxis zenith_axis(const Shells& shells, double height_m, int nodes) {
  const double horizon = std::acos(horizon_mu(shells.ground_m(), height_m));
  ZenithAxis axis;
  const bool top = at_top(shells, height_m);
  const double width = top ? horizon - 0.5 * pi : horizon;
  const std::vector<double> x = from_horizon(width, top ? nodes - 1 : nodes);
  if (top) axis.above.push_back(0.0);
  for (auto i = x.rbegin(); i != x.rend(); ++i) axis.above.push_back(horizon - *i);
  if (!top) axis.above.front() = 0.0;
  for (const double d : from_horizon(pi - horizon, nodes)) axis.below.push_back(horizon + d);
  axis.below.back() = pi;
  return axis;
}

std::vector<double> share_axis(const Shells& shells, double height_m, int nodes) {
  std::vector<double> shares;
  const double above_m = height_m - shells.ground_m();
  for (int i = 0; i < nodes; ++i) {
    const double x = static_cast<double>(i) / (nodes - 1);
    const double near = x * x, far = 1.0 - (1.0 - x) * (1.0 - x);
    const double middle = x < 0.5 ? 2.0 * x * x : 1.0 - 2.0 * (1.0 - x) * (1.0 - x);
    shares.push_back(above_m < 3000.0 ? near : above_m > 20e3 ? far : middle);
  }
  return shares;
}

}  // namespace nadir::atmosphere
