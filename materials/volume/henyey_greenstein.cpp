#include "materials/volume/henyey_greenstein.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::materials {
namespace {

double checked(const spectral::Curve& g, Micrometres wavelength) {
  const double value = g.at(wavelength);
  if (std::isnan(value)) {
    throw InputError{"g of the Henyey-Greenstein phase function is not tabulated at " +
                     number_text(wavelength.value) + " um"};
  }
  if (value > -1.0 && value < 1.0) return value;
  throw InputError{"g of the Henyey-Greenstein phase function is " + number_text(value) +
                   "; it must be above -1 and below 1"};
}

}  // namespace

BoundHenyeyGreenstein::BoundHenyeyGreenstein(const HenyeyGreenstein& phase,
                                             const spectral::Lanes& lanes)
    : g_{lanes.count()}, front_{lanes.count()}, start_{lanes.count()}, least_{lanes.count()} {
  for (int lane = 0; lane < lanes.count(); ++lane) {
    // Float may round g to 1: keep it one step inside.
    const auto g = std::clamp(static_cast<float>(checked(phase.g, lanes[lane])),
                              std::nextafter(-1.0F, 0.0F), std::nextafter(1.0F, 0.0F));
    const double exact = static_cast<double>(g);
    g_[lane] = g;
    front_[lane] = static_cast<float>((1.0 - exact) * (1.0 + exact) * 0.25 * std::numbers::inv_pi);
    start_[lane] = static_cast<float>((1.0 - exact) * (1.0 - exact));
    const double least = 1.0 - std::abs(exact);  // backward for g < 0, where rounding may miss it
    least_[lane] = static_cast<float>(least * least);
    grey_ = grey_ && g == g_[0];
  }
}

float BoundHenyeyGreenstein::value(int lane, float x) const noexcept {
  const float d = std::max(start_[lane] + 2.0F * g_[lane] * x, least_[lane]);
  return front_[lane] / (d * std::sqrt(d));
}

spectral::Spectrum BoundHenyeyGreenstein::eval(double x) const noexcept {
  const auto x_lane = static_cast<float>(x);
  if (grey_) return spectral::Spectrum{g_.count(), value(0, x_lane)};
  spectral::Spectrum p{g_.count()};
  for (int lane = 0; lane < p.count(); ++lane) p[lane] = value(lane, x_lane);
  return p;
}

double BoundHenyeyGreenstein::sample(double choice, double u) const noexcept {
  const int lane = std::min(static_cast<int>(choice * g_.count()), g_.count() - 1);
  const double g = static_cast<double>(g_[lane]);
  // The distribution function 1/2 (1 + cos) - 3/4 g (1 - cos^2) of small g, without g below.
  if (std::abs(g) < 1e-5) {
    const double even = 2.0 * u - 1.0;
    return std::clamp(1.0 - even - 1.5 * g * (1.0 - even * even), 0.0, 2.0);
  }
  const double s = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
  return std::clamp((s - (1.0 - g)) * (s + (1.0 - g)) / (2.0 * g), 0.0, 2.0);
}

}  // namespace nadir::materials
