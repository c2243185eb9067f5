#include "atmosphere/transfer/two_stream.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "atmosphere/transfer/column_optics.hpp"

namespace nadir::atmosphere {
namespace {

using std::numbers::pi;

/// The equations of a layer, for the sum and the difference of the irradiances up and down:
///     sum' = x_minus difference - q_minus e,   difference' = x_plus sum - q_plus e,
/// with e how the source runs through the layer: those of mode_solver.hpp with one ordinate.
struct Layer {
  double x_plus = 0.0, x_minus = 1.0, q_plus = 0.0, q_minus = 0.0;
};

struct Fluxes {
  std::vector<double> up, down;  // by level
};

/// What a layer does: reflects, transmits, sends out.
struct Response {
  double reflection = 0.0, transmission = 1.0, up = 0.0, down = 0.0;
};

Response respond(const Layer& layer, double depth, const SourceProfile* profile) {
  const double k = std::sqrt(std::max(0.0, layer.x_plus * layer.x_minus));
  const SourceProfile::Kappa kappa{k * depth};
  const double half = 0.5 * depth * kappa.tanh_half_ratio;
  const double even = layer.x_plus * half, odd = layer.x_minus * half;
  const double e = even / (1.0 + even), f = odd / (1.0 + odd);
  Response result{f - e, 1.0 - e - f, 0.0, 0.0};
  if (profile == nullptr || profile->empty()) return result;
  const SourceProfile::Response r = profile->response(kappa);
  const double sent_even = 0.5 * depth * (1.0 - e) *
                           (layer.q_plus * r.even - layer.q_minus * layer.x_plus * depth * r.odd);
  const double sent_odd = 0.5 * depth * (1.0 - f) *
                          (layer.q_minus * r.even - layer.q_plus * layer.x_minus * depth * r.odd);
  result.up = sent_even + sent_odd;
  result.down = sent_even - sent_odd;
  return result;
}

/// Adds the layers up from the ground and sends the light down through them.
Fluxes solve(const std::vector<Layer>& layers, const std::vector<LayerOptics>& optics,
             const std::vector<SourceProfile>* profile, double top, double ground) {
  const std::size_t count = layers.size();
  std::vector<Response> response(count);
  std::vector<double> below(count + 1, 0.0), rising(count + 1, ground);
  for (std::size_t k = count; k-- > 0;) {
    response[k] = respond(layers[k], optics[k].depth, profile ? profile->data() + k : nullptr);
    const Response& r = response[k];
    const double between = 1.0 / (1.0 - r.reflection * below[k + 1]);
    const double falling = between * (r.reflection * rising[k + 1] + r.down);
    below[k] = r.reflection + r.transmission * r.transmission * below[k + 1] * between;
    rising[k] = r.up + r.transmission * (rising[k + 1] + below[k + 1] * falling);
  }
  Fluxes fluxes{{}, {top}};
  for (std::size_t k = 0; k < count; ++k) {
    const Response& r = response[k];
    fluxes.up.push_back(below[k] * fluxes.down[k] + rising[k]);
    fluxes.down.push_back(
        (r.transmission * fluxes.down[k] + r.reflection * rising[k + 1] + r.down) /
        (1.0 - r.reflection * below[k + 1]));
  }
  fluxes.up.push_back(ground);
  return fluxes;
}

class TwoStream {
 public:
  TwoStream(const ScaledColumn& column, const TransferProblem& problem,
            const std::vector<double>& mu)
      : scaled_{column}, problem_{problem}, mu_{mu}, optics_{layer_optics(column, 2)} {
    for (const double cosine : mu) backward_.push_back(backscatter_by_kind(std::abs(cosine)));
  }

  [[nodiscard]] TransferSolution solve_all() const {
    TransferSolution solution;
    for (const BeamIn& beam : problem_.beams) {
      const std::vector<SourceProfile> profiles = beam_profiles(beam, optics_);
      solution.beams.push_back(source(solve(beam_layers(beam.mu0), optics_, &profiles, 0.0, 0.0)));
    }
    const std::vector<Layer> layers = quadrature_layers();
    if (problem_.thermal) {
      const std::vector<SourceProfile> profiles = planck_profiles(problem_.planck);
      solution.thermal = source(solve(layers, optics_, &profiles, 0.0, 0.0));
    }
    if (problem_.sky) solution.sky = source(solve(layers, optics_, nullptr, pi, 0.0));
    if (problem_.ground) solution.ground = source(solve(layers, optics_, nullptr, 0.0, pi));
    return solution;
  }

 private:
  [[nodiscard]] std::vector<double> backscatter_by_kind(double mu) const {
    std::vector<double> shares;
    for (std::size_t i = 0; i < scaled_.peak.size(); ++i) {
      shares.push_back(backscatter(*scaled_.column.kinds[i].phase, scaled_.peak[i], mu));
    }
    return shares;
  }

  /// Meador & Weaver's "modified delta" with gamma_1 -+ gamma_2 written out:
  ///   q = 4 (1 - g^2 (1 - mu0)),   x_plus = (1 - omega) (8 - 4 g^2) / q,
  ///   x_minus = (6 - 2 g^2 - 6 omega g + omega g^2 (8 beta0 + 6 g - 4)) / q.
  [[nodiscard]] std::vector<Layer> beam_layers(double mu0) const {
    const double cosine = std::abs(mu0);
    const std::vector<double> shares = backscatter_by_kind(cosine);
    std::vector<Layer> layers;
    for (std::size_t k = 0; k < optics_.size(); ++k) {
      const double omega = optics_[k].scatter[0];
      if (omega <= 0.0) {
        layers.push_back({2.0, 1.5, 0.0, 0.0});  // the formulas' values; nothing shines there
        continue;
      }
      const double backwards = back(k, shares);
      const double g = optics_[k].scatter[1] / (3.0 * omega);
      const double q = 4.0 * (1.0 - g * g * (1.0 - cosine));
      const double x_minus =
          6.0 - 2.0 * g * g - 6.0 * omega * g + g * g * (8.0 * backwards + omega * (6.0 * g - 4.0));
      // A beam from below the horizon travels upwards.
      const double up = mu0 > 0.0 ? backwards : omega - backwards;
      layers.push_back(
          {optics_[k].emissivity * (8.0 - 4.0 * g * g) / q, x_minus / q, omega, 2.0 * up - omega});
    }
    return layers;
  }

  /// Quadrature: x_plus = sqrt(3) (1 - omega), x_minus = sqrt(3) (1 - omega g). What is emitted is
  /// such that light of the air's own temperature is in equilibrium with it.
  [[nodiscard]] std::vector<Layer> quadrature_layers() const {
    const double root = std::sqrt(3.0);
    std::vector<Layer> layers;
    for (const LayerOptics& optics : optics_) {
      const double x_plus = root * optics.emissivity;
      layers.push_back({x_plus, root * (1.0 - optics.scatter[1] / 3.0), 2.0 * pi * x_plus, 0.0});
    }
    return layers;
  }

  /// omega beta of a layer: the share of extinction that goes back.
  [[nodiscard]] double back(std::size_t layer, const std::vector<double>& shares) const {
    double scattered = 0.0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      scattered += shares[i] * scaled_.column.kinds[i].scattering[layer];
    }
    return optics_[layer].depth > 0.0 ? scattered / optics_[layer].depth : 0.0;
  }

  [[nodiscard]] ScatteredSource source(const Fluxes& fluxes) const {
    ScatteredSource result;
    result.mu = mu_;
    result.fluxes = {fluxes.down.back(), fluxes.up.front()};
    for (std::size_t place = 0; place < 2 * optics_.size(); ++place) {
      const std::size_t layer = place / 2, level = layer + place % 2;
      const double up = fluxes.up[level], down = fluxes.down[level];
      for (std::size_t i = 0; i < mu_.size(); ++i) {
        const double backwards = back(layer, backward_[i]);
        const double along = mu_[i] > 0.0 ? up : down, against = mu_[i] > 0.0 ? down : up;
        result.value.push_back(
            ((optics_[layer].scatter[0] - backwards) * along + backwards * against) / pi);
      }
    }
    return result;
  }

  const ScaledColumn& scaled_;
  const TransferProblem& problem_;
  const std::vector<double>& mu_;
  std::vector<LayerOptics> optics_;
  std::vector<std::vector<double>> backward_;  // by direction and kind
};

}  // namespace

double backscatter(const PhaseFunction& phase, double peak, double mu) {
  const std::vector<double>& chi = phase.moments();
  double before = 1.0, now = mu;  // p_(l-1) and p_l
  double half = 0.5;              // int_0^1 p_l, for odd l
  double sum = 0.0;
  for (std::size_t l = 1; l + 2 < chi.size(); l += 2) {
    const auto degree = static_cast<double>(l);
    sum += (2.0 * degree + 1.0) * chi[l] * now * half;
    half *= -degree / (degree + 3.0);
    for (int step = 0; step < 2; ++step) {
      const double d = degree + step;
      const double next = ((2.0 * d + 1.0) * mu * now - d * before) / (d + 1.0);
      before = now;
      now = next;
    }
  }
  const double all = 0.5 * (1.0 - sum);
  return std::clamp(all / (1.0 - peak), 0.0, std::max(0.5, all));
}

TransferSolution two_stream(const ScaledColumn& column, const TransferProblem& problem,
                            const std::vector<double>& mu) {
  check(column, problem, mu);
  return TwoStream{column, problem, mu}.solve_all();
}

}  // namespace nadir::atmosphere
