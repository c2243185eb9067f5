#pragma once

#include <vector>

namespace nadir::spectral {

/// Nodes, ascending, and positive weights of a quadrature rule.
struct Rule {
  std::vector<double> nodes;
  std::vector<double> weights;
};

/// Recurrence of the polynomials that are orthonormal for a positive measure of mass 1:
///     x p_k = b_(k+1) p_(k+1) + a_k p_k + b_k p_(k-1),   p_0 = 1.
struct Recurrence {
  std::vector<double> a;  ///< a_0 .. a_(n-1)
  std::vector<double> b;  ///< b_1 .. b_(n-1), each > 0
};

/// Gauss rule of n points, exact for polynomials of degree 2 n - 1. The nodes are the eigenvalues
/// of the tridiagonal matrix (a, b), found by bisection; the weights are Christoffel's numbers.
///
/// @param lo, hi  an interval that holds the measure
/// Accuracy: nodes to the spacing of doubles at the ends of [lo, hi].
/// Source: Golub & Welsch, Math. Comp. 23, 221 (1969); Barth, Martin, Wilkinson, Numer. Math. 9,
/// 386 (1967) for the bisection; Gautschi, "Orthogonal Polynomials" (2004), section 1.4.2.
[[nodiscard]] Rule gauss_rule(const Recurrence& recurrence, double lo, double hi);

/// Gauss-Legendre rule on [-1, 1]; the weights sum to 1 (a mean, not an integral). n >= 1.
[[nodiscard]] Rule gauss_legendre(int n);

/// First n coefficients of the recurrence for a discrete measure. Needs at least n nodes; stable
/// for many more nodes than n.
/// Source: discretised Stieltjes procedure, Gautschi (2004), section 2.2.
[[nodiscard]] Recurrence stieltjes(const Rule& measure, int n);

}  // namespace nadir::spectral
