#include "materials/scattering/priest_germer.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "materials/scattering/cosine_lobe.hpp"
#include "materials/scattering/facet_slopes.hpp"

namespace nadir::materials {
namespace {

using spectral::Spectrum;

/// Share of a facet of a V-shaped groove that is seen from w.
double groove(Vec3 h, Vec3 w) { return std::min(1.0, 2.0 * h.z * w.z / dot(w, h)); }

}  // namespace

BoundPriestGermer::BoundPriestGermer(const PriestGermer& model, const BindContext& context)
    : index_{model.n, model.k, context.lanes}, sigma_{model.slope_sigma} {
  const AlbedoTable::Shape shape{
      .lanes = context.lanes.count(), .two_sided = false, .anisotropic = false};
  auto coat = std::make_shared<const AlbedoTable>(
      shape, [this](Vec3 wo, const ScatteringDraw& u) { return sample_facets(wo, u); });
  base_ = CoatedBase{std::move(coat), context.reflectance};
}

double BoundPriestGermer::density(Vec3 h) const noexcept {
  const double z_sq = h.z * h.z, two_variances = 2.0 * sigma_ * sigma_;
  return std::exp(-(h.x * h.x + h.y * h.y) / (z_sq * two_variances)) /
         (std::numbers::pi * two_variances * z_sq * z_sq);
}

Spectrum BoundPriestGermer::facets(Vec3 wi, Vec3 wo) const noexcept {
  const Facet facet = facet_between(wi, wo);
  const double seen = std::min(groove(facet.h, wi), groove(facet.h, wo));
  const double f = density(facet.h) * seen / (4.0 * wi.z * wo.z);
  return index_.reflectance(facet.cosine) * static_cast<float>(f);
}

double BoundPriestGermer::facets_pdf(Vec3 wi, Vec3 wo) const noexcept {
  const Facet facet = facet_between(wi, wo);
  return density(facet.h) * groove(facet.h, wo) / (4.0 * wo.z);
}

Vec3 BoundPriestGermer::draw_facet(Vec3 wo, const ScatteringDraw& u) const noexcept {
  const double slope = sigma_ * std::sqrt(-2.0 * std::log1p(-u.point.x));
  const double azimuth = 2.0 * std::numbers::pi * u.point.y;
  const Vec3 h = normalised({slope * std::cos(azimuth), slope * std::sin(azimuth), 1.0});
  const Vec3 opposite{-h.x, -h.y, h.z};  // the other wall of its groove
  const double area = std::max(0.0, dot(wo, h)), other = std::max(0.0, dot(wo, opposite));
  return u.choice * (area + other) < area ? h : opposite;
}

std::optional<ScatteringSample> BoundPriestGermer::sample_facets(
    Vec3 wo, const ScatteringDraw& u) const noexcept {
  const Vec3 wi = mirrored_at(draw_facet(wo, u), wo);
  if (wi.z <= grazing_cosine) return std::nullopt;  // lost on the other wall
  const Facet facet = facet_between(wi, wo);
  const double seen = std::min(1.0, groove(facet.h, wi) / groove(facet.h, wo));
  ScatteringSample result;
  result.wi = wi;
  result.pdf = facets_pdf(wi, wo);
  result.weight = index_.reflectance(facet.cosine) * static_cast<float>(seen);
  return result.pdf > 0.0 ? std::optional{result} : std::nullopt;
}

Spectrum BoundPriestGermer::eval(Vec3 wi, Vec3 wo) const noexcept {
  if (!both_seen(wi, wo)) return Spectrum{index_.count()};
  const Vec3 i = upward(wi), o = upward(wo);
  return facets(i, o) + base_.eval(i, base_.through(o));
}

double BoundPriestGermer::pdf(Vec3 wi, Vec3 wo) const noexcept {
  if (!both_seen(wi, wo)) return 0.0;
  const Vec3 o = upward(wo);
  const double coat = base_.coat_share(base_.through(o));
  return coat * facets_pdf(upward(wi), o) + (1.0 - coat) * cosine_pdf(wi);
}

std::optional<ScatteringSample> BoundPriestGermer::sample(Vec3 wo,
                                                          const ScatteringDraw& u) const noexcept {
  if (!clear_of_horizon(wo)) return std::nullopt;
  const Vec3 o = upward(wo);
  const Spectrum through = base_.through(o);
  const double coat = base_.coat_share(through);
  const Vec3 i = u.choice < coat
                     ? mirrored_at(draw_facet(o, {reused(u.choice, 0.0, coat), u.point}), o)
                     : draw_cosine(u.point, 1.0);
  if (i.z <= grazing_cosine) return std::nullopt;  // lost on the other wall of a groove
  ScatteringSample result;
  result.pdf = coat * facets_pdf(i, o) + (1.0 - coat) * cosine_pdf(i);
  if (!(result.pdf > 0.0)) return std::nullopt;
  result.weight = (facets(i, o) + base_.eval(i, through)) * static_cast<float>(i.z / result.pdf);
  result.wi = {i.x, i.y, std::copysign(i.z, wo.z)};
  return result;
}

Albedo BoundPriestGermer::albedo(Vec3 wo) const noexcept {
  return {base_.albedo(base_.through(upward(wo))), Spectrum{index_.count()}};
}

}  // namespace nadir::materials
