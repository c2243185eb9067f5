#include "atmosphere/transfer/layer_operator.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace nadir::atmosphere {
namespace {

/// Scattering below this share of the depth changes nothing that could be seen.
constexpr double least_scattering = 1e-7;

/// 4 x 4 is the size of the default of 8 streams; others are not worth the time to compile.
template <int N>
constexpr int eigen_size = N == 4 ? 4 : Eigen::Dynamic;
template <int N>
using Square = Eigen::Matrix<double, eigen_size<N>, eigen_size<N>>;

/// Eigenvalues, ascending, and eigenvectors, in columns, of a symmetric matrix.
template <int N>
void decompose(const std::vector<double>& m, std::vector<double>& value,
               std::vector<double>& vectors) {
  const auto n = static_cast<Eigen::Index>(value.size());
  // Column by column or row by row makes no difference to a symmetric matrix.
  const Eigen::SelfAdjointEigenSolver<Square<N>> solver{
      Eigen::Map<const Square<N>>(m.data(), n, n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    value[static_cast<std::size_t>(i)] = solver.eigenvalues()[i];
    for (Eigen::Index j = 0; j < n; ++j) {
      vectors[static_cast<std::size_t>(i * n + j)] = solver.eigenvectors()(i, j);
    }
  }
}

}  // namespace

ModeBasis::ModeBasis(const Ordinates& ordinates, int order_)
    : order{static_cast<std::size_t>(order_)},
      size{ordinates.mu.size()},
      degrees{2 * ordinates.mu.size() - static_cast<std::size_t>(order_)} {
  const LegendreTable legendre{order_, static_cast<int>(2 * size), ordinates.mu};
  for (std::size_t i = 0; i < size; ++i) {
    root.push_back(std::sqrt(ordinates.weight[i] * ordinates.mu[i]));
    inverse_mu.push_back(1.0 / ordinates.mu[i]);
  }
  for (std::size_t l = 0; l < degrees; ++l) {
    const double* row = legendre.row(order_ + static_cast<int>(l));
    for (std::size_t i = 0; i < size; ++i) p.push_back(row[i] * root[i] * inverse_mu[i]);
  }
}

template <int N>
LayerOperator<N>::LayerOperator(const ModeBasis& basis) : basis_{basis}, dense_{basis.size} {
  const std::size_t n = basis.size;
  for (Values* m : {&x_even_, &x_odd_, &z_, &z_inverse_, &even_, &odd_, &reflection_,
                    &transmission_, &work_, &more_, &lower_}) {
    m->assign(n * n, 0.0);
  }
  for (Values* v : {&k_, &a_, &b_, &c_, &d_}) v->assign(n, 0.0);
}

template <int N>
void LayerOperator<N>::set(const LayerOptics& optics) {
  optics_ = &optics;
  double most = 0.0;
  for (std::size_t l = basis_.order; l < optics.scatter.size(); ++l) {
    most = std::max(most, std::abs(optics.scatter[l]));
  }
  clear_ = most < least_scattering;
  if (clear_) {
    diagonalised_ = false;
    k_ = basis_.inverse_mu;
  } else if (!optics.like_below || !diagonalised_) {
    diagonalise();
  }
  kappa_.clear();
  for (const double k : k_) kappa_.emplace_back(k * optics.depth);
  if (!clear_) admittances();
}

/// X+ and X-.
template <int N>
void LayerOperator<N>::mix() {
  const std::size_t n = dense_.size();
  std::fill(x_even_.begin(), x_even_.end(), 0.0);
  for (std::size_t i = 0; i < n; ++i) x_even_[i * (n + 1)] = basis_.inverse_mu[i];
  x_odd_ = x_even_;
  for (std::size_t l = 0; l < basis_.degrees; ++l) {
    const double s = optics_->scatter[l + basis_.order];
    if (s == 0.0) continue;
    dense_.add_square(-s, basis_.row(l), l % 2 == 0 ? x_even_.data() : x_odd_.data());
  }
}

template <int N>
void LayerOperator<N>::diagonalise() {
  const std::size_t n = dense_.size();
  mix();
  const bool positive = dense_.cholesky(x_odd_.data(), lower_.data());
  if (!positive) factor_strange();
  // L^T X+ L = Q K^2 Q^T
  dense_.multiply(x_even_.data(), lower_.data(), work_.data());
  dense_.transpose(lower_.data(), more_.data());
  dense_.multiply(more_.data(), work_.data(), x_even_.data());
  decompose<N>(x_even_, k_, work_);
  dense_.multiply(lower_.data(), work_.data(), z_.data());
  if (positive) {
    z_inverse_ = work_;
    dense_.solve_upper(lower_.data(), z_inverse_.data());
  } else {
    dense_.multiply(z_inverse_.data(), work_.data(), more_.data());
    z_inverse_ = more_;
  }
  if (basis_.order == 0) {
    // The smallest tells how nearly scattering conserves light, and is lost in the rounding of the
    // largest: its Rayleigh quotient, from the sums themselves, is not.
    for (std::size_t i = 0; i < n; ++i) a_[i] = z_[i * n];
    double quotient = 0.0;
    for (std::size_t i = 0; i < n; ++i) quotient += a_[i] * a_[i] * basis_.inverse_mu[i];
    for (std::size_t l = 0; l < basis_.degrees; l += 2) {
      const double moment = dense_.dot(basis_.row(l), a_.data());
      quotient -= optics_->scatter[l] * moment * moment;
    }
    k_[0] = quotient;
  }
  // max(0, k), written so that no compiler takes roots first, of negative numbers too, and chooses
  // afterwards
  for (double& k : k_) k = std::sqrt(0.5 * (k + std::abs(k)));
  diagonalised_ = true;
}

/// X- is positive as long as the phase function is. Should the quadrature of a strange one spoil
/// that, its negative part is lifted above 0; any L with L L^T = X- will do. Leaves L and L^-T.
template <int N>
void LayerOperator<N>::factor_strange() {
  const std::size_t n = dense_.size();
  decompose<N>(x_odd_, k_, work_);
  const double floor = 1e-9 * k_[n - 1];
  for (std::size_t j = 0; j < n; ++j) {
    const double root = std::sqrt(std::max(floor, k_[j]));
    for (std::size_t i = 0; i < n; ++i) {
      lower_[i * n + j] = work_[i * n + j] * root;
      z_inverse_[i * n + j] = work_[i * n + j] / root;
    }
  }
}

/// E, F, R and T.
template <int N>
void LayerOperator<N>::admittances() {
  const std::size_t n = dense_.size();
  const double half = 0.5 * optics_->depth;
  const auto response = [&](const Values& z, bool even, Values& result) {
    for (std::size_t j = 0; j < n; ++j) {
      const double ratio = half * kappa_[j].tanh_half_ratio;
      a_[j] = even ? ratio * k_[j] * k_[j] : ratio;
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) more_[i * n + j] = z[i * n + j] * a_[j];
    }
    dense_.transpose(z.data(), work_.data());
    dense_.multiply(more_.data(), work_.data(), result.data());
    work_ = result;
    for (std::size_t i = 0; i < n; ++i) work_[i * (n + 1)] += 1.0;
    dense_.factorise(work_.data());
    dense_.solve(work_.data(), result.data());
  };
  response(z_inverse_, true, even_);
  response(z_, false, odd_);
  for (std::size_t i = 0; i < n * n; ++i) {
    reflection_[i] = odd_[i] - even_[i];
    transmission_[i] = -even_[i] - odd_[i];
  }
  for (std::size_t i = 0; i < n; ++i) transmission_[i * (n + 1)] += 1.0;
}

/// q+ and q- of a source, into a_ and b_.
template <int N>
void LayerOperator<N>::direct(const ModeSource& source) {
  std::fill(a_.begin(), a_.end(), 0.0);
  std::fill(b_.begin(), b_.end(), 0.0);
  if (source.angular.empty()) dense_.add(2.0 * optics_->emissivity, basis_.row(0), a_.data());
  for (std::size_t l = 0; l < source.angular.size(); ++l) {
    const double strength = 2.0 * optics_->scatter[l + basis_.order] * source.angular[l];
    dense_.add(strength, basis_.row(l), l % 2 == 0 ? a_.data() : b_.data());
  }
}

template <int N>
void LayerOperator<N>::emit(const ModeSource& source, std::size_t layer, double* up, double* down) {
  if (source.profile == nullptr || (clear_ && !source.angular.empty())) return;
  const SourceProfile& profile = (*source.profile)[layer];
  if (profile.empty()) return;
  const std::size_t n = dense_.size();
  direct(source);
  // Into the eigensolutions: beta = Z^T q+, alpha = Z~^T q-.
  std::fill(c_.begin(), c_.end(), 0.0);
  std::fill(d_.begin(), d_.end(), 0.0);
  if (clear_) {
    for (std::size_t i = 0; i < n; ++i) c_[i] = a_[i] * std::sqrt(basis_.inverse_mu[i]);
  } else {
    dense_.apply_transposed(z_.data(), a_.data(), c_.data());
    dense_.apply_transposed(z_inverse_.data(), b_.data(), d_.data());
  }
  const double t = optics_->depth;
  for (std::size_t i = 0; i < n; ++i) {
    const SourceProfile::Response r = profile.response(kappa_[i]);
    const double square = kappa_[i].kappa * kappa_[i].kappa;
    const double beta = c_[i], alpha = d_[i];
    c_[i] = 0.5 * (beta * t * r.even - alpha * square * r.odd);
    d_[i] = 0.5 * t * (alpha * r.even - beta * t * r.odd);
  }
  finish(c_.data(), d_.data(), up, down);
}

/// Out of the eigensolutions again: (1 - E) Z~ even and (1 - F) Z odd, their sum going up.
template <int N>
void LayerOperator<N>::finish(const double* even, const double* odd, double* up,
                              double* down) const {
  const std::size_t n = dense_.size();
  if (clear_) {  // Z = mu^-1/2, Z~ = mu^1/2, Ye = Yo = tanh(kappa / 2)
    for (std::size_t i = 0; i < n; ++i) {
      const double share = 0.5 * (1.0 + kappa_[i].fade), z = std::sqrt(basis_.inverse_mu[i]);
      up[i] += share * (even[i] / z + odd[i] * z);
      down[i] += share * (even[i] / z - odd[i] * z);
    }
    return;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double e = dense_.dot(z_inverse_.data() + i * n, even);
    const double o = dense_.dot(z_.data() + i * n, odd);
    up[i] += e + o;
    down[i] += e - o;
    for (std::size_t j = 0; j < n; ++j) {
      const double f = even_[j * n + i] * e, g = odd_[j * n + i] * o;
      up[j] -= f + g;
      down[j] -= f - g;
    }
  }
}

template class LayerOperator<0>;
template class LayerOperator<2>;
template class LayerOperator<4>;
template class LayerOperator<8>;

}  // namespace nadir::atmosphere
