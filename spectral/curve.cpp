#include "spectral/curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::spectral {
namespace {

using Table = std::vector<double>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// One message for each kind of mistake, at the first row that makes it.
std::vector<InputIssue> mistakes(const Table& wavelength_um, const Table& value) {
  std::vector<InputIssue> found;
  const auto report = [&](std::string message) {
    found.push_back({{}, std::move(message), {}, {}});
  };
  const auto row = [](auto it, const Table& table) {
    return " in row " + std::to_string(it - table.begin() + 1);
  };
  if (wavelength_um.size() < 2) {
    report("expected at least two wavelengths, found " + std::to_string(wavelength_um.size()));
  }
  if (wavelength_um.size() != value.size()) {
    report("expected one value for each of " + std::to_string(wavelength_um.size()) +
           " wavelengths, found " + std::to_string(value.size()));
  }
  const auto illegal = std::find_if(wavelength_um.begin(), wavelength_um.end(),
                                    [](double w) { return !std::isfinite(w) || w <= 0.0; });
  if (illegal != wavelength_um.end()) {
    report("expected a positive wavelength, found " + number_text(*illegal) + " um" +
           row(illegal, wavelength_um));
  }
  const auto unordered =
      std::adjacent_find(wavelength_um.begin(), wavelength_um.end(), std::greater_equal<>{});
  if (unordered != wavelength_um.end()) {
    report("expected ascending wavelengths, found " + number_text(*(unordered + 1)) + " um after " +
           number_text(*unordered) + " um" + row(unordered + 1, wavelength_um));
  }
  const auto infinite =
      std::find_if(value.begin(), value.end(), [](double v) { return !std::isfinite(v); });
  if (infinite != value.end()) {
    report("expected a finite value, found " + number_text(*infinite) + row(infinite, value));
  }
  return found;
}

double interpolate(double x, double x0, double x1, double y0, double y1) noexcept {
  const double t = (x - x0) / (x1 - x0);
  return y0 * (1.0 - t) + y1 * t;  // exact at both knots, and never outside their values
}

}  // namespace

Curve Curve::constant(double value) {
  if (!std::isfinite(value)) {
    throw InputError{"expected a finite value, found " + number_text(value)};
  }
  Curve curve;
  curve.value_ = {value};
  return curve;
}

Curve::Curve(std::vector<double> wavelength_um, std::vector<double> value, Outside outside)
    : wavelength_um_{std::move(wavelength_um)}, value_{std::move(value)}, outside_{outside} {
  auto found = mistakes(wavelength_um_, value_);
  if (!found.empty()) throw InputError{std::move(found)};
}

double Curve::at(Micrometres wavelength) const noexcept {
  if (is_constant()) return value_.front();
  const double w = wavelength.value;
  if (w >= wavelength_um_.front() && w <= wavelength_um_.back()) {
    // The last knot belongs to the last interval, hence the search stops one short of it.
    const auto right = std::upper_bound(wavelength_um_.begin() + 1, wavelength_um_.end() - 1, w);
    const auto i = static_cast<std::size_t>(right - wavelength_um_.begin());
    return interpolate(w, wavelength_um_[i - 1], *right, value_[i - 1], value_[i]);
  }
  if (std::isnan(w) || outside_ == Outside::reject) return nan;
  if (outside_ == Outside::zero) return 0.0;
  return w < wavelength_um_.front() ? value_.front() : value_.back();
}

Spectrum Curve::at(const Lanes& lanes) const {
  Spectrum spectrum{lanes.count()};
  for (int lane = 0; lane < lanes.count(); ++lane) {
    spectrum[lane] = static_cast<float>(at(lanes[lane]));
  }
  return spectrum;
}

double Curve::mean(Micrometres lo, Micrometres hi) const {
  if (!(lo <= hi)) return nan;
  if (is_constant()) return value_.front();
  if (lo == hi) return at(lo);
  if (outside_ == Outside::reject && !covers(lo, hi)) return nan;

  const double first_um = wavelength_um_.front(), last_um = wavelength_um_.back();
  double integral = 0.0;
  for (std::size_t i = 1; i < wavelength_um_.size(); ++i) {
    const double a = std::max(lo.value, wavelength_um_[i - 1]);
    const double b = std::min(hi.value, wavelength_um_[i]);
    if (a >= b) continue;
    // A straight line's mean is its value in the middle.
    integral += (b - a) * at(Micrometres{0.5 * (a + b)});
  }
  if (outside_ == Outside::hold) {
    integral += std::max(0.0, std::min(hi.value, first_um) - lo.value) * value_.front();
    integral += std::max(0.0, hi.value - std::max(lo.value, last_um)) * value_.back();
  }
  return integral / (hi - lo).value;
}

bool Curve::covers(Micrometres lo, Micrometres hi) const noexcept {
  return first() <= lo && hi <= last();
}

Micrometres Curve::first() const noexcept {
  return Micrometres{is_constant() ? 0.0 : wavelength_um_.front()};
}

Micrometres Curve::last() const noexcept {
  return Micrometres{is_constant() ? std::numeric_limits<double>::infinity()
                                   : wavelength_um_.back()};
}

double Curve::min_value() const noexcept { return *std::min_element(value_.begin(), value_.end()); }

double Curve::max_value() const noexcept { return *std::max_element(value_.begin(), value_.end()); }

}  // namespace nadir::spectral
