#pragma once

#include <optional>

#include "core/vec.hpp"
#include "materials/scattering_sample.hpp"

namespace nadir::materials {

/// Perfectly diffuse: f = 1 / pi for unit reflectance. Reciprocal, conserves energy exactly.
/// Source: J. H. Lambert, Photometria (1760).
struct Lambertian {
  [[nodiscard]] double eval(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample(Vec3 wo, Vec2 u) const noexcept;
};

}  // namespace nadir::materials
