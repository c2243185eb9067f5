#pragma once

#include <span>

#include "sim/run/image.hpp"
#include "spectral/band_quadrature.hpp"

namespace nadir::sim {

/// Merges another, independent image of the same pixels into one: each pixel becomes the mean of
/// both, weighted by their paths N_i, and
///
///     se^2 = sum N_i^2 se_i^2 / (sum N_i)^2,
///
/// the variance of that mean where the two are independent. Shares are weighted alike, paths add
/// up, the brightness temperature is computed anew from the merged radiance, the truth stays that
/// of `into`. What a detector made of the radiance (`dn`, `electrons`, `noise`) is dropped: it has
/// to count again. A pixel without paths counts nothing.
/// @param quadratures  one a band; where there is none for a band with a brightness temperature,
///                     that is merged like the radiance, right to first order in the errors
/// @throws std::invalid_argument where the two are not of the same pixels and bands
void merge(ArrayImage& into, const ArrayImage& other,
           std::span<const spectral::BandQuadrature> quadratures);

}  // namespace nadir::sim
