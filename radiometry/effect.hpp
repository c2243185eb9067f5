#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace nadir::radiometry {

/// One term of the image that can be left out. docs/effects.md says what exactly is left out, and
/// how its size is bounded.
enum class Effect : std::uint8_t {
  solar_reflection,    ///< rays from surfaces and volumes to the sun, and the sun's own disc
  lunar_reflection,    ///< the same for the moon
  lamps,               ///< all artificial light
  sky_scattering,      ///< light of sun, moon and night sky that the air scatters onto surfaces
  surface_emission,    ///< what surfaces emit by their temperature
  sky_emission,        ///< what the air emits onto surfaces
  path_scattering,     ///< what the air scatters into the line of sight
  path_emission,       ///< what the air emits into the line of sight
  path_transmittance,  ///< what the air takes away along the line of sight
  interreflection,     ///< light that more than one surface has reflected
  leaf_transmission,   ///< light through leaves and other diffusing sheets
  volumes,             ///< clouds, plumes, smoke
  shadows,             ///< of sun, moon and lamps
  refraction,          ///< of the camera's lines of sight
  eclipse,             ///< of sun or moon
  motion_blur,         ///< the way of the sensor and its jitter during the exposure
  psf,                 ///< optics and detector wider than the pixel
  detector_noise,      ///< of the digital numbers
  thermal_solve        ///< temperatures from the heat balance
};
inline constexpr std::size_t effect_count = 19;

/// Names as files and reports have them, in the order of the enumeration.
inline constexpr std::array<std::string_view, effect_count> effect_names{"solar_reflection",
                                                                         "lunar_reflection",
                                                                         "lamps",
                                                                         "sky_scattering",
                                                                         "surface_emission",
                                                                         "sky_emission",
                                                                         "path_scattering",
                                                                         "path_emission",
                                                                         "path_transmittance",
                                                                         "interreflection",
                                                                         "leaf_transmission",
                                                                         "volumes",
                                                                         "shadows",
                                                                         "refraction",
                                                                         "eclipse",
                                                                         "motion_blur",
                                                                         "psf",
                                                                         "detector_noise",
                                                                         "thermal_solve"};

[[nodiscard]] constexpr std::size_t index_of(Effect effect) noexcept {
  return static_cast<std::size_t>(effect);
}
[[nodiscard]] constexpr std::string_view name_of(Effect effect) noexcept {
  return effect_names[index_of(effect)];
}

/// Effects that are simulated.
class EffectSet {
 public:
  [[nodiscard]] static constexpr EffectSet all() noexcept {
    return EffectSet{(1U << effect_count) - 1U};
  }
  constexpr EffectSet() noexcept = default;  ///< none

  [[nodiscard]] constexpr bool has(Effect effect) const noexcept {
    return (bits_ & bit(effect)) != 0;
  }
  [[nodiscard]] constexpr EffectSet with(Effect effect) const noexcept {
    return EffectSet{bits_ | bit(effect)};
  }
  [[nodiscard]] constexpr EffectSet without(Effect effect) const noexcept {
    return EffectSet{bits_ & ~bit(effect)};
  }
  /// What either has.
  [[nodiscard]] constexpr EffectSet operator|(EffectSet other) const noexcept {
    return EffectSet{bits_ | other.bits_};
  }
  [[nodiscard]] constexpr bool operator==(const EffectSet&) const noexcept = default;

 private:
  constexpr explicit EffectSet(std::uint32_t bits) noexcept : bits_{bits} {}
  [[nodiscard]] static constexpr std::uint32_t bit(Effect effect) noexcept {
    return 1U << index_of(effect);
  }
  std::uint32_t bits_ = 0;
};

}  // namespace nadir::radiometry
