#pragma once

#include <variant>

#include "core/quantity.hpp"
#include "spectral/curve.hpp"

namespace nadir::spectral {

/// Relative spectral response from a table; its peak need not be 1.
struct TabulatedResponse {
  Curve curve;  ///< dimensionless, >= 0; taken as 0 outside the table
};

/// exp(-4 ln 2 ((lambda - centre) / fwhm)^2), cut where it falls below 1e-4, 1.82 fwhm from the
/// centre (the level below which published responses are dropped).
struct GaussianResponse {
  Micrometres centre;
  Micrometres fwhm;
};

/// 1 between two wavelengths, 0 elsewhere.
struct BoxResponse {
  Micrometres lo;
  Micrometres hi;
};

/// The relative spectral response (RSR) of a band, weighting spectral radiance.
using Response = std::variant<TabulatedResponse, GaussianResponse, BoxResponse>;

/// @throws InputError  for a response that no band can have: not positive and ascending limits, a
///                     table with a negative value, without a positive one or without wavelengths
void check(const Response& response);

// What follows expects a response that `check` accepts.

[[nodiscard]] double at(const Response& response, Micrometres wavelength);

struct Support {
  Micrometres lo, hi;
};
/// The narrowest interval outside which the response is 0.
[[nodiscard]] Support support(const Response& response);
/// Centroid of the response, int lambda R / int R.
[[nodiscard]] Micrometres centre(const Response& response);
/// Full width at half maximum: between the outermost crossings of half the peak, or the ends of a
/// table that is cut off above it.
[[nodiscard]] Micrometres fwhm(const Response& response);

}  // namespace nadir::spectral
