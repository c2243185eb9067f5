#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"
#include "sensor/detector/detector.hpp"

namespace nadir::sensor {
namespace {

void check_figure(const NoiseFigure& figure) {
  if (!std::isfinite(figure.radiance) || figure.radiance < 0.0) {
    throw InputError{"expected noise at a radiance of at least 0, found " +
                     number_text(figure.radiance)};
  }
  if (!std::isfinite(figure.sigma) || !(figure.sigma > 0.0)) {
    throw InputError{"expected a positive noise, found " + number_text(figure.sigma) +
                     " at radiance " + number_text(figure.radiance)};
  }
}

/// The law variance = constant + slope L.
struct Line {
  double constant = 0.0, slope = 0.0;
};

/// FitMoments of the relative residuals: row i of the system is (1, L_i) / variance_i against 1, so
/// that the least noise counts as much as the greatest.
struct FitMoments {
  double aa = 0.0, ab = 0.0, bb = 0.0, a1 = 0.0, b1 = 0.0;
};

FitMoments moments_of(const std::vector<NoiseFigure>& figures) {
  FitMoments m;
  for (const NoiseFigure& figure : figures) {
    const double a = 1.0 / (figure.sigma * figure.sigma), b = figure.radiance * a;
    m.aa += a * a;
    m.ab += a * b;
    m.bb += b * b;
    m.a1 += a;
    m.b1 += b;
  }
  return m;
}

/// Sum of squares of the residuals, without its constant.
double cost(const FitMoments& m, const Line& line) noexcept {
  const double a = line.constant, b = line.slope;
  return a * a * m.aa + 2.0 * a * b * m.ab + b * b * m.bb - 2.0 * (a * m.a1 + b * m.b1);
}

/// Non-negative least squares of two unknowns: the free minimum, or the better one of the two
/// edges.
Line fit_line(const FitMoments& m) noexcept {
  const double determinant = m.aa * m.bb - m.ab * m.ab;
  const Line free{(m.a1 * m.bb - m.b1 * m.ab) / determinant,
                  (m.b1 * m.aa - m.a1 * m.ab) / determinant};
  if (free.constant >= 0.0 && free.slope >= 0.0) return free;
  const Line flat{m.a1 / m.aa, 0.0}, steep{0.0, m.b1 / m.bb};
  return cost(m, flat) <= cost(m, steep) ? flat : steep;
}

/// Half of the variance from each term; all of it constant where there is no light.
Line split(double variance, double radiance) noexcept {
  if (radiance == 0.0) return {variance, 0.0};
  return {0.5 * variance, 0.5 * variance / radiance};
}

}  // namespace

PublishedNoise fit_noise(const std::vector<NoiseFigure>& figures) {
  if (figures.empty()) throw InputError{"expected at least one figure of noise, found none"};
  std::for_each(figures.begin(), figures.end(), check_figure);
  const double radiance = figures.front().radiance;
  const bool one_radiance =
      std::all_of(figures.begin(), figures.end(),
                  [&](const NoiseFigure& figure) { return figure.radiance == radiance; });
  const FitMoments m = moments_of(figures);
  const Line line = one_radiance ? split(m.a1 / m.aa, radiance) : fit_line(m);
  return {std::sqrt(line.constant), line.slope};
}

}  // namespace nadir::sensor
