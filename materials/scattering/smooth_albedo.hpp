#pragma once

#include <functional>
#include <string>
#include <vector>

#include "materials/scattering/sample.hpp"
#include "spectral/lanes.hpp"

namespace nadir::materials {

/// Directional-hemispherical reflectance of a smooth, isotropic, opaque model: integrated when it
/// is bound, interpolated linearly in sqrt(mu). For lobes narrower than about ten degrees use
/// AlbedoTable, which samples.
///
/// Accuracy: 1e-3 of the value for the Ross-Li, Rahman-Pinty-Verstraete and Hapke models (tests of
/// each against a finer rule).
class SmoothAlbedo {
 public:
  using Function = std::function<spectral::Spectrum(Vec3 wi, Vec3 wo)>;
  /// @param panels  of the rule in sqrt(mu), two points each; as many points in half a turn
  SmoothAlbedo(int lanes, const Function& f, int panels = 12);

  /// @param mu  cosine of the view's zenith angle, taken without its sign
  [[nodiscard]] Albedo at(double mu) const noexcept;

  /// @throws InputError if any entry is above `limit`, naming lane, angle and albedo
  void refuse_above(double limit, const spectral::Lanes& lanes, const std::string& what) const;
  /// Largest entry of each lane.
  [[nodiscard]] spectral::Spectrum largest() const noexcept;
  /// Multiplies every entry, lane by lane.
  void scale(const spectral::Spectrum& factor) noexcept;

 private:
  std::vector<spectral::Spectrum> entries_;  // at mu = (i / (count - 1))^2
};

}  // namespace nadir::materials
