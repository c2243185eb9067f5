#pragma once

#include <cstddef>
#include <vector>

namespace nadir::radiometry {

/// A dense matrix, row by row.
struct DenseMatrix {
  std::size_t rows = 0, columns = 0;
  std::vector<double> values;  ///< rows x columns

  DenseMatrix() = default;
  DenseMatrix(std::size_t row_count, std::size_t column_count)
      : rows{row_count}, columns{column_count}, values(row_count * column_count, 0.0) {}
  [[nodiscard]] double* row(std::size_t i) noexcept { return values.data() + i * columns; }
  [[nodiscard]] const double* row(std::size_t i) const noexcept {
    return values.data() + i * columns;
  }
};

/// V ~ W H with all entries >= 0.
struct NonnegativeFactors {
  std::size_t rank = 0;
  DenseMatrix w;       ///< rows of V x rank
  DenseMatrix h;       ///< rank x columns of V
  double error = 0.0;  ///< |V - W H| / |V|, Frobenius norms
};

struct FactorisationGoal {
  double tolerance = 0.05;      ///< error at which the rank stops to grow, >= 0
  std::size_t rank_limit = 16;  ///< never more than V has rows or columns, whatever it says
};

/// Factorises a non-negative matrix with as few parts as the tolerance allows.
///
/// The rank grows by one part at a time, which starts as what the rest leaves of its worst-fitted
/// row; a few sweeps of hierarchical alternating least squares (HALS) then improve all parts. No
/// random number is involved: the same matrix gives the same factors. A matrix of zeros has rank 0.
///
/// Source: Cichocki & Phan, "Fast Local Algorithms for Large Scale Nonnegative Matrix and Tensor
/// Factorizations", IEICE Trans. Fundamentals E92-A(3), 708 (2009); start of a part after the
/// greedy pursuits reviewed in Gillis, "The Why and How of Nonnegative Matrix Factorization"
/// (2014), arXiv:1401.5226.
/// @param v  finite, >= 0
[[nodiscard]] NonnegativeFactors factorise(const DenseMatrix& v, const FactorisationGoal& goal);

}  // namespace nadir::radiometry
