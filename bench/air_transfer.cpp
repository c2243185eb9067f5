// What a column of air costs to solve, and what the number of streams is worth:
//
//     air_transfer
//
// prints, for clear air with haze and for a slab of forward scatterers, the radiance that leaves at
// the top and at the bottom for each number of streams against 64: root mean square and largest
// relative difference over directions, with first scattering by the true phase function and by the
// truncated one; then the time of one solution of 35 layers with a beam, thermal emission and
// ground.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <numbers>
#include <vector>

#include "atmosphere/transfer/discrete_ordinates.hpp"
#include "atmosphere/transfer/slab_radiance.hpp"
#include "atmosphere/transfer/two_stream.hpp"

namespace {

using namespace nadir::atmosphere;

constexpr double mu0 = 0.6;

/// Rayleigh scattering and haze over 100 km: optical depths 0.1 and 0.3.
OpticalColumn clear_air(int layers, double haze_g) {
  OpticalColumn column;
  column.kinds.resize(2);
  double above_rayleigh = 0.0, above_haze = 0.0;
  for (int k = 1; k <= layers; ++k) {
    // levels closer together towards the ground
    const double share = static_cast<double>(k) / layers;
    const double height_km = 100.0 * (1.0 - share) * (1.0 - share);
    const double rayleigh = 0.1 * std::exp(-height_km / 8.0);
    const double haze = 0.3 * std::exp(-height_km / 1.5);
    column.kinds[0].scattering.push_back(rayleigh - above_rayleigh);
    column.kinds[1].scattering.push_back(0.95 * (haze - above_haze));
    column.absorption.push_back(0.05 * (haze - above_haze) + 0.02 / layers);
    above_rayleigh = rayleigh;
    above_haze = haze;
  }
  column.kinds[0].phase = std::make_shared<const PhaseFunction>(PhaseFunction::rayleigh(0.0279));
  column.kinds[1].phase =
      std::make_shared<const PhaseFunction>(PhaseFunction::henyey_greenstein(haze_g));
  return column;
}

OpticalColumn slab(double depth, double omega, double g, int layers) {
  OpticalColumn column;
  column.absorption.assign(static_cast<std::size_t>(layers), depth * (1.0 - omega) / layers);
  column.kinds.push_back(
      {std::vector<double>(static_cast<std::size_t>(layers), depth * omega / layers),
       std::make_shared<const PhaseFunction>(PhaseFunction::henyey_greenstein(g))});
  return column;
}

TransferProblem problem_for(const OpticalColumn& scaled) {
  TransferProblem problem;
  problem.beams = {{mu0, {1.0}}};
  double depth = 0.0;
  for (int k = 0; k < scaled.layers(); ++k) {
    depth += scaled.depth(k);
    problem.beams[0].transmittance.push_back(std::exp(-depth / mu0));
  }
  problem.thermal = true;
  problem.planck.assign(static_cast<std::size_t>(scaled.layers()) + 1, 1.0);
  return problem;
}

std::vector<double> directions() {
  std::vector<double> mu;
  for (const double m : {0.1, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    mu.push_back(m);
    mu.insert(mu.begin(), -m);
  }
  return mu;
}

/// Radiances in all directions, by azimuth.
std::vector<double> radiances(const OpticalColumn& column, int streams, bool true_phase,
                              bool fast = false) {
  const ScaledColumn scaled = delta_scaled(column, streams);
  const TransferProblem problem = problem_for(scaled.column);
  const std::vector<double> mu = directions();
  const TransferSolution solution =
      fast ? two_stream(scaled, problem, mu) : discrete_ordinates(scaled, problem, streams, mu);
  std::vector<double> values;
  for (std::size_t i = 0; i < mu.size(); ++i) {
    for (const double azimuth_deg : {0.0, 30.0, 60.0, 90.0, 135.0, 180.0}) {
      values.push_back(slab_radiance(
          scaled, problem, solution,
          {Light::beam, 0, i, azimuth_deg * std::numbers::pi / 180.0, true_phase ? 0 : streams}));
    }
  }
  return values;
}

struct Error {
  double rms = 0.0, worst = 0.0;
};

Error error_of(const std::vector<double>& values, const std::vector<double>& truth) {
  Error error;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double relative = std::abs(values[i] / truth[i] - 1.0);
    error.rms += relative * relative;
    error.worst = std::max(error.worst, relative);
  }
  error.rms = std::sqrt(error.rms / static_cast<double>(values.size()));
  return error;
}

double milliseconds(int streams, bool fast) {
  const ScaledColumn scaled = delta_scaled(clear_air(35, 0.75), streams);
  const TransferProblem problem = problem_for(scaled.column);
  const std::vector<double> mu = directions();
  double best = 1e9;
  for (int round = 0; round < 5; ++round) {
    const int calls = streams > 16 ? 3 : 30;
    const std::clock_t start = std::clock();
    for (int i = 0; i < calls; ++i) {
      const TransferSolution solution =
          fast ? two_stream(scaled, problem, mu) : discrete_ordinates(scaled, problem, streams, mu);
      if (solution.beams.empty()) return 0.0;
    }
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    best = std::min(best, 1e3 * seconds / calls);
  }
  return best;
}

void table(const char* name, const OpticalColumn& column) {
  const std::vector<double> truth = radiances(column, 64, true);
  std::printf("%s\n  streams   true phase function      truncated\n", name);
  std::printf("            rms       largest        rms       largest\n");
  const Error fast = error_of(radiances(column, 2, true, true), truth);
  std::printf("  two     %9.2e  %9.2e\n", fast.rms, fast.worst);
  for (const int streams : {4, 8, 16, 32}) {
    const Error exact = error_of(radiances(column, streams, true), truth);
    const Error cut = error_of(radiances(column, streams, false), truth);
    std::printf("  %3d     %9.2e  %9.2e   %9.2e  %9.2e\n", streams, exact.rms, exact.worst, cut.rms,
                cut.worst);
  }
}

}  // namespace

int main() {
  table("clear air, haze with g = 0.75", clear_air(80, 0.75));
  table("slab of depth 1, omega = 0.95, g = 0.85", slab(1.0, 0.95, 0.85, 80));
  table("cloud of depth 10, omega = 1, g = 0.85", slab(10.0, 1.0, 0.85, 200));
  std::printf("35 layers, beam, thermal and ground\n  two    %8.3f ms\n", milliseconds(2, true));
  for (const int streams : {4, 8, 16, 32, 64}) {
    std::printf("  %3d    %8.3f ms\n", streams, milliseconds(streams, false));
  }
}
