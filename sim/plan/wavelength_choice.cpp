#include "sim/plan/wavelength_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "spectral/band_quadrature.hpp"

namespace nadir::sim {
namespace {

// Spectra finer than this many points a band are as good as known by every n-th of their knots.
constexpr std::size_t most_knots = 4000;

/// Even steps over the band, and where its response and its light bend.
std::vector<double> dense_grid(const spectral::Response& response, const BandLight& light) {
  const spectral::Support band = spectral::support(response);
  std::vector<double> inside;
  const auto take = [&](double knot_um) {
    if (knot_um > band.lo.value && knot_um < band.hi.value) inside.push_back(knot_um);
  };
  for (const double knot : light.knots_um) take(knot);
  if (const auto* table = std::get_if<spectral::TabulatedResponse>(&response)) {
    for (const double knot : table->curve.wavelengths_um()) take(knot);
  }
  std::sort(inside.begin(), inside.end());
  const std::size_t stride = inside.size() / most_knots + 1;
  std::vector<double> grid;
  for (std::size_t i = 0; i < inside.size(); i += stride) grid.push_back(inside[i]);
  for (int i = 0; i <= BandErrors::least_grid; ++i) {
    grid.push_back(
        std::lerp(band.lo.value, band.hi.value, i / static_cast<double>(BandErrors::least_grid)));
  }
  std::sort(grid.begin(), grid.end());
  grid.erase(std::unique(grid.begin(), grid.end()), grid.end());
  return grid;
}

/// Weights of the trapezoid rule times the response; they sum to 1.
std::vector<double> band_weights(const spectral::Response& response,
                                 const std::vector<double>& grid_um) {
  std::vector<double> weights(grid_um.size(), 0.0);
  for (std::size_t i = 1; i < grid_um.size(); ++i) {
    const double half = 0.5 * (grid_um[i] - grid_um[i - 1]);
    weights[i - 1] += half;
    weights[i] += half;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] *= spectral::at(response, Micrometres{grid_um[i]});
    sum += weights[i];
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

std::vector<double> running_integral(const std::vector<double>& grid_um,
                                     const std::vector<double>& values) {
  std::vector<double> grown(grid_um.size(), 0.0);
  for (std::size_t i = 1; i < grid_um.size(); ++i) {
    grown[i] = grown[i - 1] + 0.5 * (grid_um[i] - grid_um[i - 1]) * (values[i - 1] + values[i]);
  }
  return grown;
}

}  // namespace

BandErrors::BandErrors(const spectral::Response& response, const BandLight& light)
    : response_{&response},
      light_{&light},
      grid_um_{dense_grid(response, light)},
      grown_(light.functions.size()),
      known_(most + 1, -1.0) {
  for (const SpectralFunction& function : light.functions) {
    auto& values = values_.emplace_back();
    values.reserve(grid_um_.size());
    for (const double lambda_um : grid_um_) values.push_back(function(lambda_um));
  }
  const std::vector<double> weights = band_weights(response, grid_um_);
  std::vector<double> product(grid_um_.size());
  for (const BandLight::Product& part : light.products) {
    product = weights;
    const auto times = [&](const std::vector<std::size_t>& functions) {
      for (const std::size_t f : functions) {
        for (std::size_t i = 0; i < product.size(); ++i) product[i] *= values_[f][i];
      }
    };
    times(part.at_nodes);
    times(part.over_intervals);
    double mean = 0.0;
    for (const double value : product) mean += value;
    means_.push_back(part.scale * mean);
    for (const std::size_t f : part.over_intervals) {
      if (grown_[f].empty()) grown_[f] = running_integral(grid_um_, values_[f]);
    }
  }
}

double BandErrors::grown_at(std::size_t function, double at) const {
  const std::vector<double>& grown = grown_[function];
  const auto above = std::upper_bound(grid_um_.begin() + 1, grid_um_.end() - 1, at);
  const auto i = static_cast<std::size_t>(above - grid_um_.begin());
  const double lo = grid_um_[i - 1], x = (at - lo) / (grid_um_[i] - lo);
  const double a = values_[function][i - 1], b = values_[function][i];
  return grown[i - 1] + (at - lo) * (a + 0.5 * x * (b - a));  // the line's own integral
}

double BandErrors::mean_over(std::size_t function, double lo, double hi) const {
  return (grown_at(function, hi) - grown_at(function, lo)) / (hi - lo);
}

std::vector<double> BandErrors::by_quadrature(int count) const {
  const spectral::BandQuadrature band = spectral::gauss_quadrature(*response_, count);
  const std::size_t nodes = band.wavelengths.size();
  std::vector<std::vector<double>> at_nodes(values_.size()), over(values_.size());
  std::vector<Micrometres> edges;
  const auto at = [&](std::size_t f) -> const std::vector<double>& {
    for (std::size_t i = at_nodes[f].size(); i < nodes; ++i) {
      at_nodes[f].push_back(light_->functions[f](band.wavelengths[i].value));
    }
    return at_nodes[f];
  };
  const auto mean = [&](std::size_t f) -> const std::vector<double>& {
    if (edges.empty()) edges = spectral::interval_edges(*response_, band);
    for (std::size_t i = over[f].size(); i < nodes; ++i) {
      over[f].push_back(mean_over(f, edges[i].value, edges[i + 1].value));
    }
    return over[f];
  };
  std::vector<double> sums, product;
  for (const BandLight::Product& part : light_->products) {
    product = band.weights;
    const auto times = [&](const std::vector<double>& values) {
      for (std::size_t i = 0; i < nodes; ++i) product[i] *= values[i];
    };
    for (const std::size_t f : part.at_nodes) times(at(f));
    for (const std::size_t f : part.over_intervals) times(mean(f));
    double sum = 0.0;
    for (const double value : product) sum += value;
    sums.push_back(part.scale * sum);
  }
  return sums;
}

double BandErrors::computed(int count) const {
  const std::vector<double> sums = by_quadrature(count);
  double worst = 0.0;
  for (const BandLight::Pixel& pixel : light_->pixels) {
    std::array<double, BandLight::Product::kins> errors{};
    double radiance = 0.0;
    for (const std::size_t p : pixel.products) {
      errors.at(static_cast<std::size_t>(light_->products[p].kin)) += sums[p] - means_[p];
      radiance += means_[p];
    }
    double error = 0.0;
    for (const double of_kin : errors) error += std::abs(of_kin);
    const double against = std::max(radiance, pixel.floor);
    if (against > 0.0) worst = std::max(worst, error / against);
  }
  return worst;
}

double BandErrors::of(int count) {
  double& known = known_.at(static_cast<std::size_t>(count));
  if (known < 0.0) known = computed(count);
  return known;
}

double BandErrors::stated(int count) {
  return std::max(of(count), of(count < most ? count + 1 : count - 1));
}

CountChoice choose_count(BandErrors& errors, double share) {
  CountChoice best{1, errors.stated(1)};
  for (int count = 1; count <= BandErrors::most; ++count) {
    const double error = errors.stated(count);
    if (error <= share) return {count, error};
    if (error < best.error) best = {count, error};
  }
  return best;
}

}  // namespace nadir::sim
