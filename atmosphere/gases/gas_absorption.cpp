#include "atmosphere/gases/gas_absorption.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "atmosphere/gases/grid_point.hpp"
#include "atmosphere/gases/term_builder.hpp"

namespace nadir::atmosphere {

namespace {

double along(const std::vector<double>& by_layer, const std::vector<double>& slant) {
  double sum = 0.0;
  for (std::size_t layer = 0; layer < by_layer.size(); ++layer) {
    sum += by_layer[layer] * slant[layer];
  }
  return sum;
}

/// One gas by LOWTRAN7's band model, with its two cuts.
double band_function(double x, double a) {
  const double exponent = a * std::log10(std::max(x, 1e-300));
  if (exponent <= -6.0) return 1.0;
  if (exponent >= 2.0) return 0.0;
  return std::exp(-std::pow(10.0, exponent));
}

double exponential_sum(double x, const BandSet& set) {
  double sum = 0.0;
  for (std::size_t j = 0; j < set.k.size(); ++j) sum += set.weight[j] * std::exp(-set.k[j] * x);
  return sum;
}

/// The mean over points, with one function for the gases' bands.
template <class Function>
double mean_over(const std::vector<GridPoint>& points, const BandTables& tables,
                 const GasAmounts& amounts, const std::vector<double>& slant, Function function) {
  double mean = 0.0;
  for (const GridPoint& point : points) {
    double depth = 0.0;
    for (const GridPoint::Part& part : point.smooth) {
      depth += part.coefficient * along(amounts.of(part.column), slant);
    }
    double passed = std::exp(-depth);
    for (const GridPoint::Part& part : point.bands) {
      passed *= function(part.coefficient * along(amounts.of(part.column), slant),
                         tables.sets[part.column]);
    }
    mean += point.weight * passed;
  }
  return mean;
}

}  // namespace

GasAbsorption::GasAbsorption(std::shared_ptr<const BandTables> tables, const Profile& profile,
                             std::vector<double> level_height_m)
    : tables_{std::move(tables)}, amounts_{*tables_, profile, std::move(level_height_m)} {}

std::vector<AbsorptionTerm> GasAbsorption::terms(Micrometres lo, Micrometres hi,
                                                 double tolerance) const {
  TermBuilder builder{*tables_, amounts_, grid_points(*tables_, amounts_, lo.value, hi.value),
                      tolerance};
  return builder.build();
}

double GasAbsorption::band_transmittance(Micrometres wavelength,
                                         const std::vector<double>& slant) const {
  return mean_over(grid_points(*tables_, amounts_, wavelength.value, wavelength.value), *tables_,
                   amounts_, slant,
                   [](double x, const BandSet& set) { return band_function(x, set.a); });
}

double GasAbsorption::mean_transmittance(Micrometres lo, Micrometres hi,
                                         const std::vector<double>& slant) const {
  return mean_over(grid_points(*tables_, amounts_, lo.value, hi.value), *tables_, amounts_, slant,
                   exponential_sum);
}

std::vector<double> GasAbsorption::rayleigh_depth(Micrometres wavelength) const {
  std::vector<double> depth = amounts_.of(amounts_.column_of(Smooth::air));
  const double per_km = rayleigh_per_km(1e4 / wavelength.value);
  for (double& d : depth) d *= per_km;
  return depth;
}

}  // namespace nadir::atmosphere
