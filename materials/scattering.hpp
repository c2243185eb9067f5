#pragma once

#include <variant>

#include "core/vec.hpp"
#include "materials/lambertian.hpp"

namespace nadir::materials {

/// The closed set of scattering models. Adding one: a header, a line here, a line in the reader's
/// table, a line in the law test.
///
/// Directions are unit vectors in the local frame of the surface (z along the normal) and point
/// away from it. A model describes the shape of scattering for a directional-hemispherical
/// reflectance of 1; the material's spectrum scales it.
using Scattering = std::variant<Lambertian>;

// std::visit throws for a variant that lost its value; models are trivially copyable, so that no
// assignment can fail half-way and leave one.
// NOLINTBEGIN(bugprone-exception-escape)

/// Bidirectional reflectance for unit reflectance, without the cosine factor, in sr^-1.
[[nodiscard]] inline double eval(const Scattering& model, Vec3 wi, Vec3 wo) noexcept {
  return std::visit([&](const auto& m) { return m.eval(wi, wo); }, model);
}
/// Solid-angle density of `sample`, in sr^-1.
[[nodiscard]] inline double pdf(const Scattering& model, Vec3 wi, Vec3 wo) noexcept {
  return std::visit([&](const auto& m) { return m.pdf(wi, wo); }, model);
}
/// A direction drawn for the view direction wo, with its density and weight.
[[nodiscard]] inline std::optional<ScatteringSample> sample(const Scattering& model, Vec3 wo,
                                                            Vec2 u) noexcept {
  return std::visit([&](const auto& m) { return m.sample(wo, u); }, model);
}

// NOLINTEND(bugprone-exception-escape)

}  // namespace nadir::materials
