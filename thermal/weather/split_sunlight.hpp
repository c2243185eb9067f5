#pragma once

namespace nadir::thermal {

/// Where the sun stands over a station and how it shines outside the air.
struct SunOverStation {
  double cos_zenith = 0.0;                ///< below 0: set
  double extraterrestrial_w_m2 = 1361.0;  ///< on a plane normal to its direction; > 0
};

/// Sunlight, split.
struct SplitSunlight {
  double direct_normal_w_m2 = 0.0;
  double diffuse_horizontal_w_m2 = 0.0;
};

/// Share of diffuse light in sunlight on level ground by the clearness index k, the ratio of what
/// arrives to what would without air (hourly means; Erbs, Klein & Duffie, Solar Energy 28, 293,
/// 1982, doi:10.1016/0038-092X(82)90302-4, eq. 1; fitted to five stations of the United States):
///
///     k <= 0.22: 1 - 0.09 k;   k > 0.80: 0.165;   between
///     0.9511 - 0.1604 k + 4.388 k^2 - 16.638 k^3 + 12.336 k^4
///
/// Standard deviation about 0.1 to 0.15 at middling k, where broken clouds and haze differ.
[[nodiscard]] double diffuse_share(double clearness) noexcept;

/// Direct and diffuse sunlight from all of it on level ground, so that direct cos(zenith) + diffuse
/// is that again. A sun lower than 3 degrees counts as diffuse altogether, since small errors of
/// angle and time would blow up in the division by its cosine; so does what would make direct light
/// brighter than outside the air. For the clearness index the cosine is at least 0.065 (3.7
/// degrees), as pvlib has it.
/// @param global_horizontal_w_m2  a pyranometer's small negative values of the night count as 0
[[nodiscard]] SplitSunlight split_sunlight(double global_horizontal_w_m2,
                                           const SunOverStation& sun) noexcept;

}  // namespace nadir::thermal
