#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "materials/scattering/bind_context.hpp"
#include "materials/scattering/models.hpp"
#include "materials/scattering/sample.hpp"

namespace nadir::materials {

struct MixturePart;  // weight, bound scattering, chance of being drawn; in mixture.cpp

/// Weighted sum of the scattering of whole materials, each with its own reflectance:
/// f = sum of weight_i f_i, albedo likewise; a cover of several materials side by side, seen from
/// far enough. Weights need not sum to 1: what is missing is black.
///
/// Each part keeps its laws, so that the sum is reciprocal; it gains no energy because binding
/// refuses weights for which the albedos sum to more than 1 at any lane and angle (1e-3 is granted
/// to the tables of albedo and then taken off all weights). Parts may be mixtures. Only the
/// scattering of a part counts: its relief, solver settings and an emissivity stated beside a
/// reflectance do not; emissivity is 1 - albedo.
///
/// Sampling draws a part by weight times mean albedo. What is drawn from a delta part (mirror,
/// sheet) weighs its share over its chance; all else weighs eval |cos| / pdf of the whole.
class BoundMixture {
 public:
  BoundMixture(const Mixture& model, const BindContext& context);

  [[nodiscard]] spectral::Spectrum eval(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample(Vec3 wo,
                                                       const ScatteringDraw& u) const noexcept;
  [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept;
  [[nodiscard]] ScatteringTraits traits() const noexcept { return traits_; }
  /// What goes straight through the parts that are clear, per lane.
  [[nodiscard]] spectral::Spectrum straight(Vec3 wo) const noexcept;

 private:
  /// The largest albedo. @throws InputError where it creates energy
  [[nodiscard]] double checked_gain(const spectral::Lanes& lanes) const;

  std::shared_ptr<const std::vector<MixturePart>> parts_;  // shared: bound models are copied whole
  int lanes_ = 0;
  ScatteringTraits traits_;
};

}  // namespace nadir::materials
