#pragma once

#include <vector>

#include "atmosphere/atmosphere.hpp"
#include "core/diagnostics.hpp"
#include "ephemeris/illumination.hpp"
#include "geometry/scene.hpp"
#include "materials/bound_material.hpp"
#include "spectral/lanes.hpp"
#include "thermal/temperature.hpp"

namespace nadir::radiometry {

/// Everything that radiance comes from, before wavelengths are chosen.
struct SceneDescription {
  geometry::Scene geometry;
  std::vector<materials::Material> materials;  ///< by the index that hits carry
  thermal::TemperatureField temperature;
  ephemeris::Illumination illumination;
  atmosphere::Atmosphere atmosphere;
  materials::SolverSettings solver;  ///< for materials without their own
};

/// A body at the wavelengths of a block: its light as it reaches a surface.
struct Target {
  Vec3 direction;           ///< unit, towards the disc's centre, scene axes
  double sin_radius = 0.0;  ///< of the angular radius
  double cos_radius = 1.0;
  spectral::Spectrum irradiance;  ///< at the surface: disc radiance times solid angle, W m^-2 um^-1
};

/// A scene at the wavelengths of one block of lanes: what the solvers look up, immutable.
class LitScene {
 public:
  /// @throws InputError where a spectrum does not serve the lanes
  LitScene(const SceneDescription& scene, spectral::Lanes lanes, Diagnostics& diagnostics);

  [[nodiscard]] const geometry::Scene& geometry() const noexcept { return scene_->geometry; }
  [[nodiscard]] const spectral::Lanes& lanes() const noexcept { return lanes_; }
  [[nodiscard]] const atmosphere::BoundAtmosphere& air() const noexcept { return air_; }
  /// Bodies with any part of their disc above the scene's horizontal plane.
  [[nodiscard]] const std::vector<Target>& targets() const noexcept { return targets_; }
  [[nodiscard]] const materials::BoundMaterial& material(const geometry::Hit& hit) const noexcept {
    return materials_[hit.material];
  }
  [[nodiscard]] const materials::SolverSettings& settings(const geometry::Hit& hit) const noexcept {
    return settings_[hit.material];
  }
  /// Emitted radiance eps(lambda) B(lambda, T) at a hit; 0 where T is 0 K.
  [[nodiscard]] spectral::Spectrum self_emission(const geometry::Hit& hit) const noexcept;

 private:
  const SceneDescription* scene_;
  spectral::Lanes lanes_;
  atmosphere::BoundAtmosphere air_;
  std::vector<Target> targets_;
  std::vector<materials::BoundMaterial> materials_;
  std::vector<materials::SolverSettings> settings_;
  std::vector<spectral::Spectrum> constant_emission_;  // by material: Planck costs several rays
};

/// A direction drawn uniformly over the target's disc (by solid angle), scene axes.
[[nodiscard]] Vec3 direction_in_disc(const Target& target, Vec2 u) noexcept;

}  // namespace nadir::radiometry
