#pragma once

#include <cstdint>
#include <vector>

namespace nadir::materials {

/// One band of an image as plain data, row-major; NaN where it has no value.
struct ContrastImage {
  int columns = 0, rows = 0;
  std::vector<float> values;  ///< any unit: only its contrast counts
};

/// Picks for every pixel one of several spectra of the same material, so that the variety of the
/// spectra follows the texture of a picture.
///
/// The pixel's standard score z = (value - mean) / sigma is compared with the scores of the
/// spectra, z_i = (rho_i - mean of rho) / sigma of rho, by their mean reflectances rho_i in the
/// picture's band; the nearest is taken, of equals the first. Mean and sigma of the picture are
/// those of all its pixels, or with `half_window` > 0 of the (2 half_window + 1)^2 pixels about
/// each one (cut at the edges), which takes slow changes of brightness out of the picture. Pixels
/// without a value, and pictures or spectra without contrast, have z = 0.
///
/// @param mean_reflectance  of each spectrum in the band, 1; at least one, at most 65536
/// @return the number of a spectrum for each pixel
/// @throws InputError for an image that is not full, or no spectrum or too many
[[nodiscard]] std::vector<std::uint16_t> contrast_choice(
    const ContrastImage& image, const std::vector<double>& mean_reflectance, int half_window = 0);

}  // namespace nadir::materials
