#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sim/products/band_choice.hpp"
#include "sim/products/canvas.hpp"
#include "sim/run/image.hpp"

namespace nadir::sim {

/// The colours of an array's pixels, row-major, and how many of them had no value to show.
struct Picture {
  std::vector<Rgb> pixels;
  std::size_t invalid_pixels = 0;  ///< painted in `invalid_colour`
};

/// From radiance to the linear light of a display, 1 being white. For channel c
///
///     v = max(0, gain_c (L - dark_c)),   x = e v (1 + e v / w^2) / (1 + e v),  w = max(1, e)
///
/// the second being the extended curve of E. Reinhard, M. Stark, P. Shirley and J. Ferwerda,
/// "Photographic tone reproduction for digital images", ACM TOG 21, 267 (2002), eq. 4: nearly a
/// straight line for dark pixels, a gentle shoulder for bright ones, white at v = 1. The shoulder
/// makes colours paler; `saturation` gives that back: x_c moves away from the luminance y of the
/// three (weights of IEC 61966-2-1) to y + saturation (x_c - y), cut to 0 .. 1.
struct ToneCurve {
  std::array<double, 3> dark{};               ///< W m^-2 sr^-1 um^-1
  std::array<double, 3> gain{1.0, 1.0, 1.0};  ///< per W m^-2 sr^-1 um^-1
  double exposure = 1.0;                      ///< e, > 0
  double saturation = 1.0;

  [[nodiscard]] std::array<double, 3> display(const std::array<double, 3>& radiance) const;
};

/// The curve for three bands, from robust percentiles of the pixels that see a surface and, where
/// the sky is in the picture, of those that see it.
///
/// Dark point: 0.9 of each channel's 0.5th percentile over surfaces takes off most of the air's
/// path radiance, that is its blue cast; at most 0.63 of their 99.5th, so that a plain grey scene
/// keeps its tone. White point: the highest of the channels' 99.5th percentiles, over surfaces or
/// over all pixels, whichever is more: a sky brighter than the ground is not burnt out, its sun is.
/// One for all three in natural colour, after division by the sun's colour (a black body of 5772 K,
/// the nominal effective temperature of IAU 2015 resolution B3), so that what is grey in
/// reflectance looks grey. In false colour each channel has its own. Exposure: the median luminance
/// comes to 0.18 before the shoulder, the middle grey of photography; lifted 16 times at most. With
/// sky in the picture, it is the geometric mean of the medians of ground and sky, weighted by their
/// shares of the picture, the sky's at most one half.
[[nodiscard]] ToneCurve fit_tone_curve(const ArrayImage& image, const BandChoice& choice);

/// Paints one band in grey, or three in colour, through the curve and the sRGB transfer function
/// (IEC 61966-2-1). Pixels whose radiance is no finite number get `invalid_colour`.
[[nodiscard]] Picture tone_map(const ArrayImage& image, const BandChoice& choice);
/// The same through a given curve, so that several images can be compared.
[[nodiscard]] Picture tone_map(const ArrayImage& image, const BandChoice& choice,
                               const ToneCurve& curve);

/// Which pixels to take statistics from: those that see a surface, or all where fewer than one in
/// a hundred does or the truth is not there.
[[nodiscard]] std::vector<bool> surface_pixels(const ArrayImage& image);

}  // namespace nadir::sim
