#include "sim/products/rpc_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/products/least_squares.hpp"

namespace nadir::sim {
namespace {

using Terms = std::array<double, 20>;

constexpr std::size_t unknowns = 39;  // the denominator's first term is 1
constexpr int turns = 8;              // of the weights: they settle in three or four
constexpr double least_denominator = 0.05;

Terms terms_of(const Rpc& rpc, const geometry::Geodetic& place) {
  // Longitudes are counted the short way round.
  const double east = std::remainder(place.longitude_deg - rpc.longitude_off, 360.0);
  const double l = east / rpc.longitude_scale;
  const double p = (place.latitude_deg - rpc.latitude_off) / rpc.latitude_scale;
  const double h = (place.height_m - rpc.height_off) / rpc.height_scale;
  return {1.0,       l,         p,         h,         l * p,     l * h,     p * h,
          l * l,     p * p,     h * h,     p * l * h, l * l * l, l * p * p, l * h * h,
          l * l * p, p * p * p, p * h * h, l * l * h, p * p * h, h * h * h};
}

double sum(const Terms& coefficients, const Terms& terms) {
  double total = 0.0;
  for (std::size_t i = 0; i < terms.size(); ++i) total += coefficients[i] * terms[i];
  return total;
}

/// Middle and half range.
struct Interval {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -std::numeric_limits<double>::infinity();
  void take(double value) {
    lo = std::min(lo, value);
    hi = std::max(hi, value);
  }
  [[nodiscard]] double middle() const { return 0.5 * (lo + hi); }
  [[nodiscard]] double half(double least) const { return std::max(0.5 * (hi - lo), least); }
};

Rpc normalised_over(const std::vector<RpcPoint>& points) {
  Interval sample, line, latitude, longitude, height;
  const double first = points.front().place.longitude_deg;
  for (const RpcPoint& point : points) {
    sample.take(point.image.x);
    line.take(point.image.y);
    latitude.take(point.place.latitude_deg);
    longitude.take(first + std::remainder(point.place.longitude_deg - first, 360.0));
    height.take(point.place.height_m);
  }
  Rpc rpc;
  rpc.sample_off = sample.middle();
  rpc.sample_scale = sample.half(0.5);
  rpc.line_off = line.middle();
  rpc.line_scale = line.half(0.5);
  rpc.latitude_off = latitude.middle();
  rpc.latitude_scale = latitude.half(1e-9);
  rpc.longitude_off = std::remainder(longitude.middle(), 360.0);
  rpc.longitude_scale = longitude.half(1e-9);
  rpc.height_off = height.middle();
  rpc.height_scale = height.half(1e-3);
  return rpc;
}

/// One image coordinate's numerator and denominator.
struct Ratio {
  Terms numerator{}, denominator{};
};

/// N - y D = y-part of D's first term, for every point, over the last denominator.
std::optional<Ratio> solve_ratio(const std::vector<Terms>& terms, const std::vector<double>& y,
                                 double regularisation) {
  Ratio ratio;
  ratio.denominator[0] = 1.0;
  const std::size_t rows = terms.size() + unknowns;
  for (int turn = 0; turn < turns; ++turn) {
    std::vector<double> a(rows * unknowns, 0.0), b(rows, 0.0);
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const double weight = 1.0 / sum(ratio.denominator, terms[i]);
      for (std::size_t j = 0; j < 20; ++j) a[i * unknowns + j] = weight * terms[i][j];
      for (std::size_t j = 1; j < 20; ++j) {
        a[i * unknowns + 19 + j] = -weight * y[i] * terms[i][j];
      }
      b[i] = weight * y[i];
    }
    for (std::size_t j = 0; j < unknowns; ++j) {
      a[(terms.size() + j) * unknowns + j] = regularisation;
    }
    const auto x = least_squares(std::move(a), std::move(b), unknowns);
    if (!x) return std::nullopt;
    std::copy_n(x->begin(), 20, ratio.numerator.begin());
    std::copy_n(x->begin() + 20, 19, ratio.denominator.begin() + 1);
    const bool clear = std::all_of(terms.begin(), terms.end(), [&](const Terms& t) {
      return sum(ratio.denominator, t) > least_denominator;
    });
    if (!clear) return std::nullopt;
  }
  return ratio;
}

std::optional<RpcFit> fit_with(Rpc rpc, const std::vector<RpcPoint>& points,
                               const std::vector<RpcPoint>& checks, double regularisation) {
  std::vector<Terms> terms;
  std::vector<double> lines, samples;
  for (const RpcPoint& point : points) {
    terms.push_back(terms_of(rpc, point.place));
    lines.push_back((point.image.y - rpc.line_off) / rpc.line_scale);
    samples.push_back((point.image.x - rpc.sample_off) / rpc.sample_scale);
  }
  const auto line = solve_ratio(terms, lines, regularisation);
  const auto sample = solve_ratio(terms, samples, regularisation);
  if (!line || !sample) return std::nullopt;
  rpc.line_numerator = line->numerator;
  rpc.line_denominator = line->denominator;
  rpc.sample_numerator = sample->numerator;
  rpc.sample_denominator = sample->denominator;
  RpcFit fit{rpc};
  double squares = 0.0;
  for (const RpcPoint& check : checks) {
    const Vec2 found = image_of(rpc, check.place);
    const double off = std::hypot(found.x - check.image.x, found.y - check.image.y);
    squares += off * off;
    fit.largest_px = std::max(fit.largest_px, off);
  }
  fit.rms_px = std::sqrt(squares / static_cast<double>(checks.size()));
  return fit;
}

}  // namespace

Vec2 image_of(const Rpc& rpc, const geometry::Geodetic& place) {
  const Terms terms = terms_of(rpc, place);
  return {rpc.sample_off + rpc.sample_scale * sum(rpc.sample_numerator, terms) /
                               sum(rpc.sample_denominator, terms),
          rpc.line_off +
              rpc.line_scale * sum(rpc.line_numerator, terms) / sum(rpc.line_denominator, terms)};
}

std::optional<RpcFit> fit_rpc(const std::vector<RpcPoint>& points,
                              const std::vector<RpcPoint>& checks) {
  if (points.size() < least_rpc_points || checks.empty()) return std::nullopt;
  const Rpc rpc = normalised_over(points);
  std::vector<RpcFit> fits;
  for (const double regularisation : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    if (const auto fit = fit_with(rpc, points, checks, regularisation)) fits.push_back(*fit);
  }
  if (fits.empty()) return std::nullopt;
  const auto least = std::min_element(fits.begin(), fits.end(), [](const auto& a, const auto& b) {
    return a.largest_px < b.largest_px;
  });
  // A thousandth of a pixel is as good as nothing.
  const double enough = std::max(1.5 * least->largest_px, 1e-3);
  return *std::find_if(fits.begin(), fits.end(),
                       [&](const RpcFit& fit) { return fit.largest_px <= enough; });
}

}  // namespace nadir::sim
