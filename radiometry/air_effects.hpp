#pragma once

#include "atmosphere/air_parts.hpp"
#include "radiometry/effect.hpp"

namespace nadir::radiometry {

/// What of the air the effects ask for.
[[nodiscard]] constexpr atmosphere::AirParts air_parts(EffectSet effects) noexcept {
  return {effects.has(Effect::sky_scattering), effects.has(Effect::sky_emission),
          effects.has(Effect::path_scattering), effects.has(Effect::path_emission),
          effects.has(Effect::path_transmittance)};
}

/// Whether they need the air at all: light of sun and moon comes through it.
[[nodiscard]] constexpr bool needs_air(EffectSet effects) noexcept {
  return air_parts(effects) != atmosphere::AirParts::none() ||
         effects.has(Effect::solar_reflection) || effects.has(Effect::lunar_reflection);
}

}  // namespace nadir::radiometry
