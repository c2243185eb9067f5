#pragma once

#include <vector>

#include "core/quantity.hpp"
#include "spectral/lanes.hpp"
#include "spectral/response.hpp"

namespace nadir::spectral {

/// Wavelengths and weights for which  sum_i weight[i] L(wavelength[i])  is the band radiance
///     L_band = int L R dlambda / int R dlambda        [W m^-2 sr^-1 um^-1]
/// Weights are positive and sum to 1.
struct BandQuadrature {
  std::vector<Micrometres> wavelengths;  ///< ascending, inside the band
  std::vector<double> weights;
};

/// Gauss quadrature with the response as its weight function: exact for radiance that is a
/// polynomial of degree 2 n - 1 in wavelength over the band. Discretised Stieltjes procedure and
/// Golub-Welsch (Gautschi, "Orthogonal Polynomials", 2004, sections 2.2 and 3.1).
///
/// @param count  number of wavelengths n, 1 .. 32
/// @throws InputError  for another count, or a response that `check` refuses
/// Accuracy: 1e-14 of the largest value of such a polynomial in the band.
[[nodiscard]] BandQuadrature gauss_quadrature(const Response& response, int count);

/// The part of a band that each node of its quadrature stands for: edges (one more than nodes) that
/// cut the support into consecutive intervals, each with its node's share of the response,
///
///     int_{edge i}^{edge i+1} R dlambda = weight[i] int R dlambda.
///
/// Every node lies inside its interval: the separation theorem of Chebyshev, Markov and Stieltjes
/// (Szego, "Orthogonal Polynomials", 4th ed. 1975, theorem 3.41.1).
/// Accuracy: 1e-12 of the band's width.
[[nodiscard]] std::vector<Micrometres> interval_edges(const Response& response,
                                                      const BandQuadrature& band);

/// Temperature of the black body whose band radiance is the given one; 0 K for radiance 0, NaN for
/// negative radiance. Accuracy: relative error below 2e-15.
[[nodiscard]] Kelvin band_brightness_temperature(const BandQuadrature& band,
                                                 SpectralRadiance radiance) noexcept;

/// The lanes that a set of bands needs, in blocks of at most lane_capacity, and the way back.
struct SpectralPlan {
  struct Term {
    int block;      ///< which of `blocks`
    int lane;       ///< which lane of it
    double weight;  ///< of that lane in the band's radiance
  };
  std::vector<Lanes> blocks;
  std::vector<std::vector<Term>> bands;  ///< for each band the terms of its sum
};

/// Merges the bands' wavelengths, each distinct one simulated once; those within 1e-9 (relative) of
/// a shorter one are taken there. A band's lanes may fall into two blocks.
[[nodiscard]] SpectralPlan plan_lanes(const std::vector<BandQuadrature>& bands);

/// A lane that is split by the gases of the air, and how much it counts in a band.
struct LaneShare {
  Micrometres wavelength;
  AbsorptionLane absorption;
  double weight = 0.0;
};

/// The same for bands whose lanes are split: each distinct one (wavelength, interval and term) is
/// simulated once. The terms of one wavelength may fall into two blocks.
[[nodiscard]] SpectralPlan plan_split_lanes(const std::vector<std::vector<LaneShare>>& bands);

}  // namespace nadir::spectral
