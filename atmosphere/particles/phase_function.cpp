#include "atmosphere/particles/phase_function.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/error.hpp"
#include "core/text.hpp"
#include "spectral/gauss_rule.hpp"

namespace nadir::atmosphere {
namespace {

using std::numbers::pi;

/// Sums value * p_l(cosine) for all l by the three-term recurrence: eight nodes at a time, each
/// with sums of its own, so that the compiler vectorises it.
class LegendreSums {
 public:
  explicit LegendreSums(std::size_t count) : sums_(count) {}

  void add(double cosine, double value) {
    x_[count_] = cosine;
    previous_[count_] = 0.0;
    current_[count_] = value;
    if (++count_ == lanes) flush();
  }

  [[nodiscard]] std::vector<double> totals() {
    for (; count_ < lanes; ++count_) x_[count_] = previous_[count_] = current_[count_] = 0.0;
    flush();
    std::vector<double> result;
    for (const Lanes& sum : sums_) result.push_back(std::accumulate(sum.begin(), sum.end(), 0.0));
    return result;
  }

 private:
  static constexpr std::size_t lanes = 8;
  using Lanes = std::array<double, lanes>;

  void flush() {
    for (std::size_t l = 0; l < sums_.size(); ++l) {
      // (l + 1) p_(l+1) = (2 l + 1) x p_l - l p_(l-1)
      const double b = static_cast<double>(l) / static_cast<double>(l + 1), a = 1.0 + b;
      for (std::size_t i = 0; i < lanes; ++i) {
        sums_[l][i] += current_[i];
        const double next = a * x_[i] * current_[i] - b * previous_[i];
        previous_[i] = current_[i];
        current_[i] = next;
      }
    }
    count_ = 0;
  }

  std::vector<Lanes> sums_;
  Lanes x_{}, previous_{}, current_{};
  std::size_t count_ = 0;
};

/// Integral of exp(b (t - from)) sin t over [from, to], closed form; b any.
double exponential_sine(double from, double to, double b) {
  const auto antiderivative = [b](double t) { return b * std::sin(t) - std::cos(t); };
  return (std::exp(b * (to - from)) * antiderivative(to) - antiderivative(from)) / (b * b + 1.0);
}

}  // namespace

PhaseFunction::PhaseFunction(std::vector<double> angles_rad, std::vector<double> values)
    : angles_{std::move(angles_rad)}, log_values_{std::move(values)} {
  check_table();
  for (double& value : log_values_) value = std::log(value);
  normalise();
  integrate_moments();
}

void PhaseFunction::check_table() const {
  if (angles_.size() < 2 || angles_.size() != log_values_.size()) {
    throw InputError{"a phase function needs two angles or more, and as many values"};
  }
  for (std::size_t i = 0; i < angles_.size(); ++i) {
    if (!(log_values_[i] > 0.0) || !std::isfinite(log_values_[i])) {
      throw InputError{"a phase function must be positive, found " + number_text(log_values_[i])};
    }
    if (i > 0 && !(angles_[i] > angles_[i - 1])) {
      throw InputError{"the angles of a phase function must ascend"};
    }
  }
  // 1e-9 rad: what degrees printed with ten digits are off by
  if (std::abs(angles_.front()) > 1e-9 || std::abs(angles_.back() - pi) > 1e-9) {
    throw InputError{"the angles of a phase function must reach from 0 to 180 degrees"};
  }
}

/// d ln P / d angle in an interval.
double PhaseFunction::slope(std::size_t interval) const {
  return (log_values_[interval + 1] - log_values_[interval]) /
         (angles_[interval + 1] - angles_[interval]);
}

void PhaseFunction::normalise() {
  angles_.front() = 0.0;
  angles_.back() = pi;
  // values of any size: the largest counts as 1 first
  const double largest = *std::max_element(log_values_.begin(), log_values_.end());
  double integral = 0.0;
  for (std::size_t i = 0; i + 1 < angles_.size(); ++i) {
    integral +=
        std::exp(log_values_[i] - largest) * exponential_sine(angles_[i], angles_[i + 1], slope(i));
  }
  const double shift = largest + std::log(2.0 * pi * integral);
  for (double& value : log_values_) value -= shift;
}

void PhaseFunction::integrate_moments() {
  // p_128 swings through 128 rad per rad of angle, so a piece of 0.18 rad holds 11.5 rad on either
  // side of its middle, and a Gauss rule of n nodes misses (e 11.5 / 4 n)^(2 n): 1e-17 for 24. Half
  // of such a piece: 2e-12 for 12; a quarter: 1e-11 for 8. Steep pieces are cut so that P falls by
  // e^4 at most.
  static const spectral::Rule wide = spectral::gauss_legendre(24);
  static const spectral::Rule middling = spectral::gauss_legendre(12);
  static const spectral::Rule narrow = spectral::gauss_legendre(8);
  constexpr double widest = 0.18, steepest = 4.0;
  LegendreSums sums{static_cast<std::size_t>(moment_count)};
  for (std::size_t i = 0; i + 1 < angles_.size(); ++i) {
    const double width = angles_[i + 1] - angles_[i], b = slope(i);
    const int pieces =
        static_cast<int>(std::ceil(std::max(width / widest, std::abs(b) * width / steepest)));
    const double piece = width / std::max(pieces, 1);
    const spectral::Rule& rule =
        piece > 0.5 * widest ? wide : (piece > 0.25 * widest ? middling : narrow);
    for (int k = 0; k < std::max(pieces, 1); ++k) {
      for (std::size_t n = 0; n < rule.nodes.size(); ++n) {
        const double from_start = piece * (k + 0.5 * (1.0 + rule.nodes[n]));
        const double angle = angles_[i] + from_start;
        const double value = std::exp(log_values_[i] + b * from_start);
        sums.add(std::cos(angle), 2.0 * pi * value * std::sin(angle) * piece * rule.weights[n]);
      }
    }
  }
  moments_ = sums.totals();
}

PhaseFunction PhaseFunction::rayleigh(double depolarisation) {
  if (!(depolarisation >= 0.0 && depolarisation <= 1.0)) {
    throw InputError{"the depolarisation factor must lie from 0 to 1, found " +
                     number_text(depolarisation)};
  }
  PhaseFunction result;
  result.form_ = Form::rayleigh;
  result.parameter_ = depolarisation / (2.0 - depolarisation);
  result.moments_.assign(static_cast<std::size_t>(moment_count), 0.0);
  result.moments_[0] = 1.0;
  result.moments_[2] = (1.0 - depolarisation) / (5.0 * (2.0 + depolarisation));
  return result;
}

PhaseFunction PhaseFunction::henyey_greenstein(double g) {
  if (!(g > -1.0 && g < 1.0)) {
    throw InputError{"the asymmetry of a phase function must lie between -1 and 1, found " +
                     number_text(g)};
  }
  PhaseFunction result;
  result.form_ = Form::henyey_greenstein;
  result.parameter_ = g;
  result.moments_.assign(static_cast<std::size_t>(moment_count), 1.0);
  for (std::size_t l = 1; l < result.moments_.size(); ++l) {
    result.moments_[l] = result.moments_[l - 1] * g;
  }
  return result;
}

double PhaseFunction::at(double cosine) const noexcept {
  const double x = std::clamp(cosine, -1.0, 1.0);
  if (form_ == Form::rayleigh) {
    const double y = parameter_;
    return 3.0 / (16.0 * pi * (1.0 + 2.0 * y)) * (1.0 + 3.0 * y + (1.0 - y) * x * x);
  }
  if (form_ == Form::henyey_greenstein) {
    const double g = parameter_;
    const double square =
        std::max(1.0 + g * g - 2.0 * g * x, (1.0 - std::abs(g)) * (1.0 - std::abs(g)));
    return (1.0 - g * g) / (4.0 * pi * square * std::sqrt(square));
  }
  const double angle = std::acos(x);
  const auto above = std::upper_bound(angles_.begin() + 1, angles_.end() - 1, angle);
  const auto i = static_cast<std::size_t>(above - angles_.begin() - 1);
  return std::exp(log_values_[i] + slope(i) * (angle - angles_[i]));
}

}  // namespace nadir::atmosphere
