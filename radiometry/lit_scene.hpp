#pragma once

#include <optional>
#include <vector>

#include "atmosphere/atmosphere.hpp"
#include "core/diagnostics.hpp"
#include "core/sampler.hpp"
#include "ephemeris/illumination.hpp"
#include "geometry/scene.hpp"
#include "materials/bound_material.hpp"
#include "materials/maps/material_map.hpp"
#include "radiometry/effect.hpp"
#include "radiometry/generic_plan.hpp"
#include "radiometry/lamps/bound_lamps.hpp"
#include "radiometry/method.hpp"
#include "radiometry/planck_table.hpp"
#include "radiometry/sky_distribution.hpp"
#include "radiometry/volumes/bound_volumes.hpp"
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
  materials::SolverSettings solver;  ///< of the generic solver, for materials without their own
  std::vector<materials::MaterialMap> maps{};  ///< hits carry materials.size() + index of the map
  std::vector<Volume> volumes{};
  std::vector<Lamp> lamps{};
  Method method = Method::generic;
  int path_max_bounces = 0;  ///< of the path solver; 0: no limit, and no bias
};

/// The material at a hit whose surface carries a map is drawn from the map: afterwards
/// hit.material is an index of `scene.materials`.
void resolve_map(const SceneDescription& scene, geometry::Hit& hit, const Sampler& numbers);

/// A body at the wavelengths of a block: its light as it reaches a surface.
struct Target {
  Vec3 direction;           ///< unit, towards the disc's centre, scene axes
  double sin_radius = 0.0;  ///< of the angular radius
  double cos_radius = 1.0;
  double solid_angle = 0.0;       ///< of the whole disc, sr
  spectral::Spectrum irradiance;  ///< at the surface: disc radiance times solid angle, W m^-2 um^-1
  spectral::Spectrum radiance;    ///< of the disc as surfaces see it, through the air, W m^-2 sr^-1
                                  ///< um^-1
  spectral::Spectrum outside;     ///< of the disc outside the air
  /// Which of the scene's bodies above the horizon, whatever effects leave out: by it a body's
  /// random numbers are its own, and images with and without another differ by that one alone.
  std::uint32_t number = 0;

  /// Whether a unit direction meets the part of the disc that is above the horizon.
  [[nodiscard]] bool covers(Vec3 towards) const noexcept {
    return dot(towards, direction) >= cos_radius && towards.z > 0.0;
  }
};

/// A scene at the wavelengths of one block of lanes: what the solvers look up, immutable.
class LitScene {
 public:
  /// @param effects  what is simulated: the rest is neither bound nor sampled
  /// @throws InputError where a spectrum that is bound does not serve the lanes
  LitScene(const SceneDescription& scene, spectral::Lanes lanes, Diagnostics& diagnostics,
           EffectSet effects = EffectSet::all());

  [[nodiscard]] const SceneDescription& description() const noexcept { return *scene_; }
  [[nodiscard]] const geometry::Scene& geometry() const noexcept { return scene_->geometry; }
  [[nodiscard]] const spectral::Lanes& lanes() const noexcept { return lanes_; }
  [[nodiscard]] EffectSet effects() const noexcept { return effects_; }
  [[nodiscard]] const atmosphere::BoundAtmosphere& air() const noexcept { return air_; }
  [[nodiscard]] const BoundVolumes& volumes() const noexcept { return volumes_; }
  [[nodiscard]] const BoundLamps& lamps() const noexcept { return lamps_; }
  [[nodiscard]] const SkyDistribution& sky_distribution() const noexcept { return sky_; }
  /// Bodies with any part of their disc above the scene's horizontal plane.
  [[nodiscard]] const std::vector<Target>& targets() const noexcept { return targets_; }
  [[nodiscard]] const materials::BoundMaterial& material(std::uint32_t index) const noexcept {
    return materials_[index];
  }
  /// Whether lights cast shadows; without, no ray is sent to them.
  [[nodiscard]] bool shadows() const noexcept { return shadows_; }
  /// Whether light is reflected from surface to surface.
  [[nodiscard]] bool interreflects() const noexcept { return interreflects_; }
  /// Whether surfaces emit by their temperature.
  [[nodiscard]] bool emits() const noexcept { return emits_; }
  /// Planck's radiance at the temperature of the surface that was hit.
  [[nodiscard]] spectral::Spectrum black_body(const geometry::Hit& hit) const;
  /// What a surface emits in all directions alike; null where it depends on the direction. Asked
  /// of scenes whose surfaces emit.
  /// @param scratch  may be used for the result
  [[nodiscard]] const spectral::Spectrum* even_emission(const geometry::Hit& hit,
                                                        spectral::Spectrum& scratch) const;
  /// Emissivity towards a direction of the surface's own frame: that of the true material, whatever
  /// effects leave out of its scattering.
  [[nodiscard]] spectral::Spectrum emissivity(std::uint32_t material, Vec3 wo) const noexcept {
    return (whole_.empty() ? materials_ : whole_)[material].emissivity(wo);
  }
  /// Whether some surface emits what its place decides, and it matters at these lanes.
  [[nodiscard]] bool emission_varies() const noexcept { return planck_.has_value(); }
  /// Bumps of a material's surface, or null.
  [[nodiscard]] const materials::ReliefMap* relief(std::uint32_t material) const noexcept {
    return scene_->materials[material].relief.get();
  }
  /// What the generic solver needs to know of a material.
  [[nodiscard]] const GenericPlan& plan(std::uint32_t material) const noexcept {
    return plans_[material];
  }
  /// Some material lets light straight through: shadow rays must ask what they meet.
  [[nodiscard]] bool has_sheets() const noexcept { return has_sheets_; }

  /// The first surface along a ray from another surface or from a place in a volume, its material
  /// drawn where a map says which.
  [[nodiscard]] std::optional<geometry::Hit> intersect(const geometry::Ray& ray,
                                                       const Sampler& numbers) const;

 private:
  const SceneDescription* scene_;
  spectral::Lanes lanes_;
  EffectSet effects_;
  atmosphere::BoundAtmosphere air_;
  std::vector<Target> targets_;
  SkyDistribution sky_;
  BoundVolumes volumes_;
  BoundLamps lamps_;
  std::vector<materials::BoundMaterial> materials_;
  std::vector<materials::BoundMaterial> whole_;  // with their leaves' transmission, where left out
  bool shadows_ = true, interreflects_ = true, emits_ = true;
  void bind_materials(Diagnostics& diagnostics);
  void bind_temperatures();

  // By material; of one whose temperature varies from place to place: 0 where that does not matter.
  std::vector<spectral::Spectrum> black_body_;     // Planck costs several rays
  std::vector<spectral::Spectrum> even_emission_;  // where it does not depend on direction
  std::vector<bool> varies_;
  std::optional<PlanckTable> planck_;  // where some temperature varies
  std::vector<GenericPlan> plans_;     // by material, for the generic solver only
  bool has_sheets_ = false;
};

/// A direction drawn uniformly over the target's disc (by solid angle), scene axes.
[[nodiscard]] Vec3 direction_in_disc(const Target& target, Vec2 u) noexcept;

}  // namespace nadir::radiometry
