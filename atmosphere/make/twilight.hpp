#pragma once

namespace nadir::atmosphere {

/// Illuminance of level ground by sun and clear sky over the sun's elevation, lux; -18 degrees to
/// 90. A cubic in the elevation for the decimal logarithm, in six pieces; within 5 % of the
/// measurements that they fit, which scatter by more.
/// Source: Janiczek & DeYoung, U.S. Naval Observatory Circular 171 (1987), table 1; the same in
/// Seidelmann, Explanatory Supplement to the Astronomical Almanac (1992), section 9.3.
[[nodiscard]] double ground_illuminance_lux(double elevation_deg) noexcept;

/// What the computed light of a set body is short of. Down to 2 degrees below the horizon the
/// illuminance computed for clear air (US standard, rural haze of 23 km) is within 10 % of
/// ground_illuminance_lux; below, light that has been scattered twice far apart, which a column at
/// a time does not know, makes up a growing part: this factor is measured over computed, linear
/// between whole degrees. 1 above -2 degrees, held below -6.
[[nodiscard]] double twilight_growth(double elevation_deg) noexcept;

}  // namespace nadir::atmosphere
