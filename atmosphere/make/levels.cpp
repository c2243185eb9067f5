#include "atmosphere/make/levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/error.hpp"

namespace nadir::atmosphere {
namespace {

constexpr double space_m = 100e3;  // above lies less than 1e-6 of the air
constexpr double boundary_m = 2000.0;
constexpr double lowest_m = 30.0;  // level views at the ground see the haze of the lowest layer

/// Above the ground: the haze's region.
constexpr std::array<double, 7> low_m{100.0, 250.0, 500.0, 750.0, 1000.0, 1500.0, 2000.0};
/// Above sea level. A layer holds at most a fifth of a scale height up to 10 km, a third up to 30
/// km and two thirds above: what is lit there in twilight must thin out as the air does.
constexpr std::array<double, 29> high_m{
    3e3,  4e3,    5e3,  6e3,  7e3,  8e3,  9e3,  10e3, 11e3, 12e3, 14e3, 16e3, 18e3, 20e3, 22.5e3,
    25e3, 27.5e3, 30e3, 33e3, 36e3, 40e3, 44e3, 48e3, 53e3, 58e3, 64e3, 71e3, 79e3, 88e3};

/// Drops heights that lie closer than `gap` to one that must stay.
void keep_clear(std::vector<double>& heights, const std::vector<double>& fixed, double gap) {
  std::erase_if(heights, [&](double z) {
    return std::any_of(fixed.begin(), fixed.end(), [&](double f) { return std::abs(f - z) < gap; });
  });
}

/// Cuts a region of even extinction from both its edges inwards: depths 0.25, 0.5, 1, 2, ...
void cut_region(std::vector<double>& heights, double bottom_m, double top_m, double depth) {
  double cut = 0.25, step = 0.25;
  for (; cut < 0.5 * depth; step *= 2.0, cut += step) {
    const double way = (top_m - bottom_m) * cut / depth;
    heights.push_back(bottom_m + way);
    heights.push_back(top_m - way);
  }
}

/// Forward peaks hold about half of the scattering of haze and clouds.
constexpr double smooth_part = 0.5;

std::vector<double> fixed_levels(const Aerosol& aerosol, const std::vector<Cloud>& clouds,
                                 double ground_m, double top_m) {
  std::vector<double> fixed = Particles::edges_m(aerosol, clouds, ground_m);
  for (const Cloud& cloud : clouds) {
    cut_region(fixed, ground_m + cloud.base_m, ground_m + cloud.top_m,
               smooth_part * cloud.optical_depth_550);
  }
  if (aerosol.type != AerosolType::none) {
    // Koschmieder; an optical depth that is asked for may mean more haze than the visibility.
    double depth = 3.912 / aerosol.visibility_km * boundary_m / 1000.0;
    depth = aerosol.optical_depth_550.value_or(depth);
    if (depth > 2.0) {
      cut_region(fixed, ground_m, ground_m + boundary_m, smooth_part * depth);
    }
    fixed.push_back(ground_m + lowest_m);
  }
  std::erase_if(fixed, [&](double z) { return z <= ground_m || z >= top_m; });
  fixed.push_back(ground_m);
  fixed.push_back(top_m);
  std::sort(fixed.begin(), fixed.end());
  // Edges that fall together to a metre are one.
  std::vector<double> kept;
  for (const double z : fixed) {
    if (kept.empty() || z - kept.back() > 1.0) kept.push_back(z);
  }
  kept.back() = top_m;
  return kept;
}

double interpolated(const std::vector<double>& heights, const Profile& profile, double z) {
  const auto upper = std::upper_bound(heights.begin(), heights.end(), z);
  if (upper == heights.begin() || upper == heights.end()) return level_at(profile, z).temperature_k;
  const double a = *(upper - 1), b = *upper;
  const double ta = level_at(profile, a).temperature_k, tb = level_at(profile, b).temperature_k;
  return ta + (tb - ta) * (z - a) / (b - a);
}

/// Adds the profile's level that straight lines miss by most, while that is more than 1 K.
void follow_temperature(std::vector<double>& heights, const Profile& profile) {
  constexpr std::size_t most_levels = 48;
  while (heights.size() < most_levels) {
    double worst = 1.0, where = -1.0;
    for (const Level& level : profile.levels) {
      const double z = level.height_m;
      if (z <= heights.front() + 20.0 || z >= std::min(heights.back(), 50e3)) continue;
      const double miss = std::abs(interpolated(heights, profile, z) - level.temperature_k);
      if (miss > worst) worst = miss, where = z;
    }
    if (where < 0.0) return;
    heights.insert(std::upper_bound(heights.begin(), heights.end(), where), where);
  }
}

}  // namespace

std::vector<double> column_levels_m(const Profile& profile, const Aerosol& aerosol,
                                    const std::vector<Cloud>& clouds, double ground_m) {
  if (profile.levels.size() < 2) throw InputError("the air's profile has fewer than two levels");
  const double first_m = profile.levels.front().height_m - profile.reaches_below_m;
  const double top_m = std::min(space_m, profile.levels.back().height_m);
  if (!(ground_m >= first_m)) {
    throw InputError("the ground, " + std::to_string(ground_m) +
                     " m above sea level, lies below the air's profile, which begins at " +
                     std::to_string(first_m) + " m");
  }
  if (!(ground_m < top_m - 100.0)) {
    throw InputError("the ground, " + std::to_string(ground_m) +
                     " m above sea level, lies above all but the last 100 m of the air's profile, "
                     "which ends at " +
                     std::to_string(top_m) + " m");
  }
  const std::vector<double> fixed = fixed_levels(aerosol, clouds, ground_m, top_m);
  std::vector<double> heights;
  for (const double z : low_m) heights.push_back(ground_m + z);
  for (const double z : high_m) {
    if (z > ground_m + boundary_m + 500.0) heights.push_back(z);
  }
  std::erase_if(heights, [&](double z) { return z >= top_m; });
  keep_clear(heights, fixed, 60.0);
  heights.insert(heights.end(), fixed.begin(), fixed.end());
  std::sort(heights.begin(), heights.end());
  follow_temperature(heights, profile);
  std::reverse(heights.begin(), heights.end());
  return heights;
}

}  // namespace nadir::atmosphere
