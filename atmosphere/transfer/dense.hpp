#pragma once
// Private to this folder

#include <cmath>
#include <cstddef>

namespace nadir::atmosphere {

/// Square matrices of a few rows, row by row in memory, and vectors. With N > 0 the size is known
/// to the compiler, which unrolls the loops (4 x 4: three times as fast); N = 0 is any size.
template <int N>
class Dense {
 public:
  explicit Dense(std::size_t size) noexcept : size_{size} {}
  [[nodiscard]] std::size_t size() const noexcept {
    if constexpr (N > 0) return static_cast<std::size_t>(N);
    return size_;
  }

  /// c = a b; c is neither of them.
  void multiply(const double* a, const double* b, double* c) const noexcept {
    const std::size_t n = size();
    for (std::size_t i = 0; i < n; ++i) {
      double* row = c + i * n;
      for (std::size_t j = 0; j < n; ++j) row[j] = a[i * n] * b[j];
      for (std::size_t k = 1; k < n; ++k) add(a[i * n + k], b + k * n, row);
    }
  }
  /// y += factor x
  void add(double factor, const double* x, double* y) const noexcept {
    const std::size_t n = size();
    for (std::size_t i = 0; i < n; ++i) y[i] += factor * x[i];
  }
  [[nodiscard]] double dot(const double* x, const double* y) const noexcept {
    const std::size_t n = size();
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) sum += x[i] * y[i];
    return sum;
  }
  /// y += m x
  void apply(const double* m, const double* x, double* y) const noexcept {
    const std::size_t n = size();
    for (std::size_t i = 0; i < n; ++i) y[i] += dot(m + i * n, x);
  }
  /// y += m^T x
  void apply_transposed(const double* m, const double* x, double* y) const noexcept {
    const std::size_t n = size();
    for (std::size_t i = 0; i < n; ++i) add(x[i], m + i * n, y);
  }
  void transpose(const double* m, double* result) const noexcept {
    const std::size_t n = size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) result[j * n + i] = m[i * n + j];
    }
  }
  /// m += factor p p^T
  void add_square(double factor, const double* p, double* m) const noexcept {
    const std::size_t n = size();
    for (std::size_t i = 0; i < n; ++i) add(factor * p[i], p, m + i * n);
  }

  /// Lower triangle L of L L^T = m, zeros above; false where m is not positive.
  bool cholesky(const double* m, double* lower) const noexcept {
    const std::size_t n = size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        double sum = m[i * n + j];
        for (std::size_t k = 0; k < j; ++k) sum -= lower[i * n + k] * lower[j * n + k];
        if (j < i) {
          lower[i * n + j] = sum / lower[j * n + j];
        } else if (sum > 0.0) {
          lower[i * n + i] = std::sqrt(sum);
        } else {
          return false;
        }
      }
      for (std::size_t j = i + 1; j < n; ++j) lower[i * n + j] = 0.0;
    }
    return true;
  }
  /// x becomes L^-T x, for a matrix x.
  void solve_upper(const double* lower, double* x) const noexcept {
    const std::size_t n = size();
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t k = i + 1; k < n; ++k) add(-lower[k * n + i], x + k * n, x + i * n);
      scale(1.0 / lower[i * n + i], x + i * n);
    }
  }
  /// L U of m, in its place, with the diagonal's reciprocals: without pivots, for matrices whose
  /// symmetric part is positive.
  void factorise(double* m) const noexcept {
    const std::size_t n = size();
    for (std::size_t k = 0; k < n; ++k) {
      m[k * n + k] = 1.0 / m[k * n + k];
      for (std::size_t i = k + 1; i < n; ++i) {
        m[i * n + k] *= m[k * n + k];
        for (std::size_t j = k + 1; j < n; ++j) m[i * n + j] -= m[i * n + k] * m[k * n + j];
      }
    }
  }
  /// x becomes m^-1 x for a factorised m and a matrix x.
  void solve(const double* factors, double* x) const noexcept {
    const std::size_t n = size();
    for (std::size_t i = 1; i < n; ++i) {
      for (std::size_t k = 0; k < i; ++k) add(-factors[i * n + k], x + k * n, x + i * n);
    }
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t k = i + 1; k < n; ++k) add(-factors[i * n + k], x + k * n, x + i * n);
      scale(factors[i * n + i], x + i * n);
    }
  }
  void solve_vector(const double* factors, double* x) const noexcept {
    const std::size_t n = size();
    for (std::size_t i = 1; i < n; ++i) {
      for (std::size_t k = 0; k < i; ++k) x[i] -= factors[i * n + k] * x[k];
    }
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t k = i + 1; k < n; ++k) x[i] -= factors[i * n + k] * x[k];
      x[i] *= factors[i * n + i];
    }
  }

 private:
  void scale(double factor, double* x) const noexcept {
    const std::size_t n = size();
    for (std::size_t i = 0; i < n; ++i) x[i] *= factor;
  }
  std::size_t size_;
};

}  // namespace nadir::atmosphere
