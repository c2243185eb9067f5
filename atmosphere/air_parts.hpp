#pragma once

namespace nadir::atmosphere {

/// Which of the air's doings are wanted. What a body's own light loses on its way to a surface is
/// part of that light and always there.
///
/// Scattered: light of bodies, of the night sky and towns, and what the ground about reflects of
/// them. Emitted: by the air and by the ground about, and what they scatter and reflect of that.
struct AirParts {
  bool sky_scattering = true, sky_emission = true;    ///< onto surfaces
  bool path_scattering = true, path_emission = true;  ///< into the line of sight
  bool path_transmittance = true;

  [[nodiscard]] static constexpr AirParts none() noexcept {
    return {false, false, false, false, false};
  }
  [[nodiscard]] constexpr bool scattering() const noexcept {
    return sky_scattering || path_scattering;
  }
  [[nodiscard]] constexpr bool emission() const noexcept { return sky_emission || path_emission; }
  [[nodiscard]] constexpr bool sky() const noexcept { return sky_scattering || sky_emission; }
  [[nodiscard]] constexpr bool path_light() const noexcept {
    return path_scattering || path_emission;
  }
  [[nodiscard]] constexpr bool path() const noexcept { return path_light() || path_transmittance; }
  /// What either wants.
  [[nodiscard]] constexpr AirParts operator|(const AirParts& b) const noexcept {
    return {sky_scattering || b.sky_scattering, sky_emission || b.sky_emission,
            path_scattering || b.path_scattering, path_emission || b.path_emission,
            path_transmittance || b.path_transmittance};
  }
  [[nodiscard]] constexpr bool operator==(const AirParts&) const noexcept = default;
};

/// Light of the two origins in one place, by whether it was scattered or emitted by the air.
struct AirLight {
  bool scattered = true, emitted = true;
  [[nodiscard]] constexpr bool any() const noexcept { return scattered || emitted; }
};
[[nodiscard]] constexpr AirLight sky_light(const AirParts& parts) noexcept {
  return {parts.sky_scattering, parts.sky_emission};
}
[[nodiscard]] constexpr AirLight path_light(const AirParts& parts) noexcept {
  return {parts.path_scattering, parts.path_emission};
}

}  // namespace nadir::atmosphere
