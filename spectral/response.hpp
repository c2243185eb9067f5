#pragma once

#include <variant>

#include "core/quantity.hpp"
#include "spectral/curve.hpp"

namespace nadir::spectral {

/// Relative spectral response from a table; its peak need not be 1.
struct TabulatedResponse {
  Curve curve;  ///< dimensionless, >= 0, Outside::zero
};

/// exp(-4 ln 2 ((lambda - centre) / fwhm)^2), cut where it falls below 1e-4 (the level below which
/// published responses are dropped).
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

[[nodiscard]] double at(const Response& response, Micrometres wavelength) noexcept;

struct Support {
  Micrometres lo, hi;
};
/// The interval outside which the response is 0.
[[nodiscard]] Support support(const Response& response) noexcept;
/// Centroid of the response, int lambda R / int R.
[[nodiscard]] Micrometres centre(const Response& response);
/// Full width at half maximum: outermost crossings of half the peak.
[[nodiscard]] Micrometres fwhm(const Response& response);

}  // namespace nadir::spectral
