#pragma once

#include "sensor/optics/point_spread.hpp"

namespace nadir::sensor {

/// The distance that holds a share of the stray light within it, m.
///
///     share(r) = g(r) / g(reach),  g(r) = ((1 + (r/c)^2)^(1-s) - 1) / (1 - s)
///
/// with core c and slope s; for s = 1, g(r) = log(1 + (r/c)^2).
[[nodiscard]] double stray_distance(const StraySpread& stray, double share) noexcept;

/// Modulation of the stray light alone at a frequency, cycles per metre: Hankel transform of 2000
/// rings of equal light, each even within itself; to 1e-3.
[[nodiscard]] double stray_mtf(const StraySpread& stray, double frequency_per_m);

}  // namespace nadir::sensor
