#include "radiometry/nonnegative_factorisation.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "support/catch.hpp"
#include "support/statistics.hpp"

using namespace nadir;
using radiometry::DenseMatrix;
using radiometry::factorise;
using radiometry::NonnegativeFactors;

namespace {

DenseMatrix random_matrix(std::size_t rows, std::size_t columns, Rng& rng) {
  DenseMatrix m{rows, columns};
  for (double& x : m.values) x = rng.next();
  return m;
}

DenseMatrix product(const DenseMatrix& a, const DenseMatrix& b) {
  DenseMatrix c{a.rows, b.columns};
  for (std::size_t i = 0; i < a.rows; ++i) {
    for (std::size_t k = 0; k < a.columns; ++k) {
      for (std::size_t j = 0; j < b.columns; ++j) c.row(i)[j] += a.row(i)[k] * b.row(k)[j];
    }
  }
  return c;
}

double relative_error(const DenseMatrix& v, const NonnegativeFactors& factors) {
  const DenseMatrix fit = product(factors.w, factors.h);
  double left = 0.0, all = 0.0;
  for (std::size_t i = 0; i < v.values.size(); ++i) {
    left += std::pow(v.values[i] - fit.values[i], 2);
    all += v.values[i] * v.values[i];
  }
  return std::sqrt(left / all);
}

/// A bump that moves along the row from one row to the next: no exact low rank.
DenseMatrix moving_bump(std::size_t rows, std::size_t columns) {
  DenseMatrix m{rows, columns};
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const double x = static_cast<double>(j) / static_cast<double>(columns) -
                       static_cast<double>(i) / static_cast<double>(rows);
      m.row(i)[j] = std::exp(-20.0 * x * x);
    }
  }
  return m;
}

}  // namespace

TEST_CASE("a product of a column and a row is found as one part, exactly",
          "[radiometry][factorisation]") {
  Rng rng{support::test_seed(), 0};
  const DenseMatrix v = product(random_matrix(24, 1, rng), random_matrix(1, 200, rng));
  const NonnegativeFactors factors = factorise(v, {.tolerance = 1e-6});
  CHECK(factors.rank == 1);
  CHECK(factors.error < 1e-14);  // rounding
}

// Three parts on columns of their own: the factorisation is unique, and the worst-fitted rows are
// found in one step each.
TEST_CASE("parts that share no column are found one by one", "[radiometry][factorisation]") {
  DenseMatrix v{9, 12};
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      v.row(i)[4 * (i % 3) + j] = (1.0 + static_cast<double>(i)) * (1.0 + static_cast<double>(j));
    }
  }
  const NonnegativeFactors factors = factorise(v, {.tolerance = 1e-6});
  CHECK(factors.rank == 3);
  CHECK(factors.error < 1e-14);
}

TEST_CASE("the stated error is that of the factors, which are not negative",
          "[radiometry][factorisation]") {
  Rng rng{support::test_seed(), 1};
  const DenseMatrix v = random_matrix(17, 31, rng);  // sizes that are no multiple of anything
  for (const std::size_t limit : {1U, 4U, 16U}) {
    const NonnegativeFactors factors = factorise(v, {.tolerance = 0.0, .rank_limit = limit});
    CAPTURE(limit);
    CHECK(factors.rank == limit);
    CHECK(factors.w.rows == 17);
    CHECK(factors.w.columns == limit);
    CHECK(factors.h.rows == limit);
    CHECK(factors.h.columns == 31);
    CHECK(factors.error == Approx(relative_error(v, factors)).epsilon(1e-9));
    CHECK(*std::min_element(factors.w.values.begin(), factors.w.values.end()) >= 0.0);
    CHECK(*std::min_element(factors.h.values.begin(), factors.h.values.end()) >= 0.0);
  }
}

TEST_CASE("the rank stops where the tolerance is met, and more parts mean less error",
          "[radiometry][factorisation]") {
  const DenseMatrix v = moving_bump(24, 100);
  std::size_t rank = 0;
  double error = 1.0;
  for (const double tolerance : {0.3, 0.1, 0.05, 0.02}) {
    const NonnegativeFactors factors = factorise(v, {.tolerance = tolerance});
    CAPTURE(tolerance, factors.rank, factors.error);
    CHECK(factors.error <= tolerance);
    CHECK(factors.error < error);
    CHECK(factors.rank > rank);
    CHECK(factors.rank <= 12);
    // One part fewer does not do: the rank is not larger than it has to be.
    CHECK(factorise(v, {.tolerance = 0.0, .rank_limit = factors.rank - 1}).error > 0.9 * tolerance);
    rank = factors.rank;
    error = factors.error;
  }
}

TEST_CASE("zeros have no parts, and the same matrix gives the same factors",
          "[radiometry][factorisation]") {
  CHECK(factorise(DenseMatrix{5, 7}, {}).rank == 0);
  CHECK(factorise(DenseMatrix{5, 7}, {}).error == 0.0);
  const DenseMatrix v = moving_bump(10, 20);
  CHECK(factorise(v, {}).w.values == factorise(v, {}).w.values);
}

TEST_CASE("no rank beyond the size of the matrix is tried", "[radiometry][factorisation]") {
  Rng rng{support::test_seed(), 2};
  CHECK(factorise(random_matrix(3, 50, rng), {.tolerance = 0.0}).rank <= 3);
  CHECK(factorise(random_matrix(50, 2, rng), {.tolerance = 0.0}).rank <= 2);
}
