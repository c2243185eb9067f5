#pragma once

namespace nadir::radiometry::thresholds {

// The weights at which the generic radiometry solver stops caring. A *sample weight* is the weight
// of the ray that asked (1 at the aperture) times the largest reflectance over the wavelengths
// times the cosine of the sample's zenith angle. Not scenario parameters: docs/radiometry.md.

/// A ray of less weight gets the self-emission of what it hits and nothing else.
inline constexpr double current_weight = 1e-6;
/// A sample towards sun, moon or lamp of less weight is skipped.
inline constexpr double target_weight = 1e-7;
/// A full sample of less weight is downgraded to a direct-only sample.
inline constexpr double full_background_weight = 1e-5;
/// A direct-only sample of less weight is skipped.
inline constexpr double quick_weight = 1e-8;
/// A sample in whose direction no wavelength has this much reflectance is skipped.
inline constexpr double raw_weight = 1e-7;

}  // namespace nadir::radiometry::thresholds
