#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <vector>

#include "atmosphere/transfer/discrete_ordinates.hpp"
#include "atmosphere/transfer/slab_radiance.hpp"

namespace nadir::atmosphere::test {

/// A column of one kind of scatterer whose layers have these depths.
inline OpticalColumn column_of(const std::vector<double>& depths, double omega,
                               const PhaseFunction& phase) {
  OpticalColumn column;
  column.level_height_m.assign(depths.size() + 1, 0.0);
  column.level_temperature_k.assign(depths.size() + 1, 0.0);
  std::vector<double> scattering;
  for (const double depth : depths) {
    column.absorption.push_back(depth * (1.0 - omega));
    scattering.push_back(depth * omega);
  }
  column.kinds.push_back({scattering, std::make_shared<const PhaseFunction>(phase)});
  return column;
}

/// Layers that start thin at both faces of a slab, where its field changes fast, grow inwards from
/// a thousandth over three tenths of them on either side, and are even between.
inline std::vector<double> graded(double depth, int layers) {
  std::vector<double> steps;
  double sum = 0.0;
  for (int i = 0; i < layers; ++i) {
    const double from_face = std::min(i, layers - 1 - i) / (0.3 * layers);
    steps.push_back(std::pow(1e-3, std::max(0.0, 1.0 - from_face)));
    sum += steps.back();
  }
  for (double& step : steps) step *= depth / sum;
  return steps;
}

/// A plane-parallel beam into a scaled column.
inline BeamIn plane_beam(const OpticalColumn& scaled, double mu0) {
  BeamIn beam{mu0, {1.0}};
  double depth = 0.0;
  for (int k = 0; k < scaled.layers(); ++k) {
    depth += scaled.depth(k);
    beam.transmittance.push_back(std::exp(-depth / mu0));
  }
  return beam;
}

/// A slab, what shines on it, and its solution.
struct Slab {
  ScaledColumn scaled;
  TransferProblem problem;
  TransferSolution solution;

  /// A beam of irradiance 1 across its way, and even light from above.
  Slab(const OpticalColumn& column, int streams, double mu0, const std::vector<double>& mu)
      : scaled{delta_scaled(column, streams)} {
    problem.beams = {plane_beam(scaled.column, mu0)};
    problem.sky = true;
    solution = discrete_ordinates(scaled, problem, streams, mu);
  }
  [[nodiscard]] double radiance(std::size_t mu_index, double azimuth_rad = 0.0) const {
    return slab_radiance(scaled, problem, solution, {Light::beam, 0, mu_index, azimuth_rad, 0});
  }
  [[nodiscard]] double even_radiance(std::size_t mu_index) const {
    return slab_radiance(scaled, problem, solution, {Light::sky, 0, mu_index, 0.0, 0});
  }
};

}  // namespace nadir::atmosphere::test
