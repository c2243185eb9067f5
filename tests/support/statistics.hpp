#pragma once

#include <cstdint>
#include <vector>

namespace nadir::support {

/// Seed of the statistical tests: fixed, unless NADIR_TEST_SEED is set (a nightly run draws it).
[[nodiscard]] std::uint64_t test_seed();

/// Level of one of n tests that together raise a false alarm with probability alpha.
/// Source: Sidak, J. Am. Stat. Assoc. 62, 626 (1967).
[[nodiscard]] double sidak(double alpha, int n);

/// Probability that a chi-square variable of so many degrees of freedom exceeds the statistic:
/// the regularised incomplete gamma function Q(degrees / 2, statistic / 2), to 1e-12.
[[nodiscard]] double chi_square_tail(double statistic, int degrees);

/// p-value of Pearson's chi-square test of counts against their expectations. Cells in which fewer
/// than 5 are expected are pooled (Cochran's rule). The expectations sum to the number of draws.
[[nodiscard]] double chi_square_p_value(const std::vector<double>& observed,
                                        const std::vector<double>& expected);

/// The same against equal expectations.
[[nodiscard]] double chi_square_p_value(const std::vector<double>& observed);

/// Probability that a standard normal variable is at least this far from 0 on either side.
[[nodiscard]] double normal_p_value(double z);

}  // namespace nadir::support
