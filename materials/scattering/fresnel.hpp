#pragma once

#include "spectral/lanes.hpp"

namespace nadir::materials {

/// Unpolarised reflectance (R_s + R_p) / 2 of a smooth face between vacuum (or air) and a medium of
/// complex refractive index m = n + i k, for light that arrives from the vacuum side. With
/// c = cos_incidence, s^2 = 1 - c^2 and g = u + i v = sqrt(m^2 - s^2):
///
///     R_s = ((c - u)^2 + v^2) / ((c + u)^2 + v^2)
///     R_p = R_s ((u c - s^2)^2 + v^2 c^2) / ((u c + s^2)^2 + v^2 c^2)
///
/// @param cos_incidence  in [-1, 1]; its sign does not matter
/// @param n              > 0; below 1 (reststrahlen bands) total reflection comes out by itself
/// @param k              >= 0; 0: a dielectric
/// @return               in [0, 1]; exact but for rounding (1e-15)
/// Source: Born & Wolf, Principles of Optics, 7th ed. (1999), sections 1.5 and 14.2, squared out.
[[nodiscard]] double fresnel_reflectance(double cos_incidence, double n, double k) noexcept;

/// Unpolarised reflectance of a smooth face between two dielectrics.
///
/// @param cos_incidence  in [-1, 1], in the medium that the light comes from; the sign is ignored
/// @param eta            n_transmitted / n_incident, > 0; where Snell's law has no solution the
///                       reflection is total
/// @return               in [0, 1]
/// Source: Born & Wolf (1999), section 1.5.2.
[[nodiscard]] double fresnel_dielectric(double cos_incidence, double eta) noexcept;

/// The same per lane.
[[nodiscard]] spectral::Spectrum fresnel_reflectance(double cos_incidence,
                                                     const spectral::Spectrum& n,
                                                     const spectral::Spectrum& k) noexcept;
[[nodiscard]] spectral::Spectrum fresnel_dielectric(double cos_incidence,
                                                    const spectral::Spectrum& eta) noexcept;

}  // namespace nadir::materials
