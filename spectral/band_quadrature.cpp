#include "spectral/band_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "spectral/gauss_rule.hpp"
#include "spectral/planck.hpp"

namespace nadir::spectral {
namespace {

constexpr int most_wavelengths = 32;

/// Edges between which the response is smooth, from one end of its support to the other: the knots
/// of a table, or equal panels.
std::vector<double> panel_edges(const Response& response) {
  const Support s = support(response);
  if (const auto* table = std::get_if<TabulatedResponse>(&response)) {
    std::vector<double> edges;
    for (const double w : table->curve.wavelengths_um()) {
      if (w >= s.lo.value && w <= s.hi.value) edges.push_back(w);
    }
    return edges;
  }
  constexpr int panels = 8;  // the Gaussian's exponent changes by at most 4 in each
  std::vector<double> edges;
  for (int i = 0; i <= panels; ++i)
    edges.push_back(std::lerp(s.lo.value, s.hi.value, i / double{panels}));
  return edges;
}

/// The response as a discrete measure on [-1, 1], which stands for its support. Between two knots a
/// table is linear, so that products of degree 2 n - 1 with it are integrated exactly.
Rule discretised(const Response& response, int count) {
  const Rule gauss = gauss_legendre(count + 8);
  const std::vector<double> edges = panel_edges(response);
  const double middle = std::midpoint(edges.front(), edges.back());
  const double half = 0.5 * (edges.back() - edges.front());
  Rule measure;
  for (std::size_t k = 1; k < edges.size(); ++k) {
    const double panel_middle = std::midpoint(edges[k - 1], edges[k]);
    const double panel_half = 0.5 * (edges[k] - edges[k - 1]);
    for (std::size_t i = 0; i < gauss.nodes.size(); ++i) {
      const double lambda_um = panel_middle + panel_half * gauss.nodes[i];
      const double weight = gauss.weights[i] * panel_half * at(response, Micrometres{lambda_um});
      if (weight <= 0.0) continue;
      measure.nodes.push_back((lambda_um - middle) / half);
      measure.weights.push_back(weight);
    }
  }
  return measure;
}

double band_radiance(const BandQuadrature& band, Kelvin temperature) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < band.weights.size(); ++i) {
    sum += band.weights[i] * planck(band.wavelengths[i], temperature).value;
  }
  return sum;
}

double band_derivative(const BandQuadrature& band, Kelvin temperature) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < band.weights.size(); ++i) {
    sum += band.weights[i] * planck_derivative(band.wavelengths[i], temperature);
  }
  return sum;
}

/// Temperatures between which the band's lies: those of its wavelengths, as its radiance is a mean
/// of theirs.
struct Bracket {
  double lo, hi;
};
Bracket temperature_bracket(const BandQuadrature& band, SpectralRadiance radiance) noexcept {
  Bracket bracket{std::numeric_limits<double>::infinity(), 0.0};
  for (const Micrometres wavelength : band.wavelengths) {
    const double t = brightness_temperature(wavelength, radiance).value;
    bracket.lo = std::min(bracket.lo, t);
    bracket.hi = std::max(bracket.hi, t);
  }
  return bracket;
}

/// Newton's step for ln L as a function of 1 / T, where Wien's law is a straight line; NaN where
/// the Planck function has underflowed.
double newton_step(double t, double wanted, double found, double derivative) noexcept {
  if (!(found > 0.0 && derivative > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return t / (1.0 - std::log(wanted / found) * found / (derivative * t));
}

/// The integral of a response over [lo, hi] of a panel in which it is smooth.
double panel_integral(const Response& response, double lo, double hi) {
  static const Rule gauss = gauss_legendre(16);  // exact for tables; 1e-15 for an 8th of a Gaussian
  double sum = 0.0;
  for (std::size_t i = 0; i < gauss.nodes.size(); ++i) {
    const double lambda_um = std::lerp(lo, hi, 0.5 * (gauss.nodes[i] + 1.0));
    sum += gauss.weights[i] * at(response, Micrometres{lambda_um});
  }
  return sum * 0.5 * (hi - lo);
}

/// Where in [lo, hi] the integral from lo has grown to `wanted`.
double quantile_in_panel(const Response& response, double lo, double hi, double wanted) {
  double below = lo, above = hi;
  for (int i = 0; i < 60; ++i) {  // halving to the last bit
    const double middle = std::midpoint(below, above);
    (panel_integral(response, lo, middle) < wanted ? below : above) = middle;
  }
  return std::midpoint(below, above);
}

/// Which lane of which block is the n-th of all.
SpectralPlan::Term term_of(std::ptrdiff_t n, double weight) {
  return {static_cast<int>(n / lane_capacity), static_cast<int>(n % lane_capacity), weight};
}

}  // namespace

std::vector<Micrometres> interval_edges(const Response& response, const BandQuadrature& band) {
  const std::vector<double> panels = panel_edges(response);
  std::vector<double> grown{0.0};
  for (std::size_t k = 1; k < panels.size(); ++k) {
    grown.push_back(grown.back() + panel_integral(response, panels[k - 1], panels[k]));
  }
  std::vector<Micrometres> edges{Micrometres{panels.front()}};
  double share = 0.0;
  for (std::size_t i = 0; i + 1 < band.weights.size(); ++i) {
    share += band.weights[i];
    const double wanted = share * grown.back();
    const auto next = std::upper_bound(grown.begin() + 1, grown.end() - 1, wanted);
    const auto k = static_cast<std::size_t>(next - grown.begin());
    edges.emplace_back(
        quantile_in_panel(response, panels[k - 1], panels[k], wanted - grown[k - 1]));
  }
  edges.emplace_back(panels.back());
  return edges;
}

BandQuadrature gauss_quadrature(const Response& response, int count) {
  if (count < 1 || count > most_wavelengths) {
    throw InputError{"expected 1 to " + std::to_string(most_wavelengths) +
                     " wavelengths for a band, found " + std::to_string(count)};
  }
  check(response);
  const Rule rule = gauss_rule(stieltjes(discretised(response, count), count), -1.0, 1.0);
  const double sum = std::accumulate(rule.weights.begin(), rule.weights.end(), 0.0);
  const Support s = support(response);
  BandQuadrature band;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    band.wavelengths.emplace_back(std::lerp(s.lo.value, s.hi.value, 0.5 * (rule.nodes[i] + 1.0)));
    band.weights.push_back(rule.weights[i] / sum);
  }
  return band;
}

Kelvin band_brightness_temperature(const BandQuadrature& band, SpectralRadiance radiance) noexcept {
  const double wanted = radiance.value;
  if (band.wavelengths.empty() || !(wanted >= 0.0)) {
    return Kelvin{std::numeric_limits<double>::quiet_NaN()};
  }
  if (wanted == 0.0) return Kelvin{0.0};
  Bracket bracket = temperature_bracket(band, radiance);
  constexpr double converged = 1e-15;  // relative; a few steps of the last bit
  double t = std::midpoint(bracket.lo, bracket.hi);
  // Newton needs 3 to 5 steps; 100 are enough for halving alone.
  for (int i = 0; i < 100 && bracket.hi - bracket.lo > converged * t; ++i) {
    const double found = band_radiance(band, Kelvin{t});
    (found < wanted ? bracket.lo : bracket.hi) = t;
    double next = newton_step(t, wanted, found, band_derivative(band, Kelvin{t}));
    // Catches NaN, too.
    if (!(next >= bracket.lo && next <= bracket.hi)) next = std::midpoint(bracket.lo, bracket.hi);
    if (std::abs(next - t) <= converged * t) return Kelvin{next};
    t = next;
  }
  return Kelvin{t};
}

SpectralPlan plan_lanes(const std::vector<BandQuadrature>& bands) {
  constexpr double same = 1e-9;  // relative: far below the width of anything in a spectrum
  std::vector<Micrometres> sorted;
  for (const BandQuadrature& band : bands) {
    sorted.insert(sorted.end(), band.wavelengths.begin(), band.wavelengths.end());
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<Micrometres> distinct;
  for (const Micrometres w : sorted) {
    if (distinct.empty() || w > distinct.back() * (1.0 + same)) distinct.push_back(w);
  }

  SpectralPlan plan;
  for (std::size_t i = 0; i < distinct.size(); i += lane_capacity) {
    const auto first = distinct.begin() + static_cast<std::ptrdiff_t>(i);
    const auto size = std::min<std::ptrdiff_t>(lane_capacity, distinct.end() - first);
    plan.blocks.emplace_back(std::vector<Micrometres>(first, first + size));
  }
  for (const BandQuadrature& band : bands) {
    auto& terms = plan.bands.emplace_back();
    for (std::size_t i = 0; i < band.wavelengths.size(); ++i) {
      // The last distinct wavelength that is not above this one stands for it.
      const auto next = std::upper_bound(distinct.begin(), distinct.end(), band.wavelengths[i]);
      terms.push_back(term_of(next - distinct.begin() - 1, band.weights[i]));
    }
  }
  return plan;
}

SpectralPlan plan_split_lanes(const std::vector<std::vector<LaneShare>>& bands) {
  using Key = std::pair<Micrometres, AbsorptionLane>;
  std::vector<Key> distinct;
  for (const auto& band : bands) {
    for (const LaneShare& lane : band) distinct.emplace_back(lane.wavelength, lane.absorption);
  }
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());

  SpectralPlan plan;
  for (std::size_t i = 0; i < distinct.size(); i += lane_capacity) {
    const std::size_t end = std::min(i + lane_capacity, distinct.size());
    std::vector<Micrometres> wavelengths;
    std::vector<AbsorptionLane> absorption;
    for (std::size_t k = i; k < end; ++k) {
      wavelengths.push_back(distinct[k].first);
      absorption.push_back(distinct[k].second);
    }
    plan.blocks.emplace_back(std::move(wavelengths), std::move(absorption));
  }
  for (const auto& band : bands) {
    auto& terms = plan.bands.emplace_back();
    for (const LaneShare& lane : band) {
      const auto found =
          std::lower_bound(distinct.begin(), distinct.end(), Key{lane.wavelength, lane.absorption});
      terms.push_back(term_of(found - distinct.begin(), lane.weight));
    }
  }
  return plan;
}

}  // namespace nadir::spectral
