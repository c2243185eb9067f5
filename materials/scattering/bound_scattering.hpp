#pragma once

#include <optional>
#include <variant>

#include "materials/scattering/bind_context.hpp"
#include "materials/scattering/clear_sheet.hpp"
#include "materials/scattering/cox_munk.hpp"
#include "materials/scattering/hapke.hpp"
#include "materials/scattering/lambertian.hpp"
#include "materials/scattering/leaf.hpp"
#include "materials/scattering/measured.hpp"
#include "materials/scattering/microfacet.hpp"
#include "materials/scattering/minnaert.hpp"
#include "materials/scattering/mirror.hpp"
#include "materials/scattering/mixture.hpp"
#include "materials/scattering/models.hpp"
#include "materials/scattering/oren_nayar.hpp"
#include "materials/scattering/priest_germer.hpp"
#include "materials/scattering/rahman_pinty_verstraete.hpp"
#include "materials/scattering/ross_li.hpp"
#include "materials/scattering/sample.hpp"
#include "materials/scattering/ward.hpp"

namespace nadir::materials {

/// A scattering model at the wavelengths of one block of lanes.
///
/// Directions are unit vectors in the local frame of the surface and point away from it: z along
/// its outward normal, so that wo.z < 0 for a surface seen from behind. Opaque models treat both
/// sides alike: light counts if wi and wo lie on the same side. Anisotropic models count azimuths
/// from the frame's x axis.
using BoundScattering =
    std::variant<BoundLambertian, BoundOrenNayar, BoundMinnaert, BoundLeaf, BoundMirror,
                 BoundClearSheet, BoundWard, BoundMicrofacet, BoundPriestGermer, BoundCoxMunk,
                 BoundRossLi, BoundRahmanPintyVerstraete, BoundHapke, BoundMeasured, BoundMixture>;

/// Takes a model to the lanes. Call it as materials::bind: a variant also brings std::bind into
/// reach.
/// @throws InputError without location for parameters out of their domain, curves that do not cover
///         the lanes, and models that would gain energy
[[nodiscard]] BoundScattering bind(const Scattering& model, const BindContext& context);

// std::visit throws for a variant that lost its value, which none here can.
// NOLINTBEGIN(bugprone-exception-escape)

/// Bidirectional reflectance or transmittance f per lane, without the cosine factor, in sr^-1.
/// Deltas are left out.
[[nodiscard]] inline spectral::Spectrum eval(const BoundScattering& model, Vec3 wi,
                                             Vec3 wo) noexcept {
  return std::visit([&](const auto& m) { return m.eval(wi, wo); }, model);
}
/// Solid-angle density of what `sample` draws outside of deltas, in sr^-1.
[[nodiscard]] inline double pdf(const BoundScattering& model, Vec3 wi, Vec3 wo) noexcept {
  return std::visit([&](const auto& m) { return m.pdf(wi, wo); }, model);
}
/// A direction for the view direction wo, drawn from the lane-averaged function, with its weight
/// per lane. None where the model scatters nothing that way.
[[nodiscard]] inline std::optional<ScatteringSample> sample(const BoundScattering& model, Vec3 wo,
                                                            const ScatteringDraw& u) noexcept {
  return std::visit([&](const auto& m) { return m.sample(wo, u); }, model);
}
/// Directional-hemispherical reflectance and transmittance per lane, deltas included.
[[nodiscard]] inline Albedo albedo(const BoundScattering& model, Vec3 wo) noexcept {
  return std::visit([&](const auto& m) { return m.albedo(wo); }, model);
}
[[nodiscard]] inline ScatteringTraits traits(const BoundScattering& model) noexcept {
  return std::visit([](const auto& m) { return m.traits(); }, model);
}

// NOLINTEND(bugprone-exception-escape)

/// Share of light that goes straight through without being turned, per lane: what shadow rays lose
/// no more of. 0 for models whose traits do not say `straight`.
[[nodiscard]] spectral::Spectrum straight_transmittance(const BoundScattering& model,
                                                        Vec3 wo) noexcept;

}  // namespace nadir::materials
