#include "materials/scattering/ward.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"
#include "materials/scattering/cosine_lobe.hpp"

namespace nadir::materials {

using spectral::Spectrum;

BoundWard::BoundWard(const Ward& model, const BindContext& context)
    : diffuse_{context.reflectance},
      specular_{model.specular.at(context.lanes)},
      alpha_x_{model.alpha_x},
      alpha_y_{model.alpha_y},
      cos_azimuth_{std::cos(model.azimuth_rad)},
      sin_azimuth_{std::sin(model.azimuth_rad)} {
  for (int lane = 0; lane < diffuse_.count(); ++lane) {
    const auto sum = static_cast<double>(diffuse_[lane]) + static_cast<double>(specular_[lane]);
    if (sum <= 1.0 + 1e-6) continue;  // the rounding of lanes
    throw InputError{"ward: reflectance + specular is " + number_text(sum) + " at " +
                     number_text(context.lanes[lane].value) + " um; it must be at most 1"};
  }
  const auto base = static_cast<double>(diffuse_.mean());
  const auto gloss = static_cast<double>(specular_.mean());
  if (gloss > 0.0) lobe_chance_ = gloss / (base + gloss);

  // Weights of the lobe alone, per unit of rho_s: f cos / density.
  const auto unit_lobe = [this](Vec3 wo, const ScatteringDraw& u) {
    const Vec3 wi = draw_lobe(wo, u.point);
    std::optional<ScatteringSample> result;
    if (!on_one_side(wi, wo)) return result;
    const double density = lobe_pdf(wi, wo);
    const double weight = lobe(wi, wo) * std::abs(wi.z) / density;
    if (density > 0.0) result = {wi, density, false, Spectrum{1, static_cast<float>(weight)}};
    return result;
  };
  lobe_albedo_ = std::make_shared<const AlbedoTable>(
      AlbedoTable::Shape{.lanes = 1, .anisotropic = traits().anisotropic}, unit_lobe);
}

namespace {

/// Half vector, unnormalised, in the frame of the lobe's axes and with z upward.
struct HalfVector {
  double x, y, z;

  HalfVector(Vec3 sum, double cos_azimuth, double sin_azimuth)
      : x{sum.x * cos_azimuth + sum.y * sin_azimuth},
        y{sum.y * cos_azimuth - sum.x * sin_azimuth},
        z{std::abs(sum.z)} {}
  [[nodiscard]] double square() const { return x * x + y * y + z * z; }
};

/// exp(-(slope over alpha)^2) / (pi alpha_x alpha_y)
double slope_density(const HalfVector& h, double alpha_x, double alpha_y) {
  const double sx = h.x / (h.z * alpha_x), sy = h.y / (h.z * alpha_y);
  return std::exp(-(sx * sx + sy * sy)) * std::numbers::inv_pi / (alpha_x * alpha_y);
}

}  // namespace

double BoundWard::lobe(Vec3 wi, Vec3 wo) const noexcept {
  const HalfVector h{wi + wo, cos_azimuth_, sin_azimuth_};
  const double z2 = h.z * h.z;
  const double ratio = h.square() / z2;
  // where slopes are so steep that the exponential is 0 the ratio may be infinite: 0, not NaN
  const double density = slope_density(h, alpha_x_, alpha_y_);
  return density > 0.0 ? density * ratio / z2 : 0.0;
}

// Density of the half vectors, exp(...) / (pi alpha_x alpha_y cos^3), over 4 (wo . h).
double BoundWard::lobe_pdf(Vec3 wi, Vec3 wo) const noexcept {
  const HalfVector h{wi + wo, cos_azimuth_, sin_azimuth_};
  const double density = slope_density(h, alpha_x_, alpha_y_);
  if (density <= 0.0) return 0.0;
  // with |H| = 2 (wo . h): cos^3 (wo . h) = H_z^3 / (2 |H|^2)
  return density * h.square() / (2.0 * h.z * h.z * h.z);
}

Vec3 BoundWard::draw_lobe(Vec3 wo, Vec2 u) const noexcept {
  const double radius = std::sqrt(-std::log1p(-u.x)), azimuth = 2.0 * std::numbers::pi * u.y;
  // a Gaussian slope along each axis
  const double sx = alpha_x_ * radius * std::cos(azimuth);
  const double sy = alpha_y_ * radius * std::sin(azimuth);
  const double length = std::sqrt(1.0 + sx * sx + sy * sy);
  const Vec3 half{(sx * cos_azimuth_ - sy * sin_azimuth_) / length,
                  (sx * sin_azimuth_ + sy * cos_azimuth_) / length,
                  std::copysign(1.0 / length, wo.z)};
  return half * (2.0 * dot(half, wo)) - wo;
}

Spectrum BoundWard::eval(Vec3 wi, Vec3 wo) const noexcept {
  if (!on_one_side(wi, wo)) return Spectrum{diffuse_.count()};
  Spectrum f = diffuse_ * std::numbers::inv_pi_v<float>;
  return f.add_scaled(specular_, static_cast<float>(lobe(wi, wo)));
}

double BoundWard::pdf(Vec3 wi, Vec3 wo) const noexcept {
  if (!on_one_side(wi, wo)) return 0.0;
  return (1.0 - lobe_chance_) * cosine_pdf(wi) + lobe_chance_ * lobe_pdf(wi, wo);
}

std::optional<ScatteringSample> BoundWard::sample(Vec3 wo, const ScatteringDraw& u) const noexcept {
  if (wo.z == 0.0) return std::nullopt;
  const bool glossy = u.choice < lobe_chance_;
  const Vec3 wi = glossy ? draw_lobe(wo, u.point) : draw_cosine(u.point, wo.z);
  if (!on_one_side(wi, wo)) return std::nullopt;  // the facet sends it below the horizon
  const double density = pdf(wi, wo);
  if (density <= 0.0) return std::nullopt;
  const double scale = std::abs(wi.z) / density;
  Spectrum weight = diffuse_ * static_cast<float>(scale * std::numbers::inv_pi);
  weight.add_scaled(specular_, static_cast<float>(scale * lobe(wi, wo)));
  return ScatteringSample{wi, density, false, weight};
}

Albedo BoundWard::albedo(Vec3 wo) const noexcept {
  Spectrum r = diffuse_;
  r.add_scaled(specular_, static_cast<float>(lobe_albedo_->reflectance_at(wo)));
  return {r, Spectrum{r.count()}};
}

}  // namespace nadir::materials
