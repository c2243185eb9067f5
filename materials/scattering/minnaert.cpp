#include "materials/scattering/minnaert.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"
#include "materials/scattering/cosine_lobe.hpp"

namespace nadir::materials {

using spectral::Spectrum;

namespace {
constexpr double limb_cut = 0.1;
}

BoundMinnaert::BoundMinnaert(const Minnaert& model, const BindContext& context)
    : reflectance_{context.reflectance}, k_{model.k}, cut_{model.k < 1.0 ? limb_cut : 0.0} {
  const double tail = cut_ > 0.0 ? std::pow(cut_, k_ + 1.0) : 0.0;
  below_ = 0.5 * tail;
  integral_ = below_ + (1.0 - tail) / (k_ + 1.0);

  const double brightening = limb(0.0);
  const auto brightest = static_cast<double>(reflectance_.max());
  // one part in a million: the rounding of lanes
  if (k_ < 1.0 && brightest * brightening > 1.0 + 1e-6) {
    throw InputError{"minnaert: k is " + number_text(k_) + " and the reflectance up to " +
                     number_text(brightest) +
                     ": more than all light would be reflected at the limb; "
                     "with this k the reflectance must be at most " +
                     number_text(1.0 / brightening)};
  }
}

double BoundMinnaert::limb(double mu) const noexcept {
  return k_ == 1.0 ? 1.0 : std::pow(std::max(mu, cut_), k_ - 1.0);
}

Spectrum BoundMinnaert::eval(Vec3 wi, Vec3 wo) const noexcept {
  if (!on_one_side(wi, wo)) return Spectrum{reflectance_.count()};
  const double shape = limb(std::abs(wi.z)) * limb(std::abs(wo.z));
  return reflectance_ * static_cast<float>(shape / (2.0 * std::numbers::pi * integral_));
}

double BoundMinnaert::pdf(Vec3 wi, Vec3 wo) const noexcept {
  if (!on_one_side(wi, wo)) return 0.0;
  const double mu = std::abs(wi.z);
  return limb(mu) * mu / (2.0 * std::numbers::pi * integral_);
}

// Inverts the distribution of mu, whose density is h(mu) mu / I.
std::optional<ScatteringSample> BoundMinnaert::sample(Vec3 wo,
                                                      const ScatteringDraw& u) const noexcept {
  if (wo.z == 0.0) return std::nullopt;
  const double area = (1.0 - u.point.x) * integral_;  // above 0
  double mu = 0.0;
  if (area < below_) {
    mu = cut_ * std::sqrt(area / below_);
  } else {
    mu = std::pow((k_ + 1.0) * (area - below_) + 2.0 * below_, 1.0 / (k_ + 1.0));
  }
  mu = std::min(mu, 1.0);
  const double sine = std::sqrt((1.0 - mu) * (1.0 + mu));
  const double azimuth = 2.0 * std::numbers::pi * u.point.y;
  const Vec3 wi{sine * std::cos(azimuth), sine * std::sin(azimuth), std::copysign(mu, wo.z)};
  const double density = limb(mu) * mu / (2.0 * std::numbers::pi * integral_);
  return ScatteringSample{wi, density, false,
                          reflectance_ * static_cast<float>(limb(std::abs(wo.z)))};
}

Albedo BoundMinnaert::albedo(Vec3 wo) const noexcept {
  return {reflectance_ * static_cast<float>(limb(std::abs(wo.z))), Spectrum{reflectance_.count()}};
}

}  // namespace nadir::materials
