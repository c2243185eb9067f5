#pragma once

#include <cstddef>
#include <vector>

namespace nadir::atmosphere {

/// How one kind of scatterer spreads light over the scattering angle at one wavelength. Normalised:
/// the integral over the sphere is 1 [sr^-1]. Between its angles the logarithm runs linearly in
/// angle. Legendre coefficients chi_l = 2 pi int P p_l(cos) dcos, chi_0 = 1, chi_1 = g, so that
/// P = sum (2 l + 1) chi_l p_l / 4 pi.
class PhaseFunction {
 public:
  /// @param angles_rad  ascending, 0 to pi
  /// @param values      positive; scaled so that the integral is 1, exactly for what `at` returns
  /// @throws InputError for anything else
  /// Accuracy: moments within 1e-9 of the interpolated function's (quadrature, tested).
  PhaseFunction(std::vector<double> angles_rad, std::vector<double> values);
  /// Rayleigh scattering of unpolarised light with a depolarisation factor, 0 to 1:
  ///     P = 3 / (16 pi (1 + 2 y)) ((1 + 3 y) + (1 - y) cos^2),  y = d / (2 - d)
  ///     chi_2 = (1 - d) / (5 (2 + d)), all others but chi_0 are 0
  /// Source: Chandrasekhar, "Radiative Transfer" (1950), section 18, eqs. 254 to 258.
  [[nodiscard]] static PhaseFunction rayleigh(double depolarisation);
  /// Henyey & Greenstein, ApJ 93, 70 (1941), -1 < g < 1; closed forms, chi_l = g^l.
  [[nodiscard]] static PhaseFunction henyey_greenstein(double g);

  [[nodiscard]] double at(double cosine) const noexcept;  ///< sr^-1
  /// chi_0 to chi_(moment_count - 1).
  [[nodiscard]] const std::vector<double>& moments() const noexcept { return moments_; }
  [[nodiscard]] double asymmetry() const { return moments_[1]; }

  static constexpr int moment_count = 129;  ///< enough for 128 streams; later ones count as 0

 private:
  PhaseFunction() = default;
  void check_table() const;
  void normalise();
  void integrate_moments();
  [[nodiscard]] double slope(std::size_t interval) const;

  enum class Form { table, rayleigh, henyey_greenstein };
  Form form_ = Form::table;
  double parameter_ = 0.0;  // Rayleigh: y; Henyey & Greenstein: g
  std::vector<double> angles_, log_values_;
  std::vector<double> moments_;
};

}  // namespace nadir::atmosphere
