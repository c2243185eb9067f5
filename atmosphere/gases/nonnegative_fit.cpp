#include "atmosphere/gases/nonnegative_fit.hpp"

#include <algorithm>
#include <cmath>

namespace nadir::atmosphere {

namespace {

/// The pull to the first guess, relative to an equation of weight 1: errors of 1e-6 in an equation
/// outweigh changes of 0.1 in an unknown.
constexpr double pull = 1e-10;

}  // namespace

NonnegativeFit::NonnegativeFit(std::size_t unknowns)
    : n_{unknowns}, matrix_(n_ * n_, 0.0), right_(n_, 0.0) {}

void NonnegativeFit::add(const std::vector<double>& row, double value, double weight) {
  for (std::size_t i = 0; i < n_; ++i) {
    right_[i] += weight * row[i] * value;
    for (std::size_t j = 0; j <= i; ++j) matrix_[i * n_ + j] += weight * row[i] * row[j];
  }
}

/// Solves for the free unknowns alone, by Cholesky's decomposition.
std::vector<double> NonnegativeFit::unconstrained(const std::vector<std::size_t>& free,
                                                  const std::vector<double>& right) const {
  const std::size_t n = free.size();
  std::vector<double> lower(n * n, 0.0), x(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = matrix_[free[i] * n_ + free[j]] + (i == j ? pull : 0.0);
      for (std::size_t k = 0; k < j; ++k) sum -= lower[i * n + k] * lower[j * n + k];
      // Rounding may take the last bit of what the pull keeps above 0.
      lower[i * n + j] = i == j ? std::sqrt(std::max(sum, 1e-2 * pull)) : sum / lower[j * n + j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    double sum = right[free[i]];
    for (std::size_t k = 0; k < i; ++k) sum -= lower[i * n + k] * x[k];
    x[i] = sum / lower[i * n + i];
  }
  for (std::size_t i = n; i-- > 0;) {
    double sum = x[i];
    for (std::size_t k = i + 1; k < n; ++k) sum -= lower[k * n + i] * x[k];
    x[i] = sum / lower[i * n + i];
  }
  return x;
}

/// Moves the free unknowns to the unconstrained solution, or as far towards it as none turns
/// negative; those that reach 0 are taken out of `free`, until none does.
void NonnegativeFit::settle(std::vector<std::size_t>& free, const std::vector<double>& right,
                            std::vector<double>& x) const {
  while (!free.empty()) {
    const std::vector<double> z = unconstrained(free, right);
    double step = 1.0;
    for (std::size_t i = 0; i < free.size(); ++i) {
      if (z[i] < 0.0) step = std::min(step, x[free[i]] / (x[free[i]] - z[i]));
    }
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < free.size(); ++i) {
      double& value = x[free[i]];
      const bool ends = z[i] < 0.0 && value / (value - z[i]) <= step;
      value = ends ? 0.0 : value + step * (z[i] - value);
      if (!ends) left.push_back(free[i]);
    }
    if (left.size() == free.size()) return;
    free = std::move(left);
  }
}

/// The unknown at 0 that the fit gains most from; n_ where it gains from none.
std::size_t NonnegativeFit::wanted(const std::vector<double>& right,
                                   const std::vector<double>& x) const {
  std::size_t best = n_;
  double steepest = 1e-9;  // an equation off by this matters to no one
  for (std::size_t i = 0; i < n_; ++i) {
    if (x[i] > 0.0) continue;
    double slope = right[i];
    for (std::size_t j = 0; j < n_; ++j) {
      slope -= matrix_[std::max(i, j) * n_ + std::min(i, j)] * x[j];
    }
    if (slope > steepest) {
      steepest = slope;
      best = i;
    }
  }
  return best;
}

std::vector<double> NonnegativeFit::solve(std::vector<double> guess) const {
  std::vector<double> right = right_;
  for (std::size_t i = 0; i < n_; ++i) right[i] += pull * guess[i];
  std::vector<double> x = std::move(guess);
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < n_; ++i) {
    if (x[i] > 0.0) free.push_back(i);
  }
  settle(free, right, x);
  for (std::size_t turn = 0; turn < n_; ++turn) {
    const std::size_t back = wanted(right, x);
    if (back == n_) break;
    free.insert(std::upper_bound(free.begin(), free.end(), back), back);
    settle(free, right, x);
    if (x[back] == 0.0) break;  // rounding: it went straight out again
  }
  return x;
}

}  // namespace nadir::atmosphere
