#pragma once

#include "core/quantity.hpp"

namespace nadir::radiometry {

/// Radiance below which what a surface emits is lost in what it reflects, W m^-2 sr^-1 um^-1.
///
/// Under the sun or moon: 1e-6 of a white surface's radiance outside the air, which is a thousandth
/// of what a dark surface (0.05) shows in deep shadow (0.02 of the light). Without either: 1e-10, a
/// hundredth of what that surface shows under the night sky, whose glow is 2e-7 in the visible
/// (docs/night-light.md).
/// @param irradiance  of all bodies above the horizon, outside the air, W m^-2 um^-1
[[nodiscard]] double faintest_emission(SpectralIrradiance irradiance) noexcept;

/// Whether a black surface of that temperature would be seen to emit.
[[nodiscard]] bool emission_counts(Kelvin temperature, Micrometres wavelength,
                                   SpectralIrradiance irradiance);

}  // namespace nadir::radiometry
