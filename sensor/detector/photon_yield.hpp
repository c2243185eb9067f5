#pragma once

#include "core/quantity.hpp"
#include "sensor/detector/detector.hpp"
#include "spectral/response.hpp"

namespace nadir::sensor {

/// What a band's response R says of a detector that counts photons. R weights radiance; an electron
/// a photon weights it by lambda / (h c) besides, so that the efficiency behind R is
///
///     eta(lambda) tau(lambda) = eta tau (R / lambda) / max(R / lambda)
///
/// with eta and tau the figures at its peak, and electrons are exactly proportional to the band's
/// radiance L = int L R / int R:  int L eta tau lambda / (h c) = yield eta tau L.
struct PhotonYield {
  /// int R dlambda / (h c max(R / lambda)): photons, weighted by relative efficiency, per unit of
  /// band radiance, J^-1 um.
  double per_radiance = 0.0;
};
/// @param response  one that `spectral::check` accepts
[[nodiscard]] PhotonYield photon_yield(const spectral::Response& response);

/// Solid angle by which the focal plane's irradiance is E = Omega tau L on the axis, sr:
///     Omega = pi (1 - e^2) / (1 + 4 N^2).
[[nodiscard]] double cone_sr(const Optics& optics) noexcept;
/// What the shield fills, sr: pi - pi / (1 + 4 N^2).
[[nodiscard]] double shield_sr(const Optics& optics) noexcept;

/// Mean of the black body's radiance over the band, W m^-2 sr^-1 um^-1.
/// @param temperature  > 0
[[nodiscard]] double band_planck(const spectral::Response& response, Kelvin temperature);
/// Its derivative, W m^-2 sr^-1 um^-1 K^-1.
[[nodiscard]] double band_planck_derivative(const spectral::Response& response, Kelvin temperature);

}  // namespace nadir::sensor
