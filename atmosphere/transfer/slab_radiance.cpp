#include "atmosphere/transfer/slab_radiance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "atmosphere/transfer/mean_fade.hpp"

namespace nadir::atmosphere {
namespace {

/// int_0^1 x exp(-z x) dx
double mean_moment(double z) noexcept {
  if (z < 0.02) return 0.5 - z * (1.0 / 3.0 - z * (0.125 - z / 30.0));  // error z^4 / 144
  return (mean_fade(z) - std::exp(-z)) / z;
}

/// The truncated phase function of a kind at a cosine, sr^-1.
double truncated_phase(const PhaseFunction& phase, double cosine, int degrees) {
  const double peak = std::max(0.0, phase.moments()[static_cast<std::size_t>(degrees)]);
  double before = 0.0, now = 1.0, sum = 0.0;
  for (int l = 0; l < degrees; ++l) {
    const double chi = (phase.moments()[static_cast<std::size_t>(l)] - peak) / (1.0 - peak);
    sum += (2.0 * l + 1.0) * chi * now;
    const double next = ((2.0 * l + 1.0) * cosine * now - l * before) / (l + 1.0);
    before = now;
    now = next;
  }
  return sum / (4.0 * std::numbers::pi);
}

class Path {
 public:
  Path(const ScaledColumn& column, const TransferProblem& problem, const TransferSolution& solution,
       const SlabView& view)
      : column_{column}, problem_{problem}, source_{of(solution, view)}, view_{view} {
    mu_ = source_.mu[view.mu_index];
    if (view.light == Light::beam) set_phases();
  }

  [[nodiscard]] double radiance() const {
    const OpticalColumn& air = column_.column;
    const int layers = air.layers();
    double sum = 0.0, transmittance = 1.0;
    for (int i = 0; i < layers; ++i) {
      const int layer = mu_ > 0.0 ? i : layers - 1 - i;
      const double slant = air.depth(layer) / std::abs(mu_);
      const double near = source(layer, true), far = source(layer, false);
      const double moment = mean_moment(slant);
      sum += transmittance * slant * (near * (mean_fade(slant) - moment) + far * moment);
      if (view_.light == Light::beam) sum += transmittance * first(layer, slant);
      transmittance *= std::exp(-slant);
    }
    const bool seen = mu_ > 0.0 ? view_.light == Light::ground : view_.light == Light::sky;
    return seen ? sum + transmittance : sum;
  }

 private:
  static const ScatteredSource& of(const TransferSolution& solution, const SlabView& view) {
    switch (view.light) {
      case Light::thermal:
        return solution.thermal;
      case Light::sky:
        return solution.sky;
      case Light::ground:
        return solution.ground;
      default:
        return solution.beams[view.beam];
    }
  }

  void set_phases() {
    const double mu0 = problem_.beams[view_.beam].mu0;
    const double sines = std::sqrt((1.0 - mu_ * mu_) * (1.0 - mu0 * mu0));
    const double cosine = std::clamp(-mu_ * mu0 + sines * std::cos(view_.azimuth_rad), -1.0, 1.0);
    for (std::size_t i = 0; i < column_.peak.size(); ++i) {
      const PhaseFunction& phase = *column_.column.kinds[i].phase;
      const double f = column_.peak[i];
      phase_.push_back(view_.truncated == 0 ? phase.at(cosine) / (1.0 - f)
                                            : truncated_phase(phase, cosine, view_.truncated));
    }
  }

  /// J, and what the air emits, at the nearer or farther edge of a layer.
  [[nodiscard]] double source(int layer, bool nearer) const {
    const bool top = nearer == (mu_ > 0.0);
    double sum = 0.0;
    for (int m = 0; m < source_.modes; ++m) {
      sum += source_.at(2 * layer + (top ? 0 : 1), m, static_cast<int>(view_.mu_index)) *
             std::cos(m * view_.azimuth_rad);
    }
    const double depth = column_.column.depth(layer);
    if (view_.light != Light::thermal || depth <= 0.0) return sum;
    const auto k = static_cast<std::size_t>(layer);
    return sum + column_.column.absorption[k] / depth * problem_.planck[top ? k : k + 1];
  }

  /// What a layer scatters out of the beam, at its nearer edge.
  [[nodiscard]] double first(int layer, double slant) const {
    const auto k = static_cast<std::size_t>(layer);
    const BeamIn& beam = problem_.beams[view_.beam];
    const double top = beam.transmittance[k], bottom = beam.transmittance[k + 1];
    const double near = mu_ > 0.0 ? top : bottom, far = mu_ > 0.0 ? bottom : top;
    double mean = 0.0;  // of the beam's strength times what is left of it at the nearer edge
    if (top > 0.0 && bottom > 0.0) {
      const double rate = std::log(near / far) + slant;
      mean = (rate > 0.0 ? near : far * std::exp(-slant)) * mean_fade(std::abs(rate));
    } else if (beam.mu0 > 0.0) {  // nothing is left at the bottom that a number could hold
      const double rate = slant * std::abs(mu_) / beam.mu0;
      mean = mu_ > 0.0 ? near * mean_fade(rate + slant)
                       : far * std::exp(-std::min(rate, slant)) * mean_fade(std::abs(rate - slant));
    } else {
      mean = near * (mean_fade(slant) - mean_moment(slant)) + far * mean_moment(slant);
    }
    double scattered = 0.0;
    for (std::size_t i = 0; i < phase_.size(); ++i) {
      scattered += column_.column.kinds[i].scattering[k] * phase_[i];
    }
    return scattered * mean / std::abs(mu_);
  }

  const ScaledColumn& column_;
  const TransferProblem& problem_;
  const ScatteredSource& source_;
  const SlabView& view_;
  double mu_ = 1.0;
  std::vector<double> phase_;
};

}  // namespace

double slab_radiance(const ScaledColumn& column, const TransferProblem& problem,
                     const TransferSolution& solution, const SlabView& view) {
  return Path{column, problem, solution, view}.radiance();
}

}  // namespace nadir::atmosphere
