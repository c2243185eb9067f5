#include "atmosphere/transfer/column_optics.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"

namespace nadir::atmosphere {
namespace {

void expect_size(const char* what, std::size_t found, std::size_t expected) {
  if (found == expected) return;
  throw InputError{std::string{what} + ": " + std::to_string(found) + " values, expected " +
                   std::to_string(expected)};
}

void expect_depths(const char* what, const std::vector<double>& depths) {
  for (const double depth : depths) {
    if (!(depth >= 0.0 && std::isfinite(depth))) {
      throw InputError{std::string{what} + " is " + std::to_string(depth) +
                       " in a layer, expected a number not below 0"};
    }
  }
}

}  // namespace

std::vector<LayerOptics> layer_optics(const ScaledColumn& scaled, int degrees) {
  const OpticalColumn& column = scaled.column;
  const auto count = static_cast<std::size_t>(degrees);
  std::vector<LayerOptics> layers(column.absorption.size());
  for (std::size_t k = 0; k < layers.size(); ++k) {
    LayerOptics& layer = layers[k];
    layer.depth = column.depth(static_cast<int>(k));
    layer.scatter.assign(count, 0.0);
    if (layer.depth <= 0.0) continue;
    layer.emissivity = column.absorption[k] / layer.depth;
    for (std::size_t i = 0; i < column.kinds.size(); ++i) {
      const double omega = column.kinds[i].scattering[k] / layer.depth;
      if (omega == 0.0) continue;
      const std::vector<double>& chi = column.kinds[i].phase->moments();
      const double f = scaled.peak[i], share = omega / (1.0 - f);
      for (std::size_t l = 0; l < count; ++l) {
        layer.scatter[l] += share * (2.0 * static_cast<double>(l) + 1.0) * (chi[l] - f);
      }
    }
  }
  for (std::size_t k = 0; k + 1 < layers.size(); ++k) {
    const auto alike = [](double a, double b) { return std::abs(a - b) <= 1e-14 * std::abs(b); };
    layers[k].like_below = std::equal(layers[k].scatter.begin(), layers[k].scatter.end(),
                                      layers[k + 1].scatter.begin(), alike);
  }
  return layers;
}

std::vector<SourceProfile> beam_profiles(const BeamIn& beam,
                                         const std::vector<LayerOptics>& layers) {
  std::vector<SourceProfile> profiles(layers.size());
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const double top = beam.transmittance[k], bottom = beam.transmittance[k + 1];
    const double near = std::max(top, bottom), far = std::min(top, bottom);
    if (near <= 0.0) continue;
    if (far > 0.0) {
      profiles[k] = SourceProfile::fading(near, std::log(near / far), top >= bottom);
    } else if (beam.mu0 > 0.0) {  // nothing is left that a number could hold
      const double slant = layers[k].depth / beam.mu0;
      profiles[k] = SourceProfile::fading(near, std::max(slant, 700.0 + std::log(near)), true);
    } else {  // the edge of the earth's shadow
      profiles[k] = SourceProfile::linear(top, bottom);
    }
  }
  return profiles;
}

std::vector<SourceProfile> planck_profiles(const std::vector<double>& planck) {
  std::vector<SourceProfile> profiles;
  for (std::size_t k = 0; k + 1 < planck.size(); ++k) {
    profiles.push_back(SourceProfile::linear(planck[k], planck[k + 1]));
  }
  return profiles;
}

void check(const ScaledColumn& scaled, const TransferProblem& problem,
           const std::vector<double>& mu) {
  const OpticalColumn& column = scaled.column;
  const std::size_t layers = column.absorption.size();
  if (layers == 0) throw InputError{"a column of air needs at least one layer"};
  expect_size("forward peaks of a scaled column", scaled.peak.size(), column.kinds.size());
  expect_depths("absorption", column.absorption);
  for (const OpticalColumn::Kind& kind : column.kinds) {
    expect_size("scattering of a kind, by layer", kind.scattering.size(), layers);
    expect_depths("scattering", kind.scattering);
  }
  for (const BeamIn& beam : problem.beams) {
    expect_size("transmittance of a beam, by level", beam.transmittance.size(), layers + 1);
    if (!(std::abs(beam.mu0) <= 1.0)) {
      throw InputError{"cosine of a beam is " + std::to_string(beam.mu0) + ", expected -1 to 1"};
    }
  }
  if (problem.thermal) {
    expect_size("Planck radiance, by level", problem.planck.size(), layers + 1);
  }
  for (const double cosine : mu) {
    if (!(std::abs(cosine) <= 1.0)) {
      throw InputError{"cosine of a direction is " + std::to_string(cosine) + ", expected -1 to 1"};
    }
  }
}

}  // namespace nadir::atmosphere
