#include "sim/products/least_squares.hpp"

#include <cmath>
#include <stdexcept>

namespace nadir::sim {
namespace {

/// Turns rows k and below so that the column has nothing below row k.
/// @return false where it had nothing at all
bool reflect(std::vector<double>& a, std::vector<double>& b, std::size_t columns, std::size_t k) {
  const std::size_t rows = b.size();
  double norm2 = 0.0;
  for (std::size_t i = k; i < rows; ++i) norm2 += a[i * columns + k] * a[i * columns + k];
  const double norm = std::sqrt(norm2);
  if (!(norm > 0.0)) return false;
  const double pivot = a[k * columns + k];
  const double alpha = pivot > 0.0 ? -norm : norm;
  std::vector<double> v(rows - k);
  for (std::size_t i = k; i < rows; ++i) v[i - k] = a[i * columns + k];
  v[0] -= alpha;
  const double v2 = norm2 - pivot * pivot + v[0] * v[0];
  const auto turn = [&](auto&& value_at) {
    double along = 0.0;
    for (std::size_t i = k; i < rows; ++i) along += v[i - k] * value_at(i);
    for (std::size_t i = k; i < rows; ++i) value_at(i) -= 2.0 * along / v2 * v[i - k];
  };
  for (std::size_t j = k; j < columns; ++j) {
    turn([&](std::size_t i) -> double& { return a[i * columns + j]; });
  }
  turn([&](std::size_t i) -> double& { return b[i]; });
  return true;
}

}  // namespace

std::optional<std::vector<double>> least_squares(std::vector<double> a, std::vector<double> b,
                                                 std::size_t columns) {
  if (a.size() != b.size() * columns || b.size() < columns) {
    throw std::invalid_argument("least squares: sizes do not agree");
  }
  for (std::size_t k = 0; k < columns; ++k) {
    if (!reflect(a, b, columns, k)) return std::nullopt;
  }
  const double largest = std::abs(a[0]);
  std::vector<double> x(columns);
  for (std::size_t k = columns; k-- > 0;) {
    double rest = b[k];
    for (std::size_t j = k + 1; j < columns; ++j) rest -= a[k * columns + j] * x[j];
    if (std::abs(a[k * columns + k]) < 1e-15 * largest) return std::nullopt;
    x[k] = rest / a[k * columns + k];
  }
  return x;
}

}  // namespace nadir::sim
