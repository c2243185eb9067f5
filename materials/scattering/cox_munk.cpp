#include "materials/scattering/cox_munk.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "materials/scattering/cosine_lobe.hpp"

namespace nadir::materials {
namespace {

using spectral::Spectrum;

constexpr double least_variance = 1e-4;

FacetSlopes slopes_of(const CoxMunk& model) {
  const double wind = model.wind_speed_m_s;
  const double along = std::max(0.00316 * wind, least_variance), across = 0.003 + 0.00192 * wind;
  // from clockwise from north (y) to anticlockwise from east (x)
  const double azimuth = 0.5 * std::numbers::pi - model.wind_azimuth_rad;
  return {SlopeDistribution::beckmann, {std::sqrt(2.0 * along), std::sqrt(2.0 * across)}, azimuth};
}

double foam_cover(const CoxMunk& model) {
  return model.foam ? 2.95e-6 * std::pow(model.wind_speed_m_s, 3.52) : 0.0;
}

spectral::Curve foam_reflectance() {
  return {{0.5, 0.85, 1.02, 1.65, 2.0}, {0.22, 0.132, 0.11, 0.033, 0.0}, spectral::Outside::hold};
}

}  // namespace

BoundCoxMunk::BoundCoxMunk(const CoxMunk& model, const BindContext& context)
    : slopes_{slopes_of(model)},
      index_{model.n, model.k, context.lanes},
      foam_cover_{foam_cover(model)},
      foam_{foam_reflectance().at(context.lanes) * static_cast<float>(foam_cover_)} {
  const Spectrum body = model.water_body.at(context.lanes);
  const AlbedoTable::Shape shape{
      .lanes = context.lanes.count(), .two_sided = false, .anisotropic = slopes_.anisotropic()};
  auto surface = std::make_shared<const AlbedoTable>(
      shape, [this](Vec3 wo, const ScatteringDraw& u) { return sample_glitter(wo, u.point); });
  water_ = CoatedBase{std::move(surface), body};
}

Spectrum BoundCoxMunk::glitter(Vec3 wi, Vec3 wo) const noexcept {
  const Facet facet = facet_between(wi, wo);
  const double f = slopes_.density(facet.h) * slopes_.visible(wi, wo) / (4.0 * wi.z * wo.z);
  return index_.reflectance(facet.cosine) * static_cast<float>(f);
}

double BoundCoxMunk::glitter_pdf(Vec3 wi, Vec3 wo) const noexcept {
  const Facet facet = facet_between(wi, wo);
  return slopes_.visible_density(facet.h, wo) / (4.0 * facet.cosine);
}

std::optional<ScatteringSample> BoundCoxMunk::sample_glitter(Vec3 wo, Vec2 u) const noexcept {
  const Vec3 h = slopes_.draw(wo, u), wi = mirrored_at(h, wo);
  if (wi.z <= grazing_cosine) return std::nullopt;  // down to another facet
  ScatteringSample result;
  result.wi = wi;
  result.pdf = glitter_pdf(wi, wo);
  result.weight = index_.reflectance(dot(wo, h)) *
                  static_cast<float>(slopes_.visible(wi, wo) / slopes_.visible(wo));
  return result.pdf > 0.0 ? std::optional{result} : std::nullopt;
}

Spectrum BoundCoxMunk::all(Vec3 wi, Vec3 wo, const Spectrum& through_o) const noexcept {
  Spectrum f = glitter(wi, wo) + water_.eval(wi, through_o);
  f *= static_cast<float>(1.0 - foam_cover_);
  return f.add_scaled(foam_, std::numbers::inv_pi_v<float>);
}

double BoundCoxMunk::glitter_chance(const Spectrum& through_o) const noexcept {
  const double surface = (1.0 - foam_cover_) * static_cast<double>(water_.albedo(through_o).mean());
  const double foam = static_cast<double>(foam_.mean());
  const double sum = surface + foam;
  return sum > 0.0 ? water_.coat_share(through_o) * surface / sum : 1.0;
}

Spectrum BoundCoxMunk::eval(Vec3 wi, Vec3 wo) const noexcept {
  if (!both_seen(wi, wo)) return Spectrum{index_.count()};
  const Vec3 o = upward(wo);
  return all(upward(wi), o, water_.through(o));
}

double BoundCoxMunk::pdf(Vec3 wi, Vec3 wo) const noexcept {
  if (!both_seen(wi, wo)) return 0.0;
  const Vec3 o = upward(wo);
  const double chance = glitter_chance(water_.through(o));
  return chance * glitter_pdf(upward(wi), o) + (1.0 - chance) * cosine_pdf(wi);
}

std::optional<ScatteringSample> BoundCoxMunk::sample(Vec3 wo,
                                                     const ScatteringDraw& u) const noexcept {
  if (!clear_of_horizon(wo)) return std::nullopt;
  const Vec3 o = upward(wo);
  const Spectrum through = water_.through(o);
  const double chance = glitter_chance(through);
  const Vec3 i =
      u.choice < chance ? mirrored_at(slopes_.draw(o, u.point), o) : draw_cosine(u.point, 1.0);
  if (i.z <= grazing_cosine) return std::nullopt;  // down to another facet
  ScatteringSample result;
  result.pdf = chance * glitter_pdf(i, o) + (1.0 - chance) * cosine_pdf(i);
  if (!(result.pdf > 0.0)) return std::nullopt;
  result.weight = all(i, o, through) * static_cast<float>(i.z / result.pdf);
  result.wi = {i.x, i.y, std::copysign(i.z, wo.z)};
  return result;
}

Albedo BoundCoxMunk::albedo(Vec3 wo) const noexcept {
  return {water_.albedo(water_.through(upward(wo))) * static_cast<float>(1.0 - foam_cover_) + foam_,
          Spectrum{index_.count()}};
}

}  // namespace nadir::materials
