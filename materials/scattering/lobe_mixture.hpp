#pragma once

#include <cmath>
#include <optional>

#include "materials/scattering/sample.hpp"

namespace nadir::materials {

/// Shares of the ways in which a direction is drawn. What is left of 1 is cosine-weighted.
struct LobeShares {
  double uniform = 0.0;   ///< uniform in solid angle: bounds the weights of light at grazing angles
  double backward = 0.0;  ///< a Henyey-Greenstein lobe about the view direction
  double forward = 0.0;   ///< the same about the direction straight through, folded up
  double b = 0.0;         ///< asymmetry of both lobes, [0, 1)
};

/// Draws directions of the upper hemisphere: cosine, uniform and Henyey-Greenstein lobes. What a
/// lobe sends below the horizon is mirrored up, so that the density integrates to 1 exactly.
class LobeMixture {
 public:
  explicit LobeMixture(const LobeShares& shares) noexcept;

  /// Solid-angle density, sr^-1; wi.z > 0, wo.z > 0.
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  /// A direction for wo.z > 0; its z may round to 0.
  [[nodiscard]] Vec3 draw(Vec3 wo, const ScatteringDraw& u) const noexcept;

 private:
  /// Density of the lobe at this cosine from its axis, over the whole sphere.
  [[nodiscard]] double lobe(double cosine) const noexcept;
  [[nodiscard]] Vec3 draw_lobe(Vec3 axis, Vec2 point) const noexcept;

  LobeShares shares_;
};

/// What `pdf` and `sample` of a model that looks alike from both sides are made of.
template <class Model>
[[nodiscard]] std::optional<ScatteringSample> draw_by(const LobeMixture& mixture,
                                                      const Model& model, Vec3 wo,
                                                      const ScatteringDraw& u) noexcept {
  const Vec3 upper{wo.x, wo.y, std::abs(wo.z)};
  if (!(upper.z > 0.0)) return std::nullopt;
  Vec3 wi = mixture.draw(upper, u);
  if (!(wi.z > 0.0)) return std::nullopt;
  ScatteringSample s;
  s.pdf = mixture.pdf(wi, upper);
  const auto cos_over_pdf = static_cast<float>(wi.z / s.pdf);
  wi.z = std::copysign(wi.z, wo.z);
  s.wi = wi;
  s.weight = model.eval(wi, wo) * cos_over_pdf;
  return s;
}

[[nodiscard]] inline double pdf_by(const LobeMixture& mixture, Vec3 wi, Vec3 wo) noexcept {
  if (!(wi.z * wo.z > 0.0)) return 0.0;
  return mixture.pdf({wi.x, wi.y, std::abs(wi.z)}, {wo.x, wo.y, std::abs(wo.z)});
}

}  // namespace nadir::materials
