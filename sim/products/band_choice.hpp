#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/run/image.hpp"

namespace nadir::sim {

/// How a quick look shows an array.
enum class Look { natural_colour, false_colour, grey, temperature };

struct BandChoice {
  Look look = Look::grey;
  std::vector<std::size_t> bands;  ///< for red, green and blue, or one
  bool as_wanted = true;           ///< false where the wanted names are not this array's
};

/// Bands beyond this wavelength show the ground's own heat rather than the sun's light. [um]
inline constexpr double thermal_from_um = 3.0;

/// The bands that show an array best.
///
/// Wanted by name: three for red, green and blue, or one. Otherwise, and where the array lacks one
/// of the names: temperature, if all its bands lie beyond 3 um, from the band nearest to 10.9 um,
/// where the air is clearest; natural colour, if there are bands within 60 nm of 0.655, 0.56 and
/// 0.48 um; false colour from the longest, middle and shortest of three or more bands below 3 um;
/// else grey from the band whose contrast stands out most above its noise.
[[nodiscard]] BandChoice choose_bands(const ArrayImage& image,
                                      const std::vector<std::string>& wanted);

/// What `choose_bands` would choose from, knowing names and wavelengths but no pixels: one choice,
/// or several shades of grey.
[[nodiscard]] std::vector<BandChoice> choices_of(const ArrayImage& image,
                                                 const std::vector<std::string>& wanted);

}  // namespace nadir::sim
