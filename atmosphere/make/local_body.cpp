#include "atmosphere/make/local_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "atmosphere/paths/spherical_path.hpp"

namespace nadir::atmosphere {
namespace {

// Steps of elevation as wide as the sun's disc: finer detail of the earth's shadow does not exist.
constexpr double step_rad = 0.5 * std::numbers::pi / 180.0;
// Paths reach 1150 km from the ground and twice that past the limb from high in the air.
constexpr double reach_rad = 0.36;

}  // namespace

LocalBody::LocalBody(const Shells& shells, const std::vector<double>& scaled_depth, double mu0)
    : levels_{shells.level_m.size()} {
  const double elevation = std::asin(mu0);
  lowest_rad_ = elevation - reach_rad;
  const int steps = static_cast<int>(std::ceil(2.0 * reach_rad / step_rad));
  transmittance_.reserve(levels_ * static_cast<std::size_t>(steps + 1));
  for (int i = 0; i <= steps; ++i) {
    const double sine = std::sin(lowest_rad_ + i * step_rad);
    for (const double depth : slant_depths(shells.level_m, scaled_depth, sine)) {
      transmittance_.push_back(std::exp(-depth));
    }
  }
}

double LocalBody::transmittance(int layer, double top, double mu0) const noexcept {
  const int last = static_cast<int>(transmittance_.size() / levels_) - 1;
  const double place = (std::asin(std::clamp(mu0, -1.0, 1.0)) - lowest_rad_) / step_rad;
  const int i = std::clamp(static_cast<int>(place), 0, last - 1);
  const double t = std::clamp(place - i, 0.0, 1.0);
  const double* row = transmittance_.data() + static_cast<std::size_t>(i) * levels_ +
                      static_cast<std::size_t>(layer);
  const double upper = row[0] + t * (row[levels_] - row[0]);
  const double lower = row[1] + t * (row[levels_ + 1] - row[1]);
  // Transmittance fades exponentially with depth; in the earth's shadow, linearly.
  if (lower > 1e-30 && upper > 1e-30) return lower * std::pow(upper / lower, top);
  return lower + top * (upper - lower);
}

double local_share(double mu0) noexcept {
  constexpr double whole = 0.2, none = 0.25;
  const double x = std::clamp((none - mu0) / (none - whole), 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

}  // namespace nadir::atmosphere
