#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/vec.hpp"
#include "geometry/scene.hpp"
#include "radiometry/lamps/emitting_surface.hpp"
#include "radiometry/lamps/intensity_shape.hpp"
#include "radiometry/lamps/lamp.hpp"
#include "radiometry/lamps/light_tree.hpp"
#include "spectral/lanes.hpp"

namespace nadir::radiometry {

/// A lamp chosen for a point, and a place on it.
struct LampSample {
  Vec3 direction;  ///< unit, from the point to the lamp
  double distance =
      0.0;  ///< m; for an area lamp up to its surface, which shadow rays must not count
  /// What to multiply f |cos| by, already divided by the chance of being drawn: irradiance on a
  /// plane normal to the direction, W m^-2 um^-1 (without occlusion).
  spectral::Spectrum irradiance;
  double pdf = 0.0;  ///< solid-angle density of the draw, sr^-1; 0 for a lamp without size
};

/// The lamps of a scene at the wavelengths of one block of lanes, in a hierarchy from which one is
/// drawn for a point with a chance near its share of the light there. Immutable; no allocation
/// after construction.
///
/// Point lamps: irradiance I(direction) / d^2, d not less than PointLamp::nearest_m. Area lamps:
/// radiance flux / (pi area) on the front of a disc or plane, flux / (pi 4 pi r^2) outside a
/// sphere.
class BoundLamps {
 public:
  BoundLamps() = default;  ///< no lamps
  /// @throws InputError located at the lamp for negative flux, uncovered lanes, degenerate axes
  BoundLamps(const std::vector<Lamp>& lamps, const spectral::Lanes& lanes);

  [[nodiscard]] bool empty() const noexcept { return tree_.empty(); }
  /// Draws a lamp and a place on it for a surface at `position` with unit `normal` turned to the
  /// side that is lit (a zero vector: a point in a volume, or a surface lit on both sides). None
  /// where the draw found no light: that counts as a sample of 0.
  [[nodiscard]] std::optional<LampSample> sample(Vec3 position, Vec3 normal, double choice,
                                                 Vec2 u) const noexcept;
  /// Radiance that an area lamp sends from a hit back along `ray` (0 from its back).
  /// None where the hit's object is no lamp: the usual case, decided by one look-up.
  [[nodiscard]] std::optional<spectral::Spectrum> radiance(const geometry::Ray& ray,
                                                           const geometry::Hit& hit) const noexcept;
  /// Density with which `sample` would have drawn the direction that met this hit, sr^-1.
  [[nodiscard]] double pdf(Vec3 position, Vec3 normal, const geometry::Ray& ray,
                           const geometry::Hit& hit) const noexcept;

  /// Irradiance of one lamp alone on a plane normal to the direction towards it, by the same draw
  /// of a place on it: what `sample` divides by the chance of the lamp. For tests and tables.
  [[nodiscard]] std::optional<LampSample> sample_of(std::uint32_t lamp, Vec3 position,
                                                    Vec2 u) const noexcept;
  /// The chance of `sample` to draw that lamp.
  [[nodiscard]] double chance(std::uint32_t lamp, Vec3 position, Vec3 normal) const noexcept {
    return tree_.probability(lamp, position, normal);
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  struct Point {
    Vec3 position, axis, side, across;
    std::uint32_t shape = 0;
  };
  /// What a lamp is to the sampler, and its spectral flux = factor x spectrum.
  struct Emitter {
    bool is_point = true;
    std::uint32_t index = 0;     // into points_ or surfaces_
    std::uint32_t spectrum = 0;  // into spectra_
    double factor = 0.0;         // for an area lamp divided by pi area: radiance
  };
  class Binder;

  [[nodiscard]] std::optional<LampSample> from_point(const Emitter& emitter,
                                                     Vec3 position) const noexcept;
  [[nodiscard]] std::optional<LampSample> from_surface(const Emitter& emitter, Vec3 position,
                                                       Vec2 u) const noexcept;
  [[nodiscard]] std::uint32_t lamp_at(const geometry::Hit& hit) const noexcept {
    return hit.object < lamp_of_object_.size() ? lamp_of_object_[hit.object] : none;
  }

  std::vector<Emitter> emitters_;  // by lamp
  std::vector<Point> points_;
  std::vector<EmittingSurface> surfaces_;
  std::vector<BoundShape> shapes_;           // lamps of one shape share it
  std::vector<spectral::Spectrum> spectra_;  // lamps of one curve share it
  std::vector<std::uint32_t> lamp_of_object_;
  LightTree tree_;
};

}  // namespace nadir::radiometry
