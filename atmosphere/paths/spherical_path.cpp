#include "atmosphere/paths/spherical_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace nadir::atmosphere {
namespace {

/// r_a^2 - r_b^2 of two heights.
double square_difference(double a_m, double b_m) noexcept {
  return (a_m - b_m) * (2.0 * earth_radius_m + a_m + b_m);
}

/// Signed way from the line's lowest point.
double from_lowest_m(PathPoint p) noexcept { return (earth_radius_m + p.height_m) * p.mu; }

/// t^2 at a height on the line; negative where the line stays above.
double lowest_square(PathPoint start, double height_m) noexcept {
  const double t = from_lowest_m(start);
  return t * t + square_difference(height_m, start.height_m);
}

/// A line being cut at the levels that it crosses.
class Pieces {
 public:
  Pieces(const std::vector<double>& level_m, PathPoint start, double length_m)
      : level_m_{level_m}, start_{start}, length_m_{length_m}, last_{start} {
    while (layer_ < layers() &&
           (start.mu < 0.0 ? start.height_m <= bottom() : start.height_m < bottom())) {
      ++layer_;
    }
  }

  /// Down to the line's lowest point; false if it ends before.
  bool descend() {
    for (; layer_ < layers(); ++layer_) {
      const double way = way_down_to_m(start_, bottom());
      if (way < 0.0) {
        const double lowest_m = -from_lowest_m(start_);
        return add({lowest_m, advanced(start_, lowest_m).height_m});
      }
      if (!add({way, bottom()})) return false;
    }
    return false;  // it met the ground
  }
  /// Up from there or from the start, out of the top.
  void ascend() {
    for (layer_ = std::min(layer_, layers() - 1); layer_ >= 0; --layer_) {
      const double top = level_m_[static_cast<std::size_t>(layer_)];
      const double way = way_up_to_m(start_, top);
      if (way >= 0.0 && !add({way, top})) return;
    }
  }
  [[nodiscard]] std::vector<PathPiece> take() { return std::move(pieces_); }

 private:
  struct End {
    double way_m, height_m;
  };

  [[nodiscard]] int layers() const { return static_cast<int>(level_m_.size()) - 1; }
  [[nodiscard]] double bottom() const { return level_m_[static_cast<std::size_t>(layer_) + 1]; }

  /// Adds the piece up to an end; false when the whole length is used up.
  bool add(End to) {
    const bool cut = to.way_m >= length_m_;
    const double way_m = cut ? length_m_ : to.way_m;
    PathPoint end = advanced(start_, way_m);
    if (!cut) end.height_m = to.height_m;  // the level's own, to the last digit
    if (way_m > way_m_) {
      pieces_.push_back(
          {layer_, way_m - way_m_, last_.height_m, end.height_m, last_.mu, end.mu, way_m_});
      way_m_ = way_m;
      last_ = end;
    }
    return !cut;
  }

  const std::vector<double>& level_m_;
  PathPoint start_;
  double length_m_;
  PathPoint last_;
  int layer_ = 0;
  double way_m_ = 0.0;
  std::vector<PathPiece> pieces_;
};

/// How many times its thickness a layer is crossed between the line's lowest point (or the start,
/// if the line rises from there) and where it leaves upwards.
double slant(PathPoint start, double top_m, double bottom_m) noexcept {
  // Ways from the lowest point to the layer's edges; 0 for an edge below that point.
  const double top = std::max(0.0, lowest_square(start, top_m));
  const double bottom = std::max(0.0, lowest_square(start, bottom_m));
  if (top == 0.0) return 0.0;
  return bottom > 0.0
             ? (2.0 * earth_radius_m + top_m + bottom_m) / (std::sqrt(top) + std::sqrt(bottom))
             : std::sqrt(top) / (top_m - bottom_m);
}

}  // namespace

PathPoint advanced(PathPoint start, double way_m) noexcept {
  const double r0 = earth_radius_m + start.height_m, t0 = from_lowest_m(start);
  const double change = way_m * (2.0 * t0 + way_m);
  const double r = std::sqrt(std::max(0.0, r0 * r0 + change));
  return {start.height_m + change / (r + r0), std::clamp((t0 + way_m) / r, -1.0, 1.0)};
}

double way_down_to_m(PathPoint start, double height_m) noexcept {
  const double t0 = from_lowest_m(start), square = lowest_square(start, height_m);
  if (t0 >= 0.0 || square < 0.0 || height_m > start.height_m) return -1.0;
  return square_difference(start.height_m, height_m) / (std::sqrt(square) - t0);
}

double way_up_to_m(PathPoint start, double height_m) noexcept {
  const double t0 = from_lowest_m(start), square = lowest_square(start, height_m);
  if (square < 0.0) return -1.0;
  const double t = std::sqrt(square);
  if (t0 <= 0.0) return t - t0;
  return height_m < start.height_m ? -1.0 : square_difference(height_m, start.height_m) / (t + t0);
}

double horizon_mu(double ground_m, double height_m) noexcept {
  if (height_m <= ground_m) return 0.0;
  return -std::sqrt(square_difference(height_m, ground_m)) / (earth_radius_m + height_m);
}

std::vector<PathPiece> path_through(const std::vector<double>& level_height_m, double height_m,
                                    double mu, double length_m) {
  Pieces pieces{level_height_m, {height_m, mu}, length_m};
  if (mu >= 0.0 || pieces.descend()) pieces.ascend();
  return pieces.take();
}

double way_to_end_m(double top_m, double ground_m, double height_m, double mu) noexcept {
  const PathPoint start{height_m, mu};
  if (mu < 0.0) {
    if (height_m <= ground_m) return 0.0;
    const double down = way_down_to_m(start, ground_m);
    if (down >= 0.0) return down;
  }
  if (mu >= 0.0 && height_m >= top_m) return 0.0;
  return std::max(0.0, way_up_to_m(start, top_m));
}

std::vector<double> slant_depths(const std::vector<double>& level_height_m,
                                 const std::vector<double>& layer_depth, double mu0) {
  const auto& z = level_height_m;
  std::vector<double> depths(z.size(), 0.0);
  for (std::size_t level = 0; level < z.size(); ++level) {
    const PathPoint start{z[level], mu0};
    if (mu0 < 0.0 && lowest_square(start, z.back()) > 0.0) {
      depths[level] = std::numeric_limits<double>::infinity();
      continue;
    }
    for (std::size_t k = 0; k < level; ++k) {
      depths[level] += layer_depth[k] * slant(start, z[k], z[k + 1]);
    }
    // Below the level down to the lowest point and up again.
    for (std::size_t k = level; mu0 < 0.0 && k < layer_depth.size(); ++k) {
      depths[level] += 2.0 * layer_depth[k] * slant(start, z[k], z[k + 1]);
    }
  }
  return depths;
}

}  // namespace nadir::atmosphere
