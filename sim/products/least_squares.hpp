#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace nadir::sim {

/// The x that makes |A x - b| least, by Householder reflections (Golub and Van Loan, "Matrix
/// Computations", 5.3.2); A by rows, full rank, at least as many rows as columns.
/// @return none where a column depends on the others to within rounding
[[nodiscard]] std::optional<std::vector<double>> least_squares(std::vector<double> a,
                                                               std::vector<double> b,
                                                               std::size_t columns);

}  // namespace nadir::sim
