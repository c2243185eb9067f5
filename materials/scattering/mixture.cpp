#include "materials/scattering/mixture.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "materials/bound_material.hpp"
#include "materials/scattering/cosine_lobe.hpp"

namespace nadir::materials {

using spectral::Lanes;
using spectral::Spectrum;

struct MixturePart {
  double weight;
  BoundScattering scattering;
  double chance = 0.0;
};

namespace {

/// Directions over which a law of all directions is checked: dense toward grazing, where albedos
/// change most.
template <class F>
void for_each_view(const ScatteringTraits& traits, F&& f) {
  constexpr int rows = 32;
  const int columns = traits.anisotropic ? 32 : 1;
  for (int side = 0; side < (traits.transmits ? 2 : 1); ++side) {
    for (int i = 0; i <= rows; ++i) {
      const double root = (i + 0.01) / (rows + 0.01), mu = root * root;
      const double sine = std::sqrt((1.0 - mu) * (1.0 + mu));
      for (int j = 0; j < columns; ++j) {
        const double azimuth = 2.0 * std::numbers::pi * j / columns;
        f(Vec3{sine * std::cos(azimuth), sine * std::sin(azimuth), side == 0 ? mu : -mu});
      }
    }
  }
}

/// Mean over lanes and views of what a part scatters.
double mean_albedo(const BoundScattering& part) {
  double sum = 0.0;
  int count = 0;
  for_each_view(traits(part), [&](Vec3 wo) {
    const Albedo a = albedo(part, wo);
    sum += static_cast<double>((a.reflectance + a.transmittance).mean());
    ++count;
  });
  return sum / count;
}

MixturePart bind_part(const Mixture::Part& part, const BindContext& context) {
  Diagnostics nobody;
  Diagnostics& diagnostics = context.diagnostics != nullptr ? *context.diagnostics : nobody;
  if (part.material->relief != nullptr) {
    diagnostics.warn("mixture: the relief of its part \"" + part.material->name + "\" is left out");
  }
  return {part.weight, bind(*part.material, context.lanes, diagnostics).scattering};
}

void set_chances(std::vector<MixturePart>& parts) {
  double total = 0.0;
  for (MixturePart& part : parts) {
    part.chance = part.weight * mean_albedo(part.scattering);
    total += part.chance;
  }
  for (MixturePart& part : parts) part.chance = total > 0.0 ? part.chance / total : 0.0;
}

}  // namespace

BoundMixture::BoundMixture(const Mixture& model, const BindContext& context)
    : lanes_{context.lanes.count()} {
  std::vector<MixturePart> parts;
  double weights = 0.0;
  bool only_delta = true;
  for (const Mixture::Part& part : model.parts) {
    parts.push_back(bind_part(part, context));
    weights += part.weight;
    const ScatteringTraits t = materials::traits(parts.back().scattering);
    traits_.transmits = traits_.transmits || t.transmits;
    traits_.anisotropic = traits_.anisotropic || t.anisotropic;
    traits_.has_delta = traits_.has_delta || t.has_delta;
    traits_.straight = traits_.straight || t.straight;
    only_delta = only_delta && t.only_delta;
  }
  traits_.only_delta = only_delta;
  set_chances(parts);
  parts_ = std::make_shared<const std::vector<MixturePart>>(parts);
  if (weights <= 1.0) return;  // no part can push the sum above 1
  const double gain = checked_gain(context.lanes);
  if (gain <= 1.0) return;
  for (MixturePart& part : parts) part.weight /= gain;  // else it would grow with every bounce
  parts_ = std::make_shared<const std::vector<MixturePart>>(std::move(parts));
}

double BoundMixture::checked_gain(const Lanes& lanes) const {
  constexpr double granted = 1.0 + 1e-3;  // to the noise of tabulated albedos
  double largest = 0.0;
  Micrometres where{0.0};
  for_each_view(traits_, [&](Vec3 wo) {
    const Albedo a = albedo(wo);
    for (int lane = 0; lane < lanes_; ++lane) {
      const auto sum =
          static_cast<double>(a.reflectance[lane]) + static_cast<double>(a.transmittance[lane]);
      if (sum <= largest) continue;
      largest = sum;
      where = lanes[lane];
    }
  });
  if (largest <= granted) return largest;
  throw InputError{"mixture: its parts together scatter " +
                   number_text(std::round(largest * 1e4) / 1e4) + " of the light at " +
                   number_text(std::round(where.value * 1e6) / 1e6) +
                   " um; more than 1 creates energy"};
}

Spectrum BoundMixture::eval(Vec3 wi, Vec3 wo) const noexcept {
  Spectrum sum{lanes_};
  for (const MixturePart& part : *parts_) {
    sum.add_scaled(materials::eval(part.scattering, wi, wo), static_cast<float>(part.weight));
  }
  return sum;
}

double BoundMixture::pdf(Vec3 wi, Vec3 wo) const noexcept {
  double sum = 0.0;
  for (const MixturePart& part : *parts_) {
    if (part.chance > 0.0) sum += part.chance * materials::pdf(part.scattering, wi, wo);
  }
  return sum;
}

std::optional<ScatteringSample> BoundMixture::sample(Vec3 wo,
                                                     const ScatteringDraw& u) const noexcept {
  double first = 0.0;
  const MixturePart* chosen = nullptr;
  for (const MixturePart& part : *parts_) {
    if (part.chance <= 0.0) continue;
    if (chosen != nullptr) first += chosen->chance;
    chosen = &part;  // the last one also takes what rounding leaves over
    if (u.choice < first + part.chance) break;
  }
  if (chosen == nullptr) return std::nullopt;
  auto drawn =
      materials::sample(chosen->scattering, wo, {reused(u.choice, first, chosen->chance), u.point});
  if (!drawn) return std::nullopt;
  if (drawn->delta) {
    drawn->weight *= static_cast<float>(chosen->weight / chosen->chance);
    return drawn;
  }
  drawn->pdf = pdf(drawn->wi, wo);
  if (drawn->pdf <= 0.0) return std::nullopt;
  drawn->weight = eval(drawn->wi, wo) * static_cast<float>(std::abs(drawn->wi.z) / drawn->pdf);
  return drawn;
}

Albedo BoundMixture::albedo(Vec3 wo) const noexcept {
  Albedo sum{Spectrum{lanes_}, Spectrum{lanes_}};
  for (const MixturePart& part : *parts_) {
    const Albedo a = materials::albedo(part.scattering, wo);
    sum.reflectance.add_scaled(a.reflectance, static_cast<float>(part.weight));
    sum.transmittance.add_scaled(a.transmittance, static_cast<float>(part.weight));
  }
  return sum;
}

Spectrum BoundMixture::straight(Vec3 wo) const noexcept {
  Spectrum sum{lanes_};
  for (const MixturePart& part : *parts_) {
    if (!materials::traits(part.scattering).straight) continue;
    sum.add_scaled(straight_transmittance(part.scattering, wo), static_cast<float>(part.weight));
  }
  return sum;
}

}  // namespace nadir::materials
