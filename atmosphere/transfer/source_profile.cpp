#include "atmosphere/transfer/source_profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "atmosphere/transfer/mean_fade.hpp"
#include "spectral/gauss_rule.hpp"

namespace nadir::atmosphere {
namespace {

constexpr double series_below = 2.0;  // of kappa

/// int exp(-rate x) (x - 1/2)^n dx over 0 to 1 for all n.
template <std::size_t Count>
std::array<double, Count> exponential_moments(double rate) noexcept {
  std::array<double, Count> moment{};
  if (rate > 20.0) {
    // By parts: M_n = ((-1/2)^n - (1/2)^n exp(-rate) + n M_(n-1)) / rate; n < rate keeps it stable.
    const double last = std::exp(-rate);
    double power = 1.0, sign = 1.0;
    for (std::size_t n = 0; n < Count; ++n) {
      const double before = n > 0 ? static_cast<double>(n) * moment[n - 1] : 0.0;
      moment[n] = (power * (sign - last) + before) / rate;
      power *= 0.5;
      sign = -sign;
    }
    return moment;
  }
  // 16 points: relative error below 3e-12 at a rate of 20, far less below.
  static const spectral::Rule rule = spectral::gauss_legendre(16);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double s = 0.5 * rule.nodes[i];
    double term = rule.weights[i] * std::exp(-rate * (s + 0.5));
    for (double& m : moment) {
      m += term;
      term *= s;
    }
  }
  return moment;
}

template <std::size_t Count>
void divide_by_factorials(std::array<double, Count>& moment) noexcept {
  double factorial = 1.0;
  for (std::size_t n = 0; n < Count; ++n) {
    if (n > 1) factorial *= static_cast<double>(n);
    moment[n] /= factorial;
  }
}

}  // namespace

double tanh_ratio(double x) noexcept { return x > 1e-8 ? std::tanh(x) / x : 1.0; }

SourceProfile::Kappa::Kappa(double value) noexcept : kappa{value}, fade{std::exp(-value)} {
  tanh_half_ratio =
      value > series_below ? 2.0 * (1.0 - fade) / ((1.0 + fade) * value) : tanh_ratio(0.5 * value);
  inverse_cosh = 2.0 * std::sqrt(fade) / (1.0 + fade);
}

SourceProfile SourceProfile::fading(double near, double rate, bool from_top) noexcept {
  SourceProfile profile;
  profile.form_ = Form::exponential;
  profile.near_ = near;
  profile.sign_ = from_top ? 1.0 : -1.0;
  profile.rate_ = rate;
  profile.last_ = std::exp(-rate);
  profile.moment_ = exponential_moments<2 * terms>(rate);
  double factor = near;
  for (double& m : profile.moment_) {
    m *= factor;
    factor *= profile.sign_;
  }
  divide_by_factorials(profile.moment_);
  return profile;
}

SourceProfile SourceProfile::linear(double top, double bottom) noexcept {
  SourceProfile profile;
  profile.form_ = Form::linear;
  profile.near_ = 0.5 * (top + bottom);
  profile.rate_ = bottom - top;
  double power = 1.0;  // (1/2)^n
  for (std::size_t n = 0; n < 2 * terms; ++n) {
    // int s^n = (1/2)^n / (n + 1) for even n
    profile.moment_[n] = n % 2 == 0 ? profile.near_ * power / static_cast<double>(n + 1)
                                    : profile.rate_ * 0.5 * power / static_cast<double>(n + 2);
    power *= 0.5;
  }
  divide_by_factorials(profile.moment_);
  return profile;
}

SourceProfile::Response SourceProfile::series(const Kappa& of) const noexcept {
  const double square = of.kappa * of.kappa;
  Response sum;
  for (std::size_t n = 2 * terms; n > 0; n -= 2) {
    sum.even = sum.even * square + moment_[n - 2];
    sum.odd = sum.odd * square + moment_[n - 1];
  }
  return {sum.even * of.inverse_cosh, sum.odd * of.inverse_cosh};
}

SourceProfile::Response SourceProfile::response(const Kappa& of) const noexcept {
  const double kappa = of.kappa;
  if (kappa <= series_below) return series(of);
  if (form_ == Form::linear) {
    const double tanh = of.tanh_half_ratio;
    return {near_ * tanh, rate_ * (1.0 - tanh) / (kappa * kappa)};
  }
  // From the nearer end: exp(-rate x) with exp(-kappa x) and with exp(-kappa (1 - x)).
  const double along = (1.0 - last_ * of.fade) / (rate_ + kappa);
  const double difference = kappa - rate_;
  const double against = std::abs(difference) > 1.0
                             ? (last_ - of.fade) / difference
                             : std::max(last_, of.fade) * mean_fade(std::abs(difference));
  const double scale = near_ / (1.0 + of.fade);
  return {scale * (along + against), sign_ * scale * (against - along) / kappa};
}

}  // namespace nadir::atmosphere
