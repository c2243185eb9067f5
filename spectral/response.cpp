#include "spectral/response.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/error.hpp"
#include "core/text.hpp"
#include "spectral/wavelength_text.hpp"

namespace nadir::spectral {
namespace {

constexpr double cut_level = 1e-4;

/// Where the Gaussian falls to cut_level, in units of its fwhm: sqrt(-ln(level) / (4 ln 2)).
double cut_distance() noexcept {
  return std::sqrt(-std::log(cut_level) / (4.0 * std::numbers::ln2));
}

double value_at(const TabulatedResponse& table, Micrometres wavelength) noexcept {
  return table.curve.covers(wavelength, wavelength) ? table.curve.at(wavelength) : 0.0;
}
double value_at(const GaussianResponse& g, Micrometres wavelength) noexcept {
  const double u = (wavelength - g.centre) / g.fwhm;
  return std::abs(u) > cut_distance() ? 0.0 : std::exp(-4.0 * std::numbers::ln2 * u * u);
}
double value_at(const BoxResponse& box, Micrometres wavelength) noexcept {
  return wavelength >= box.lo && wavelength <= box.hi ? 1.0 : 0.0;
}

Support support_of(const TabulatedResponse& table) noexcept {
  const auto& w = table.curve.wavelengths_um();
  const auto& r = table.curve.values();
  const auto positive = [](double value) { return value > 0.0; };
  const auto first = std::find_if(r.begin(), r.end(), positive) - r.begin();
  const auto last = r.rend() - std::find_if(r.rbegin(), r.rend(), positive) - 1;
  // The line to the neighbour, which is 0, belongs to the support.
  const auto lo = static_cast<std::size_t>(std::max<std::ptrdiff_t>(first - 1, 0));
  const auto hi = std::min(static_cast<std::size_t>(last) + 1, w.size() - 1);
  return {Micrometres{w[lo]}, Micrometres{w[hi]}};
}
Support support_of(const GaussianResponse& g) noexcept {
  const Micrometres reach = cut_distance() * g.fwhm;
  return {g.centre - reach, g.centre + reach};
}
Support support_of(const BoxResponse& box) noexcept { return {box.lo, box.hi}; }

/// Exact for the piecewise linear response: a segment from (a, p) to (b, q) has the area
/// (b - a) (p + q) / 2 and the first moment about a (b - a)^2 (p + 2 q) / 6.
Micrometres centre_of(const TabulatedResponse& table) {
  const auto& w = table.curve.wavelengths_um();
  const auto& r = table.curve.values();
  double area = 0.0, moment = 0.0;  // about the first wavelength, for precision in narrow bands
  for (std::size_t i = 1; i < w.size(); ++i) {
    const double step = w[i] - w[i - 1];
    const double segment = 0.5 * step * (r[i - 1] + r[i]);
    area += segment;
    moment += (w[i - 1] - w.front()) * segment + step * step * (r[i - 1] + 2.0 * r[i]) / 6.0;
  }
  return Micrometres{w.front() + moment / area};
}
Micrometres centre_of(const GaussianResponse& g) { return g.centre; }
Micrometres centre_of(const BoxResponse& box) { return 0.5 * (box.lo + box.hi); }

double crossing(double level, double w_below, double r_below, double w_above, double r_above) {
  return w_below + (w_above - w_below) * (level - r_below) / (r_above - r_below);
}

Micrometres fwhm_of(const TabulatedResponse& table) {
  const auto& w = table.curve.wavelengths_um();
  const auto& r = table.curve.values();
  const double half = 0.5 * table.curve.max_value();
  std::size_t first = 0, last = r.size() - 1;
  while (r[first] < half) ++first;
  while (r[last] < half) --last;
  const double lo =
      first == 0 ? w[0] : crossing(half, w[first - 1], r[first - 1], w[first], r[first]);
  const double hi =
      last + 1 == r.size() ? w[last] : crossing(half, w[last + 1], r[last + 1], w[last], r[last]);
  return Micrometres{hi - lo};
}
Micrometres fwhm_of(const GaussianResponse& g) { return g.fwhm; }
Micrometres fwhm_of(const BoxResponse& box) { return box.hi - box.lo; }

bool is_positive(Micrometres wavelength) {
  return std::isfinite(wavelength.value) && wavelength.value > 0.0;
}

void check_one(const TabulatedResponse& table) {
  if (table.curve.is_constant()) {
    throw InputError{"expected a response with limits, found one that is the same everywhere"};
  }
  if (table.curve.min_value() < 0.0) {
    throw InputError{"expected a response of at least 0, found " +
                     number_text(table.curve.min_value())};
  }
  if (table.curve.max_value() <= 0.0) {
    throw InputError{"expected a response above 0 somewhere, found 0 at every wavelength"};
  }
}
/// Narrower bands than this have no wavelengths of their own left in double precision.
void check_width(Micrometres width, Micrometres at) {
  if (width.value > 1e-9 * at.value) return;
  throw InputError{"expected a response wider than 1e-9 of its wavelength, found a width of " +
                   wavelength_text(width) + " at " + wavelength_text(at)};
}
void check_one(const GaussianResponse& g) {
  if (!is_positive(g.fwhm)) {
    throw InputError{"expected a positive full width at half maximum, found " +
                     wavelength_text(g.fwhm)};
  }
  check_width(g.fwhm, g.centre);
  const Support s = support_of(g);
  if (!is_positive(s.lo) || !std::isfinite(s.hi.value)) {
    throw InputError{"expected a Gaussian response at positive wavelengths, found one from " +
                     wavelength_text(s.lo) + " to " + wavelength_text(s.hi) + " (centre " +
                     wavelength_text(g.centre) + ", fwhm " + wavelength_text(g.fwhm) + ")"};
  }
}
void check_one(const BoxResponse& box) {
  if (is_positive(box.lo) && std::isfinite(box.hi.value) && box.lo < box.hi) {
    check_width(box.hi - box.lo, box.hi);
    return;
  }
  throw InputError{"expected positive, ascending limits of a box response, found " +
                   wavelength_text(box.lo) + " and " + wavelength_text(box.hi)};
}

}  // namespace

void check(const Response& response) {
  std::visit([](const auto& r) { check_one(r); }, response);
}
double at(const Response& response, Micrometres wavelength) {
  return std::visit([&](const auto& r) { return value_at(r, wavelength); }, response);
}
Support support(const Response& response) {
  return std::visit([](const auto& r) { return support_of(r); }, response);
}
Micrometres centre(const Response& response) {
  return std::visit([](const auto& r) { return centre_of(r); }, response);
}
Micrometres fwhm(const Response& response) {
  return std::visit([](const auto& r) { return fwhm_of(r); }, response);
}

}  // namespace nadir::spectral
