#include "atmosphere/transfer/mode_solver.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "atmosphere/transfer/layer_operator.hpp"

namespace nadir::atmosphere {
namespace {

template <int N>
class ModeSolver {
 public:
  ModeSolver(const Ordinates& ordinates, int order, const std::vector<LayerOptics>& layers,
             const std::vector<ModeSource>& sources)
      : basis_{ordinates, order},
        dense_{basis_.size},
        operator_{basis_},
        layers_{layers},
        sources_{sources},
        n_{basis_.size},
        work_(n_ * n_),
        back_(n_ * n_),
        under_((layers.size() + 1) * n_ * n_),
        pass_(layers.size() * n_ * n_),
        rising_((layers.size() + 1) * sources.size() * n_),
        falling_(layers.size() * sources.size() * n_),
        up_(rising_.size()),
        down_(rising_.size()) {}

  ModeField solve() {
    const std::size_t levels = layers_.size() + 1, count = sources_.size();
    for (std::size_t s = 0; s < count; ++s) {
      dense_.add(sources_[s].ground, basis_.root.data(), vector(rising_, levels - 1, s));
    }
    for (std::size_t k = layers_.size(); k-- > 0;) {
      operator_.set(layers_[k]);
      operator_.clear() ? add_clear(k) : add_layer(k);
    }
    sweep_down();
    ModeField field;
    field.degrees = static_cast<int>(basis_.degrees);
    field.sources = static_cast<int>(count);
    field.moment.resize(levels * count * basis_.degrees);
    for (std::size_t level = 0; level < levels; ++level) project(level, field);
    return field;
  }

 private:
  using Values = std::vector<double>;
  double* matrix(Values& of, std::size_t level) const noexcept {
    return of.data() + level * n_ * n_;
  }
  double* vector(Values& of, std::size_t level, std::size_t source) const noexcept {
    return of.data() + (level * sources_.size() + source) * n_;
  }

  /// Puts a layer that scatters nothing on top of all that lies below it.
  void add_clear(std::size_t k) {
    const double* below = matrix(under_, k + 1);
    double* above = matrix(under_, k);
    double* pass = matrix(pass_, k);
    for (std::size_t i = 0; i < n_; ++i) {
      pass[i * (n_ + 1)] = operator_.fade(i);
      for (std::size_t j = 0; j < n_; ++j) {
        above[i * n_ + j] = operator_.fade(i) * below[i * n_ + j] * operator_.fade(j);
      }
    }
    for (std::size_t s = 0; s < sources_.size(); ++s) {
      double* up = vector(rising_, k, s);
      double* falling = vector(falling_, k, s);
      operator_.emit(sources_[s], k, up, falling);
      const double* rising = vector(rising_, k + 1, s);
      for (std::size_t i = 0; i < n_; ++i) {
        up[i] += operator_.fade(i) * (rising[i] + dense_.dot(below + i * n_, falling));
      }
    }
  }

  /// Puts a layer on top of all that lies below it.
  void add_layer(std::size_t k) {
    const double* below = matrix(under_, k + 1);
    double* above = matrix(under_, k);
    double* pass = matrix(pass_, k);
    const double* r = operator_.reflection();
    const double* t = operator_.transmission();
    // 1 - r below: both are symmetric and no larger than 1, so that its symmetric part is positive.
    dense_.multiply(r, below, work_.data());
    for (double& value : work_) value = -value;
    for (std::size_t i = 0; i < n_; ++i) work_[i * (n_ + 1)] += 1.0;
    dense_.factorise(work_.data());
    for (std::size_t i = 0; i < n_ * n_; ++i) pass[i] = t[i];
    dense_.solve(work_.data(), pass);
    dense_.multiply(t, below, back_.data());
    dense_.multiply(back_.data(), pass, above);
    for (std::size_t i = 0; i < n_ * n_; ++i) above[i] += r[i];
    for (std::size_t s = 0; s < sources_.size(); ++s) {
      double* up = vector(rising_, k, s);
      double* falling = vector(falling_, k, s);
      operator_.emit(sources_[s], k, up, falling);
      const double* rising = vector(rising_, k + 1, s);
      dense_.apply(r, rising, falling);
      dense_.solve_vector(work_.data(), falling);
      dense_.apply(t, rising, up);
      dense_.apply(back_.data(), falling, up);
    }
  }

  void sweep_down() {
    for (std::size_t s = 0; s < sources_.size(); ++s) {
      dense_.add(sources_[s].top, basis_.root.data(), vector(down_, 0, s));
    }
    for (std::size_t level = 0; level <= layers_.size(); ++level) {
      for (std::size_t s = 0; s < sources_.size(); ++s) {
        double* down = vector(down_, level, s);
        if (level > 0) {
          dense_.add(1.0, vector(falling_, level - 1, s), down);
          dense_.apply(matrix(pass_, level - 1), vector(down_, level - 1, s), down);
        }
        double* up = vector(up_, level, s);
        dense_.add(1.0, vector(rising_, level, s), up);
        dense_.apply(matrix(under_, level), down, up);
      }
    }
  }

  /// Moments and fluxes of the field at a level.
  void project(std::size_t level, ModeField& field) {
    for (std::size_t s = 0; s < sources_.size(); ++s) {
      const double* up = vector(up_, level, s);
      const double* down = vector(down_, level, s);
      double* moment = field.moment.data() + (level * sources_.size() + s) * basis_.degrees;
      for (std::size_t l = 0; l < basis_.degrees; ++l) {
        const double rising = dense_.dot(basis_.row(l), up);
        const double falling = dense_.dot(basis_.row(l), down);
        moment[l] = 0.5 * (l % 2 == 0 ? rising + falling : rising - falling);
      }
      if (basis_.order > 0) continue;
      field.up.push_back(2.0 * std::numbers::pi * dense_.dot(basis_.root.data(), up));
      field.down.push_back(2.0 * std::numbers::pi * dense_.dot(basis_.root.data(), down));
    }
  }

  ModeBasis basis_;
  Dense<N> dense_;
  LayerOperator<N> operator_;
  const std::vector<LayerOptics>& layers_;
  const std::vector<ModeSource>& sources_;
  std::size_t n_;
  Values work_, back_;
  Values under_;      // reflection of all that lies below a level
  Values pass_;       // what comes down at a layer's bottom = pass (what does at its top) + falling
  Values rising_;     // what goes up at a level with nothing coming down: [level][source]
  Values falling_;    // [layer][source]
  Values up_, down_;  // the field, times sqrt(w mu): [level][source]
};

}  // namespace

ModeField solve_mode(const Ordinates& ordinates, int order, const std::vector<LayerOptics>& layers,
                     const std::vector<ModeSource>& sources) {
  switch (ordinates.mu.size()) {  // the usual numbers of streams have code of their own
    case 2:
      return ModeSolver<2>{ordinates, order, layers, sources}.solve();
    case 4:
      return ModeSolver<4>{ordinates, order, layers, sources}.solve();
    case 8:
      return ModeSolver<8>{ordinates, order, layers, sources}.solve();
    default:
      return ModeSolver<0>{ordinates, order, layers, sources}.solve();
  }
}

}  // namespace nadir::atmosphere
