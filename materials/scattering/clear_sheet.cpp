#include "materials/scattering/clear_sheet.hpp"

#include <algorithm>
#include <cmath>

namespace nadir::materials {
namespace {

using spectral::Spectrum;

/// Shares of light of one polarisation that a plate reflects and lets through.
struct Shares {
  double reflected, transmitted;
};

/// @param r  reflectance of one face
/// @param a  transmittance of one crossing
Shares plate(double r, double a) {
  const double through = 1.0 - r, inner = r * a;
  // 1 - r^2 a^2 vanishes only where nothing gets in: r = 1
  const double t = through > 0.0 ? through * through * a / ((1.0 - inner) * (1.0 + inner)) : 0.0;
  return {r * (1.0 + a * t), t};
}

Shares plate_at(double mu, double n, double depth) {
  const double n_cos_sq = (n - 1.0) * (n + 1.0) + mu * mu;  // (n cos(theta_t))^2
  if (n_cos_sq <= 0.0) return n == 1.0 ? Shares{0.0, depth > 0.0 ? 0.0 : 1.0} : Shares{1.0, 0.0};
  const double n_cos = std::sqrt(n_cos_sq);
  const double s = (mu - n_cos) / (mu + n_cos);
  const double p = (n * n * mu - n_cos) / (n * n * mu + n_cos);
  const double a = depth > 0.0 ? std::exp(-depth * n / n_cos) : 1.0;
  const Shares across = plate(s * s, a), along = plate(p * p, a);
  return {0.5 * (across.reflected + along.reflected),
          0.5 * (across.transmitted + along.transmitted)};
}

}  // namespace

BoundClearSheet::BoundClearSheet(const ClearSheet& model, const BindContext& context)
    : reflectance_{context.reflectance},
      transmittance_{context.transmittance},
      n_{context.lanes.count(), 1.0F},
      depth_{context.lanes.count()},
      plate_{model.n.has_value()} {
  if (model.n) n_ = model.n->at(context.lanes);
  if (model.absorption) depth_ = model.absorption->at(context.lanes);
}

Spectrum BoundClearSheet::eval(Vec3 /*wi*/, Vec3 /*wo*/) const noexcept {
  return Spectrum{n_.count()};
}

double BoundClearSheet::pdf(Vec3 /*wi*/, Vec3 /*wo*/) const noexcept { return 0.0; }

std::optional<ScatteringSample> BoundClearSheet::sample(Vec3 wo,
                                                        const ScatteringDraw& u) const noexcept {
  if (wo.z == 0.0) return std::nullopt;
  const Albedo shares = albedo(wo);
  const auto r = static_cast<double>(shares.reflectance.mean());
  const auto t = static_cast<double>(shares.transmittance.mean());
  if (r + t <= 0.0) return std::nullopt;
  const double reflect_chance = r / (r + t);
  if (u.choice < reflect_chance) {
    return ScatteringSample{{-wo.x, -wo.y, wo.z},
                            0.0,
                            true,
                            shares.reflectance * static_cast<float>(1.0 / reflect_chance)};
  }
  return ScatteringSample{-wo, 0.0, true,
                          shares.transmittance * static_cast<float>(1.0 / (1.0 - reflect_chance))};
}

Albedo BoundClearSheet::albedo(Vec3 wo) const noexcept {
  if (!plate_) return {reflectance_, transmittance_};
  Albedo result{Spectrum{n_.count()}, Spectrum{n_.count()}};
  const double mu = std::min(std::abs(wo.z), 1.0);
  for (int lane = 0; lane < n_.count(); ++lane) {
    const Shares shares =
        plate_at(mu, static_cast<double>(n_[lane]), static_cast<double>(depth_[lane]));
    result.reflectance[lane] = static_cast<float>(shares.reflected);
    result.transmittance[lane] = static_cast<float>(shares.transmitted);
  }
  return result;
}

}  // namespace nadir::materials
