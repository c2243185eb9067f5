#include "atmosphere/transfer/discrete_ordinates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "atmosphere/transfer/column_optics.hpp"
#include "atmosphere/transfer/mode_solver.hpp"
#include "core/error.hpp"

namespace nadir::atmosphere {
namespace {

constexpr double small_mode = 1e-5;  // of mode 0: two in a row end the sum over azimuth
constexpr double no_scattering = 1e-7;

using Values = std::vector<double>;

/// J of one source in one mode, [place][mu].
Values source_values(const std::vector<LayerOptics>& layers, const ModeField& field, int source,
                     const LegendreTable& legendre, int order, std::size_t directions) {
  Values values(2 * layers.size() * directions, 0.0);
  for (std::size_t place = 0; place < 2 * layers.size(); ++place) {
    const Values& scatter = layers[place / 2].scatter;
    const double* moment = field.at(static_cast<int>(place / 2 + place % 2), source);
    double* result = values.data() + place * directions;
    for (int l = order; l < order + field.degrees; ++l) {
      const double factor = scatter[static_cast<std::size_t>(l)] * moment[l - order];
      if (factor == 0.0) continue;
      const double* row = legendre.row(l);
      for (std::size_t i = 0; i < directions; ++i) result[i] += factor * row[i];
    }
  }
  return values;
}

/// Whether a mode stays small against the mean over azimuth at every place.
bool is_small(const Values& mode, const Values& mean, std::size_t directions) {
  const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
  for (std::size_t start = 0; start < mode.size(); start += directions) {
    const auto first = static_cast<std::ptrdiff_t>(start);
    const auto last = static_cast<std::ptrdiff_t>(start + directions);
    const double most = *std::max_element(mode.begin() + first, mode.begin() + last, larger);
    const double base = *std::max_element(mean.begin() + first, mean.begin() + last, larger);
    if (std::abs(most) > small_mode * std::abs(base)) return false;
  }
  return true;
}

/// Joins [mode][place][mu] to [place][mode][mu].
ScatteredSource joined(const std::vector<Values>& modes, const std::vector<double>& mu) {
  ScatteredSource source;
  source.modes = static_cast<int>(modes.size());
  source.mu = mu;
  source.value.reserve(modes.size() * modes.front().size());
  for (std::size_t start = 0; start < modes.front().size(); start += mu.size()) {
    for (const Values& mode : modes) {
      const auto first = mode.begin() + static_cast<std::ptrdiff_t>(start);
      source.value.insert(source.value.end(), first,
                          first + static_cast<std::ptrdiff_t>(mu.size()));
    }
  }
  return source;
}

class Solver {
 public:
  Solver(const ScaledColumn& column, const TransferProblem& problem, int streams,
         const std::vector<double>& mu)
      : problem_{problem},
        mu_{mu},
        streams_{streams},
        ordinates_{double_gauss(streams)},
        layers_{layer_optics(column, streams)} {
    for (const BeamIn& beam : problem.beams)
      beams_.push_back({beam_profiles(beam, layers_), {}, {}});
    if (problem.thermal) planck_ = planck_profiles(problem.planck);
  }

  TransferSolution solve() {
    TransferSolution solution;
    solve_mean(solution);
    const int degrees = significant_degrees();
    for (int order = 1; order < degrees; ++order) {
      if (!solve_order(order)) break;
    }
    for (Beam& beam : beams_) {
      beam.modes.resize(beam.modes.size() - static_cast<std::size_t>(beam.small));
      solution.beams.push_back(joined(beam.modes, mu_));
      solution.beams.back().fluxes = beam.fluxes;
    }
    return solution;
  }

 private:
  struct Beam {
    std::vector<SourceProfile> profile;
    std::vector<Values> modes;
    FieldFluxes fluxes;
    int small = 0;  // modes in a row that were small, the last of all
  };

  [[nodiscard]] ModeSource beam_source(std::size_t index, int order) const {
    const LegendreTable legendre{order, streams_, {-problem_.beams[index].mu0}};
    ModeSource source;
    source.profile = &beams_[index].profile;
    // Irradiance 1 from one direction, as a Fourier sum over azimuth.
    const double share = (order == 0 ? 1.0 : 2.0) / (4.0 * std::numbers::pi);
    for (int l = order; l < streams_; ++l) source.angular.push_back(share * *legendre.row(l));
    return source;
  }

  /// Mode 0, which all sources have.
  void solve_mean(TransferSolution& solution) {
    std::vector<ModeSource> sources;
    for (std::size_t i = 0; i < beams_.size(); ++i) sources.push_back(beam_source(i, 0));
    const std::size_t thermal = sources.size();
    if (problem_.thermal) sources.push_back({&planck_, {}, 0.0, 0.0});
    const std::size_t sky = sources.size();
    if (problem_.sky) sources.push_back({nullptr, {}, 1.0, 0.0});
    const std::size_t ground = sources.size();
    if (problem_.ground) sources.push_back({nullptr, {}, 0.0, 1.0});
    if (sources.empty()) return;

    const ModeField field = solve_mode(ordinates_, 0, layers_, sources);
    const LegendreTable legendre{0, streams_, mu_};
    const auto values = [&](std::size_t source) {
      return source_values(layers_, field, static_cast<int>(source), legendre, 0, mu_.size());
    };
    const auto fluxes = [&](std::size_t source) {
      return FieldFluxes{field.down[layers_.size() * sources.size() + source], field.up[source]};
    };
    const auto store = [&](std::size_t source, ScatteredSource& result) {
      result = joined({values(source)}, mu_);
      result.fluxes = fluxes(source);
    };
    for (std::size_t i = 0; i < beams_.size(); ++i) {
      beams_[i].modes.push_back(values(i));
      beams_[i].fluxes = fluxes(i);
    }
    if (problem_.thermal) store(thermal, solution.thermal);
    if (problem_.sky) store(sky, solution.sky);
    if (problem_.ground) store(ground, solution.ground);
  }

  /// Degrees of the phase functions that scatter anywhere: higher modes have no source.
  [[nodiscard]] int significant_degrees() const {
    int degrees = 1;
    for (const LayerOptics& layer : layers_) {
      for (int l = degrees; l < streams_; ++l) {
        if (std::abs(layer.scatter[static_cast<std::size_t>(l)]) > no_scattering) degrees = l + 1;
      }
    }
    return degrees;
  }

  /// Another mode of the beams that need one; false when none does.
  bool solve_order(int order) {
    std::vector<std::size_t> open;
    std::vector<ModeSource> sources;
    for (std::size_t i = 0; i < beams_.size(); ++i) {
      if (beams_[i].small >= 2 || std::abs(problem_.beams[i].mu0) == 1.0) continue;
      open.push_back(i);
      sources.push_back(beam_source(i, order));
    }
    if (open.empty()) return false;
    const ModeField field = solve_mode(ordinates_, order, layers_, sources);
    const LegendreTable legendre{order, streams_, mu_};
    for (std::size_t j = 0; j < open.size(); ++j) {
      Beam& beam = beams_[open[j]];
      beam.modes.push_back(
          source_values(layers_, field, static_cast<int>(j), legendre, order, mu_.size()));
      const bool small = is_small(beam.modes.back(), beam.modes.front(), mu_.size());
      beam.small = small ? beam.small + 1 : 0;
    }
    return true;
  }

  const TransferProblem& problem_;
  const std::vector<double>& mu_;
  int streams_;
  Ordinates ordinates_;
  std::vector<LayerOptics> layers_;
  std::vector<Beam> beams_;
  std::vector<SourceProfile> planck_;
};

}  // namespace

TransferSolution discrete_ordinates(const ScaledColumn& column, const TransferProblem& problem,
                                    int streams, const std::vector<double>& mu) {
  if (streams < 2 || streams % 2 != 0 || streams >= PhaseFunction::moment_count) {
    throw InputError{"streams are " + std::to_string(streams) +
                     ", expected an even number from 2 to 128"};
  }
  check(column, problem, mu);
  return Solver{column, problem, streams, mu}.solve();
}

}  // namespace nadir::atmosphere
