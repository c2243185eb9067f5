#include "materials/scattering/microfacet.hpp"

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::materials {
namespace {

using spectral::Spectrum;

// Media of nearly one index let light through unturned: no density in solid angle describes that.
constexpr double least_contrast = 1e-3;
constexpr double by_fresnel = -1.0;

void check_contrast(double mean_n) {
  if (std::abs(mean_n - 1.0) >= least_contrast) return;
  throw InputError{"microfacet: the mean of n is " + number_text(mean_n) +
                   "; a rough interface that transmits needs one that differs from 1 by 0.001"};
}

/// The facet that refracts light between two directions on either side, wo above.
struct RefractingFacet {
  Vec3 h;
  double cos_i = 0.0, cos_o = 0.0;  ///< to wi (negative) and wo; a facet seen from behind: both 0
  double jacobian = 0.0;            ///< solid angle of h over that of wi
};

RefractingFacet refracting_facet(Vec3 wi, Vec3 wo, double n_i, double n_o) {
  const Vec3 sum = wi * n_i + wo * n_o;
  const double size = length(sum);
  if (size <= 0.0) return {};
  const Vec3 h = sum * ((sum.z < 0.0 ? -1.0 : 1.0) / size);
  const double cos_i = dot(wi, h), cos_o = dot(wo, h);
  if (cos_i >= 0.0 || cos_o <= 0.0) return {};
  // n_i i.h + n_o o.h is the length of the sum itself
  return {h, cos_i, cos_o, n_i * n_i * -cos_i / (size * size)};
}

/// Snell's law at a facet; z above 0 where nothing gets through.
Vec3 refracted_at(Vec3 h, Vec3 wo, double eta) {
  const double cos_o = dot(wo, h);
  const double cos_sq = 1.0 - eta * eta * (1.0 - cos_o) * (1.0 + cos_o);
  if (cos_sq <= 0.0) return {0.0, 0.0, 1.0};
  return normalised(h * (eta * cos_o - std::sqrt(cos_sq)) - wo * eta);
}

}  // namespace

BoundMicrofacet::BoundMicrofacet(const Microfacet& model, const BindContext& context)
    : slopes_{model.slopes, {model.alpha_x, model.alpha_y}, model.azimuth_rad},
      index_{model.n, model.k, context.lanes},
      transmits_{model.transmits},
      mean_n_{model.transmits ? static_cast<double>(index_.n().mean()) : 1.0} {
  if (transmits_) check_contrast(mean_n_);
  const AlbedoTable::Shape shape{.lanes = context.lanes.count(),
                                 .two_sided = transmits_,
                                 .anisotropic = slopes_.anisotropic()};
  // One table for either fate of the light: drawn together, each would get half of the draws, by
  // chance. Both use the same points, so that reflection and transmission add up.
  reflected_ = std::make_shared<const AlbedoTable>(
      shape, [this](Vec3 wo, const ScatteringDraw& u) { return draw(wo, u, 1.0); });
  if (!transmits_) return;
  transmitted_ = std::make_shared<const AlbedoTable>(
      shape, [this](Vec3 wo, const ScatteringDraw& u) { return draw(wo, u, 0.0); });
}

BoundMicrofacet::Pair BoundMicrofacet::pair(Vec3 wi, Vec3 wo) const noexcept {
  const double sign = wo.z < 0.0 ? -1.0 : 1.0;
  const auto index_at = [&](double z) { return z < 0.0 ? mean_n_ : 1.0; };
  return {{wi.x, wi.y, sign * wi.z}, {wo.x, wo.y, sign * wo.z}, index_at(wi.z), index_at(wo.z)};
}

double BoundMicrofacet::radiance_factor(const Pair& p) noexcept {
  return p.n_o * p.n_o / (p.n_i * p.n_i);
}

// Inside of a solid the angle outside that belongs to it is taken, in every lane: so transmission
// is the same both ways.
Spectrum BoundMicrofacet::fresnel(double cosine, double n_o) const noexcept {
  if (!transmits_) return index_.reflectance(cosine);
  const double n_other = n_o == 1.0 ? mean_n_ : 1.0;
  const double sine_sq = (1.0 - cosine) * (1.0 + cosine), eta = n_o / n_other;
  if (eta * eta * sine_sq >= 1.0) return Spectrum{index_.count(), 1.0F};
  return index_.reflectance(n_o == 1.0 ? cosine : std::sqrt(1.0 - eta * eta * sine_sq));
}

double BoundMicrofacet::reflection_pdf(const Pair& p) const noexcept {
  const Facet facet = facet_between(p.wi, p.wo);
  const double chance = transmits_ ? static_cast<double>(fresnel(facet.cosine, p.n_o).mean()) : 1.0;
  return chance * slopes_.visible_density(facet.h, p.wo) / (4.0 * facet.cosine);
}

double BoundMicrofacet::refraction_pdf(const Pair& p) const noexcept {
  const RefractingFacet facet = refracting_facet(p.wi, p.wo, p.n_i, p.n_o);
  if (facet.cos_o <= 0.0) return 0.0;
  const double chance = 1.0 - static_cast<double>(fresnel(facet.cos_o, p.n_o).mean());
  return chance * slopes_.visible_density(facet.h, p.wo) * facet.jacobian;
}

Spectrum BoundMicrofacet::eval(Vec3 wi, Vec3 wo) const noexcept {
  if (!clear_of_horizon(wi) || !clear_of_horizon(wo)) return Spectrum{index_.count()};
  const Pair p = pair(wi, wo);
  if (p.wi.z > 0.0) {
    const Facet facet = facet_between(p.wi, p.wo);
    const double f =
        slopes_.density(facet.h) * slopes_.visible(p.wi, p.wo) / (4.0 * p.wi.z * p.wo.z);
    return fresnel(facet.cosine, p.n_o) * static_cast<float>(f);
  }
  const RefractingFacet facet = refracting_facet(p.wi, p.wo, p.n_i, p.n_o);
  if (!transmits_ || facet.cos_o <= 0.0) return Spectrum{index_.count()};
  const double f = slopes_.density(facet.h) * slopes_.visible(p.wi) * slopes_.visible(p.wo) *
                   facet.cos_o * facet.jacobian / (-p.wi.z * p.wo.z) * radiance_factor(p);
  return (Spectrum{index_.count(), 1.0F} - fresnel(facet.cos_o, p.n_o)) * static_cast<float>(f);
}

double BoundMicrofacet::pdf(Vec3 wi, Vec3 wo) const noexcept {
  if (!clear_of_horizon(wi) || !clear_of_horizon(wo)) return 0.0;
  const Pair p = pair(wi, wo);
  if (p.wi.z > 0.0) return reflection_pdf(p);
  return transmits_ ? refraction_pdf(p) : 0.0;
}

std::optional<ScatteringSample> BoundMicrofacet::draw(Vec3 wo, const ScatteringDraw& u,
                                                      double chance) const noexcept {
  if (!clear_of_horizon(wo)) return std::nullopt;
  Pair p = pair(wo, wo);
  const Vec3 h = slopes_.draw(p.wo, u.point);
  Spectrum share = fresnel(dot(p.wo, h), p.n_o);
  if (chance < 0.0) chance = !transmits_ ? 1.0 : static_cast<double>(share.mean());
  ScatteringSample result;
  const double sign = wo.z < 0.0 ? -1.0 : 1.0;
  if (u.choice < chance) {
    p.wi = mirrored_at(h, p.wo);
    if (p.wi.z <= grazing_cosine) return std::nullopt;  // lost on another facet
    result.pdf = reflection_pdf(p);
    share *= static_cast<float>(slopes_.visible(p.wi, p.wo) / (slopes_.visible(p.wo) * chance));
  } else {
    p.n_i = p.n_o == 1.0 ? mean_n_ : 1.0;
    p.wi = refracted_at(h, p.wo, p.n_o / p.n_i);
    if (p.wi.z >= -grazing_cosine) return std::nullopt;
    result.pdf = refraction_pdf(p);
    share = Spectrum{share.count(), 1.0F} - share;
    share *= static_cast<float>(slopes_.visible(p.wi) / (1.0 - chance));
  }
  if (!(result.pdf > 0.0)) return std::nullopt;
  result.wi = {p.wi.x, p.wi.y, sign * p.wi.z};
  result.weight = share;
  return result;
}

Albedo BoundMicrofacet::albedo(Vec3 wo) const noexcept {
  Albedo result = reflected_->at(wo);
  if (transmits_) result.transmittance = transmitted_->at(wo).transmittance;
  return result;
}

std::optional<ScatteringSample> BoundMicrofacet::sample(Vec3 wo,
                                                        const ScatteringDraw& u) const noexcept {
  std::optional<ScatteringSample> result = draw(wo, u, by_fresnel);
  if (result && result->wi.z * wo.z < 0.0) {
    result->weight *= static_cast<float>(radiance_factor(pair(result->wi, wo)));
  }
  return result;
}

}  // namespace nadir::materials
