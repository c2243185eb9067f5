#include "materials/lambertian.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nadir::materials {

double Lambertian::eval(Vec3 wi, Vec3 wo) const noexcept {
  return wi.z > 0.0 && wo.z > 0.0 ? std::numbers::inv_pi : 0.0;
}

double Lambertian::pdf(Vec3 wi, Vec3 wo) const noexcept {
  return wi.z > 0.0 && wo.z > 0.0 ? wi.z * std::numbers::inv_pi : 0.0;
}

// Malley: a uniform point on the disc, lifted to the hemisphere, has density cos / pi.
std::optional<ScatteringSample> Lambertian::sample(Vec3 wo, Vec2 u) const noexcept {
  if (wo.z <= 0.0) return std::nullopt;
  const double radius = std::sqrt(u.x), azimuth = 2.0 * std::numbers::pi * u.y;
  const double z = std::sqrt(std::max(0.0, 1.0 - u.x));
  if (z <= 0.0) return std::nullopt;
  const Vec3 wi{radius * std::cos(azimuth), radius * std::sin(azimuth), z};
  return ScatteringSample{wi, z * std::numbers::inv_pi, 1.0};
}

}  // namespace nadir::materials
