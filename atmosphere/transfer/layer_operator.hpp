#pragma once
// Private to this folder

#include <vector>

#include "atmosphere/transfer/dense.hpp"
#include "atmosphere/transfer/mode_solver.hpp"

namespace nadir::atmosphere {

/// The ordinates of one mode: sqrt(w mu), 1 / mu, and p_l = sqrt(w / mu) Lambda_l by degree.
struct ModeBasis {
  ModeBasis(const Ordinates& ordinates, int order);
  std::size_t order, size, degrees;
  std::vector<double> root, inverse_mu, p;
  [[nodiscard]] const double* row(std::size_t i) const noexcept { return p.data() + i * size; }
};

/// What one layer does to light that comes in, and what its own sources send out: see
/// mode_solver.hpp for the equations. One object serves layer after layer.
template <int N>
class LayerOperator {
 public:
  explicit LayerOperator(const ModeBasis& basis);

  void set(const LayerOptics& optics);
  /// Adds what the layer's share of a source sends out at its top and at its bottom.
  void emit(const ModeSource& source, std::size_t layer, double* up, double* down);

  /// Nothing is scattered: no reflection, and the transmission is fade(i).
  [[nodiscard]] bool clear() const noexcept { return clear_; }
  [[nodiscard]] double fade(std::size_t i) const noexcept { return kappa_[i].fade; }
  [[nodiscard]] const double* reflection() const noexcept { return reflection_.data(); }
  [[nodiscard]] const double* transmission() const noexcept { return transmission_.data(); }

 private:
  using Values = std::vector<double>;
  void mix();
  void diagonalise();
  void factor_strange();
  void admittances();
  void direct(const ModeSource& source);
  void finish(const double* even, const double* odd, double* up, double* down) const;

  const ModeBasis& basis_;
  Dense<N> dense_;
  const LayerOptics* optics_ = nullptr;
  bool clear_ = false, diagonalised_ = false;
  Values x_even_, x_odd_;     // X+ and X-
  Values z_, z_inverse_, k_;  // Z, Z~, K
  std::vector<SourceProfile::Kappa> kappa_;
  Values even_, odd_;  // E and F
  Values reflection_, transmission_;
  Values work_, more_, lower_, a_, b_, c_, d_;
};

extern template class LayerOperator<0>;
extern template class LayerOperator<2>;
extern template class LayerOperator<4>;
extern template class LayerOperator<8>;

}  // namespace nadir::atmosphere
