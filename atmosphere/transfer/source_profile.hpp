#pragma once

#include <array>
#include <cstddef>

namespace nadir::atmosphere {

/// tanh(x) / x, with its limit 1 at 0.
[[nodiscard]] double tanh_ratio(double x) noexcept;

/// How the strength of a source runs through one layer, and what a pair of discrete-ordinate
/// eigensolutions exp(+-k tau) makes of it. With s = -1/2 at the top of the layer and 1/2 at its
/// bottom, and kappa = k times the layer's depth:
///
///     even(kappa) = int e(s) cosh(kappa s) ds / cosh(kappa / 2)
///     odd(kappa)  = int e(s) sinh(kappa s) ds / (kappa cosh(kappa / 2))
///
/// Both are entire functions of kappa^2, so that neither conservative scattering (k = 0) nor a beam
/// that fades just like an eigensolution is a special case. No growing exponential is formed.
/// Relative accuracy 1e-11 of the larger of the two.
class SourceProfile {
 public:
  /// What of an eigensolution is needed, computed once for all sources.
  struct Kappa {
    explicit Kappa(double value) noexcept;
    double kappa, fade;      ///< fade = exp(-kappa)
    double tanh_half_ratio;  ///< tanh(kappa / 2) / (kappa / 2)
    double inverse_cosh;     ///< 1 / cosh(kappa / 2), where it is needed: for small kappa
  };
  struct Response {
    double even = 0.0, odd = 0.0;
  };

  SourceProfile() = default;  ///< no source
  /// Exponential from the strength `near` at one edge of the layer down to near exp(-rate) at the
  /// other. @param rate  not negative
  [[nodiscard]] static SourceProfile fading(double near, double rate, bool from_top) noexcept;
  [[nodiscard]] static SourceProfile linear(double top, double bottom) noexcept;

  [[nodiscard]] bool empty() const noexcept { return form_ == Form::none; }
  [[nodiscard]] Response response(const Kappa& of) const noexcept;

 private:
  enum class Form { none, exponential, linear };
  static constexpr std::size_t terms = 10;  // (kappa / 2)^20 / 20! is below 1e-18 up to kappa = 2

  Form form_ = Form::none;
  double near_ = 0.0;  // the larger strength; linear: the strength in the middle
  double sign_ = 1.0;  // 1 where the larger is at the top
  double rate_ = 0.0;  // linear: strength at the bottom less that at the top
  double last_ = 0.0;  // exp(-rate)
  std::array<double, 2 * terms> moment_{};  // int e(s) s^n ds / n!

  [[nodiscard]] Response series(const Kappa& of) const noexcept;
};

}  // namespace nadir::atmosphere
