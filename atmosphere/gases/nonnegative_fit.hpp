#pragma once

#include <cstddef>
#include <vector>

namespace nadir::atmosphere {

/// Least squares with no negative unknown: the active set method of Lawson & Hanson, Solving Least
/// Squares Problems (1974), chapter 23, on the normal equations, held near the first guess by a
/// weak pull that keeps them solvable.
class NonnegativeFit {
 public:
  explicit NonnegativeFit(std::size_t unknowns);

  /// One equation: row . x = value, counted `weight` times.
  void add(const std::vector<double>& row, double value, double weight);
  /// @param guess  none negative
  [[nodiscard]] std::vector<double> solve(std::vector<double> guess) const;

 private:
  [[nodiscard]] std::vector<double> unconstrained(const std::vector<std::size_t>& free,
                                                  const std::vector<double>& right) const;
  void settle(std::vector<std::size_t>& free, const std::vector<double>& right,
              std::vector<double>& x) const;
  [[nodiscard]] std::size_t wanted(const std::vector<double>& right,
                                   const std::vector<double>& x) const;

  std::size_t n_;
  std::vector<double> matrix_, right_;
};

}  // namespace nadir::atmosphere
