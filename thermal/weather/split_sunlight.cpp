#include "thermal/weather/split_sunlight.hpp"

#include <algorithm>

namespace nadir::thermal {

double diffuse_share(double clearness) noexcept {
  const double k = std::max(0.0, clearness);
  if (k <= 0.22) return 1.0 - 0.09 * k;
  if (k > 0.80) return 0.165;
  return 0.9511 + k * (-0.1604 + k * (4.388 + k * (-16.638 + k * 12.336)));
}

SplitSunlight split_sunlight(double global_horizontal_w_m2, const SunOverStation& sun) noexcept {
  constexpr double least_cosine_for_clearness = 0.065;
  constexpr double least_cosine_for_direct = 0.05233595624294383;  // cos(87 degrees)
  const double global = std::max(0.0, global_horizontal_w_m2);
  if (sun.cos_zenith < least_cosine_for_direct) return {0.0, global};
  const double without_air =
      sun.extraterrestrial_w_m2 * std::max(sun.cos_zenith, least_cosine_for_clearness);
  const double diffuse = diffuse_share(global / without_air) * global;
  const double direct = std::min((global - diffuse) / sun.cos_zenith, sun.extraterrestrial_w_m2);
  return {direct, global - direct * sun.cos_zenith};
}

}  // namespace nadir::thermal
