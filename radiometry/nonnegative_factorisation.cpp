#include "radiometry/nonnegative_factorisation.hpp"

#include <algorithm>
#include <cmath>

namespace nadir::radiometry {
namespace {

// Few sweeps do on the way; where the goal is near, more of them (they gain up to a factor 3 on a
// lobe that moves) decide whether another part is needed.
constexpr int sweeps_on_the_way = 2, sweeps_near_the_goal = 12;
constexpr double near = 2.5;  ///< times the tolerance
/// Sweeps end early once one gains less than this share of the error.
constexpr double worthwhile_gain = 0.01;

double dot(const double* a, const double* b, std::size_t count) noexcept {
  // Four sums that do not wait for each other.
  double sums[4] = {0.0, 0.0, 0.0, 0.0};
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) {
    for (std::size_t j = 0; j < 4; ++j) sums[j] += a[i + j] * b[i + j];
  }
  for (; i < count; ++i) sums[0] += a[i] * b[i];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

void add_scaled(double* to, const double* from, double scale, std::size_t count) noexcept {
  for (std::size_t i = 0; i < count; ++i) to[i] += scale * from[i];
}

/// Parts in progress. W is kept transposed, one row a part, so that all loops run along rows.
class Factorisation {
 public:
  explicit Factorisation(const DenseMatrix& v) : v_{v}, residual_{v} {
    for (const double x : v.values) norm2_ += x * x;
    error_ = norm2_ > 0.0 ? 1.0 : 0.0;
  }

  [[nodiscard]] double error() const noexcept { return error_; }
  [[nodiscard]] std::size_t rank() const noexcept { return rank_; }

  /// A part that takes over what is left of the worst-fitted row. False: nothing is left.
  bool add_part() {
    const std::size_t row = worst_row();
    std::vector<double> part(v_.columns);
    const double* rest = residual_.row(row);
    std::transform(rest, rest + v_.columns, part.begin(),
                   [](double x) { return std::max(x, 0.0); });
    const double square = dot(part.data(), part.data(), v_.columns);
    if (square <= 0.0) return false;
    for (std::size_t i = 0; i < v_.rows; ++i) {
      const double share = dot(residual_.row(i), part.data(), v_.columns) / square;
      w_.push_back(std::max(share, 0.0));
    }
    h_.insert(h_.end(), part.begin(), part.end());
    ++rank_;
    return true;
  }

  void sweep(int count) {
    for (int i = 0; i < count; ++i) {
      improve_h();
      improve_w();
      const double before = error_;
      measure();
      if (before - error_ < worthwhile_gain * before) break;
    }
  }

  [[nodiscard]] NonnegativeFactors result() const {
    NonnegativeFactors factors{rank_, {v_.rows, rank_}, {rank_, v_.columns}, error_};
    for (std::size_t k = 0; k < rank_; ++k) {
      for (std::size_t i = 0; i < v_.rows; ++i) factors.w.row(i)[k] = w(k)[i];
    }
    factors.h.values = h_;
    return factors;
  }

 private:
  [[nodiscard]] double* w(std::size_t part) noexcept { return w_.data() + part * v_.rows; }
  [[nodiscard]] const double* w(std::size_t part) const noexcept {
    return w_.data() + part * v_.rows;
  }
  [[nodiscard]] double* h(std::size_t part) noexcept { return h_.data() + part * v_.columns; }

  /// The row with most left that a part could still take away.
  [[nodiscard]] std::size_t worst_row() const noexcept {
    std::size_t worst = 0;
    double most = -1.0;
    for (std::size_t i = 0; i < v_.rows; ++i) {
      double left = 0.0;
      for (std::size_t j = 0; j < v_.columns; ++j) {
        const double rest = std::max(residual_.row(i)[j], 0.0);
        left += rest * rest;
      }
      if (left > most) {
        most = left;
        worst = i;
      }
    }
    return worst;
  }

  /// H_k <- max(0, H_k + (W_k^T V - W_k^T W H) / W_k^T W_k), part after part.
  void improve_h() {
    target_.assign(v_.columns, 0.0);
    for (std::size_t k = 0; k < rank_; ++k) {
      const double square = dot(w(k), w(k), v_.rows);
      if (square <= 0.0) continue;
      std::fill(target_.begin(), target_.end(), 0.0);
      for (std::size_t i = 0; i < v_.rows; ++i) {
        if (w(k)[i] > 0.0) add_scaled(target_.data(), v_.row(i), w(k)[i], v_.columns);
      }
      for (std::size_t other = 0; other < rank_; ++other) {
        if (other == k) continue;
        add_scaled(target_.data(), h(other), -dot(w(k), w(other), v_.rows), v_.columns);
      }
      std::transform(target_.begin(), target_.end(), h(k),
                     [&](double x) { return std::max(0.0, x / square); });
    }
  }

  /// The same for the columns of W.
  void improve_w() {
    target_.assign(v_.rows, 0.0);
    for (std::size_t k = 0; k < rank_; ++k) {
      const double square = dot(h(k), h(k), v_.columns);
      if (square <= 0.0) continue;
      for (std::size_t i = 0; i < v_.rows; ++i) {
        target_[i] = dot(v_.row(i), h(k), v_.columns);
      }
      for (std::size_t other = 0; other < rank_; ++other) {
        if (other == k) continue;
        add_scaled(target_.data(), w(other), -dot(h(k), h(other), v_.columns), v_.rows);
      }
      std::transform(target_.begin(), target_.end(), w(k),
                     [&](double x) { return std::max(0.0, x / square); });
    }
  }

  void measure() {
    residual_ = v_;
    double left = 0.0;
    for (std::size_t i = 0; i < v_.rows; ++i) {
      double* rest = residual_.row(i);
      for (std::size_t k = 0; k < rank_; ++k) {
        if (w(k)[i] > 0.0) add_scaled(rest, h(k), -w(k)[i], v_.columns);
      }
      left += dot(rest, rest, v_.columns);
    }
    error_ = std::sqrt(left / norm2_);
  }

  const DenseMatrix& v_;
  DenseMatrix residual_;
  std::vector<double> w_, h_, target_;
  std::size_t rank_ = 0;
  double norm2_ = 0.0, error_ = 0.0;
};

}  // namespace

NonnegativeFactors factorise(const DenseMatrix& v, const FactorisationGoal& goal) {
  const std::size_t limit = std::min({goal.rank_limit, v.rows, v.columns});
  Factorisation factorisation{v};
  while (factorisation.error() > goal.tolerance && factorisation.rank() < limit) {
    if (!factorisation.add_part()) break;
    factorisation.sweep(sweeps_on_the_way);
    const bool last = factorisation.rank() == limit;
    const bool close = factorisation.error() < near * goal.tolerance;
    if (last || (close && factorisation.error() > goal.tolerance)) {
      factorisation.sweep(sweeps_near_the_goal);
    }
  }
  return factorisation.result();
}

}  // namespace nadir::radiometry
