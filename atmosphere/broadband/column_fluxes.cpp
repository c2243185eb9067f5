#include "atmosphere/broadband/column_fluxes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "atmosphere/paths/spherical_path.hpp"
#include "atmosphere/transfer/column_optics.hpp"
#include "atmosphere/transfer/mode_solver.hpp"
#include "atmosphere/transfer/ordinates.hpp"
#include "atmosphere/transfer/scaled_column.hpp"

namespace nadir::atmosphere {
namespace {

using std::numbers::pi;

/// Transmittance from outside the air to each level.
std::vector<double> slant_transmittance(const OpticalColumn& column, double mu0) {
  std::vector<double> depth;
  for (int k = 0; k < column.layers(); ++k) depth.push_back(column.depth(k));
  std::vector<double> passed = slant_depths(column.level_height_m, depth, mu0);
  for (double& value : passed) value = std::exp(-value);
  return passed;
}

/// How a beam of irradiance 1 feeds the mean over azimuth.
std::vector<double> beam_angular(double mu0, int streams) {
  const LegendreTable legendre{0, streams, {-mu0}};
  std::vector<double> angular;
  for (int l = 0; l < streams; ++l) angular.push_back(*legendre.row(l) / (4.0 * pi));
  return angular;
}

}  // namespace

ColumnFluxes column_fluxes(const OpticalColumn& column, const std::vector<double>& cos_zenith,
                           const std::vector<double>& planck, int streams) {
  const ScaledColumn scaled = delta_scaled(column, streams);
  TransferProblem problem;
  for (const double mu0 : cos_zenith) {
    problem.beams.push_back({mu0, slant_transmittance(scaled.column, mu0)});
  }
  problem.thermal = !planck.empty();
  problem.planck = planck;
  check(scaled, problem, {});

  const auto layers = layer_optics(scaled, streams);
  std::vector<std::vector<SourceProfile>> profiles;
  for (const BeamIn& beam : problem.beams) profiles.push_back(beam_profiles(beam, layers));
  if (problem.thermal) profiles.push_back(planck_profiles(planck));
  std::vector<ModeSource> sources;
  for (std::size_t i = 0; i < cos_zenith.size(); ++i) {
    sources.push_back({&profiles[i], beam_angular(cos_zenith[i], streams), 0.0, 0.0});
  }
  if (problem.thermal) sources.push_back({&profiles.back(), {}, 0.0, 0.0});
  sources.push_back({nullptr, {}, 0.0, 1.0});  // an even radiance of 1 from the ground

  const ModeField field = solve_mode(double_gauss(streams), 0, layers, sources);
  const double* down = field.down.data() + layers.size() * sources.size();
  ColumnFluxes fluxes;
  for (std::size_t i = 0; i < cos_zenith.size(); ++i) {
    const double direct = slant_transmittance(column, cos_zenith[i]).back();
    const double peak = problem.beams[i].transmittance.back() - direct;
    fluxes.direct.push_back(direct);
    fluxes.diffuse.push_back(down[i] + std::max(0.0, cos_zenith[i]) * peak);
  }
  if (problem.thermal) fluxes.emitted = down[cos_zenith.size()];
  fluxes.spherical_albedo = down[sources.size() - 1] / pi;
  return fluxes;
}

}  // namespace nadir::atmosphere
