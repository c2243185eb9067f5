#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace nadir {

/// A value and the standard error of it. The error is NaN where there are fewer than two
/// replicates.
struct Estimate {
  double mean = 0.0;
  double standard_error = std::numeric_limits<double>::quiet_NaN();
};

/// Running mean and variance, stable for any offset.
/// Source: Welford, Technometrics 4(3), 419 (1962); merging: Chan, Golub, LeVeque (1979).
class Welford {
 public:
  constexpr void add(double x) noexcept {
    ++count_;
    const double delta = x - mean_;
    mean_ += delta / static_cast<double>(count_);
    squares_ += delta * (x - mean_);
  }
  constexpr void merge(const Welford& other) noexcept {
    if (other.count_ == 0) return;
    if (count_ == 0) {  // delta * m / m would round the mean
      *this = other;
      return;
    }
    const double n = static_cast<double>(count_), m = static_cast<double>(other.count_);
    const double delta = other.mean_ - mean_;
    mean_ += delta * m / (n + m);
    squares_ += other.squares_ + delta * delta * n * m / (n + m);
    count_ += other.count_;
  }
  [[nodiscard]] constexpr std::uint64_t count() const noexcept { return count_; }
  [[nodiscard]] constexpr double mean() const noexcept { return mean_; }
  /// Unbiased variance of one draw; NaN for fewer than two.
  [[nodiscard]] constexpr double variance() const noexcept {
    return count_ < 2 ? std::numeric_limits<double>::quiet_NaN()
                      : squares_ / static_cast<double>(count_ - 1);
  }
  [[nodiscard]] Estimate estimate() const noexcept {
    return {mean_, std::sqrt(variance() / static_cast<double>(count_))};
  }

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0.0;
  double squares_ = 0.0;
};

}  // namespace nadir
