#include "sensor/optics/annular_aperture.hpp"

#include <math.h>  // j0 and j1 of POSIX: several times faster than std::cyl_bessel_j

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nadir::sensor {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double step = 1.0 / 16.0;  // rings are pi apart: fifty steps from dark to dark

/// 2 J1(x) / x.
double jinc(double x) { return x < 1e-6 ? 1.0 : 2.0 * ::j1(x) / x; }

/// Share of a clear aperture's light within x: Rayleigh's 1 - J0^2 - J1^2.
double clear_share(double x) {
  const double a = ::j0(x), b = ::j1(x);
  return 1.0 - a * a - b * b;
}

}  // namespace

AnnularAperture::AnnularAperture(double obscuration) : e_{obscuration} {
  // E(x) = [S(x) + e^2 S(e x) - 4 e int_0^x J1(t) J1(e t) / t dt] / (1 - e^2), S: clear_share.
  const auto steps = static_cast<int>(reach / step);
  const auto mixed = [&](double t) { return t == 0.0 ? 0.0 : ::j1(t) * ::j1(e_ * t) / t; };
  double integral = 0.0;  // by Simpson's rule, step by step: 1e-9
  encircled_.push_back(0.0);
  for (int i = 0; i < steps; ++i) {
    const double a = i * step, b = a + step;
    integral += step / 6.0 * (mixed(a) + 4.0 * mixed(0.5 * (a + b)) + mixed(b));
    encircled_.push_back((clear_share(b) + e_ * e_ * clear_share(e_ * b) - 4.0 * e_ * integral) /
                         (1.0 - e_ * e_));
  }
  const double beyond = 1.0 - encircled_.back();
  // The share of the light beyond that has a place within x.
  const auto taken_in = [](double x) { return std::max(0.0, 2.0 * x / reach - 1.0); };
  double former = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double x = i * step;
    const double amplitude = jinc(x) - e_ * e_ * jinc(e_ * x);
    const double from_beyond = x > 0.5 * reach ? beyond / (pi * reach * x) : 0.0;
    density_.push_back(amplitude * amplitude / (4.0 * pi * (1.0 - e_ * e_)) + from_beyond);
    double& share = encircled_[static_cast<std::size_t>(i)];
    // Rounding may not let a share fall.
    former = share = std::min(1.0, std::max(former, share + beyond * taken_in(x)));
  }
  encircled_.back() = 1.0;
  int cell = 0;
  for (std::size_t i = 0; i < guide_.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(bins);
    while (cell + 1 < steps && encircled_[static_cast<std::size_t>(cell) + 1] <= share) ++cell;
    guide_[i] = cell;
  }
}

double AnnularAperture::density(double x) const noexcept {
  if (x >= reach) return 0.0;
  const auto cell = static_cast<std::size_t>(x / step);
  const double within = x / step - static_cast<double>(cell);
  return density_[cell] + within * (density_[cell + 1] - density_[cell]);
}

double AnnularAperture::encircled(double x) const noexcept {
  if (x >= reach) return 1.0;
  const auto cell = static_cast<std::size_t>(x / step);
  const double a = static_cast<double>(cell) * step, b = a + step;
  const double within = (x * x - a * a) / (b * b - a * a);
  return encircled_[cell] + within * (encircled_[cell + 1] - encircled_[cell]);
}

double AnnularAperture::distance(double share) const noexcept {
  const auto bin = std::min(static_cast<std::size_t>(share * static_cast<double>(bins)), bins - 1);
  const auto first = encircled_.begin() + guide_[bin] + 1;
  const auto last = encircled_.begin() + guide_[bin + 1] + 1;
  const auto cell =
      static_cast<std::size_t>(std::upper_bound(first, last, share) - encircled_.begin()) - 1;
  const double lo = encircled_[cell], hi = encircled_[cell + 1];
  const double within = hi > lo ? std::clamp((share - lo) / (hi - lo), 0.0, 1.0) : 0.5;
  // Inside a step the light goes with the area, x^2, as it does in the middle.
  const double a = static_cast<double>(cell) * step, b = a + step;
  return std::sqrt(a * a + within * (b * b - a * a));
}

double AnnularAperture::mtf(double rho) const noexcept {
  if (rho >= 1.0) return 0.0;
  // Overlap of two discs of diameters 1 and `ratio` whose centres are rho apart, as a share of
  // pi / 4: of the aperture with itself, with the obscuration (twice), of the obscuration with
  // itself.
  const auto overlap = [&](double ratio) {
    const double near = 0.5 * (1.0 - ratio), far = 0.5 * (1.0 + ratio);
    if (rho <= near) return ratio * ratio;
    if (rho >= far) return 0.0;
    const double R = 0.5, r = 0.5 * ratio;  // lens of two circles
    const double a = (rho * rho + R * R - r * r) / (2.0 * rho * R);
    const double b = (rho * rho + r * r - R * R) / (2.0 * rho * r);
    const double area =
        R * R * std::acos(std::clamp(a, -1.0, 1.0)) + r * r * std::acos(std::clamp(b, -1.0, 1.0)) -
        0.5 * std::sqrt(std::max(0.0, (far - rho) * (rho - near) * (rho + near) * (rho + far)));
    return area / (0.25 * pi);
  };
  const auto with_itself = [&](double diameter) {
    const double q = rho / diameter;
    if (diameter == 0.0 || q >= 1.0) return 0.0;
    return diameter * diameter * (2.0 / pi) * (std::acos(q) - q * std::sqrt(1.0 - q * q));
  };
  if (e_ == 0.0) return with_itself(1.0);
  return std::max(0.0, (with_itself(1.0) - 2.0 * overlap(e_) + with_itself(e_)) / (1.0 - e_ * e_));
}

}  // namespace nadir::sensor
