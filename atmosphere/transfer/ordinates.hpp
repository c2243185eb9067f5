#pragma once

#include <cstddef>
#include <vector>

namespace nadir::atmosphere {

/// Directions of a discrete-ordinate solution: Gauss's rule on either hemisphere by itself ("double
/// Gauss"), which takes the jump of radiance at the horizon for what it is. The weights sum to 1.
/// Source: Sykes, Mon. Not. R. Astron. Soc. 111, 377 (1951); Stamnes et al., Appl. Opt. 27, 2502
/// (1988).
struct Ordinates {
  std::vector<double> mu;  ///< ascending within 0 to 1
  std::vector<double> weight;
};

/// @param streams  even; half of them go up
[[nodiscard]] Ordinates double_gauss(int streams);

/// Associated Legendre functions of one order m for the degrees m to degrees - 1, normalised as
///
///     Lambda_l^m(mu) = sqrt((l - m)! / (l + m)!) P_l^m(mu),   without the sign (-1)^m,
///
/// at several cosines. For all of them |Lambda| <= 1, and
/// p_l(cos Theta) = sum_m (2 - delta_0m) Lambda_l^m(mu) Lambda_l^m(mu') cos m(phi - phi').
/// Source: Dave & Armstrong, JQSRT 10, 557 (1970).
class LegendreTable {
 public:
  LegendreTable(int order, int degrees, const std::vector<double>& mu);

  /// Lambda_l^m at all cosines.
  [[nodiscard]] const double* row(int degree) const noexcept {
    return values_.data() + static_cast<std::size_t>(degree - order_) * count_;
  }

 private:
  int order_;
  std::size_t count_;
  std::vector<double> values_;  // [degree - order][cosine]
};

}  // namespace nadir::atmosphere
