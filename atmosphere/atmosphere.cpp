#include "atmosphere/atmosphere.hpp"

#include "spectral/coverage.hpp"
#include "spectral/planck.hpp"

namespace nadir::atmosphere {
namespace {

using spectral::Lanes;
using spectral::Spectrum;

/// Emission of an isothermal layer by Kirchhoff's law: (1 - transmittance) B(T).
Spectrum layer_emission(const Spectrum& transmittance, Kelvin temperature, const Lanes& lanes) {
  Spectrum emitted{lanes.count(), 1.0F};
  emitted -= transmittance;
  return emitted * spectral::planck(lanes, temperature);
}

}  // namespace

BoundAtmosphere::BoundAtmosphere(const Atmosphere& atmosphere, const Lanes& lanes)
    : sky_{lanes.count()},
      direct_{lanes.count(), 1.0F},
      path_{Spectrum{lanes.count(), 1.0F}, Spectrum{lanes.count()}} {
  const auto* uniform = std::get_if<Uniform>(&atmosphere);
  if (uniform == nullptr) return;
  using spectral::at_all;
  sky_ = at_all(uniform->sky_radiance, lanes, "the sky's radiance") +
         spectral::planck(lanes, uniform->sky_temperature);
  direct_ = at_all(uniform->solar_transmittance, lanes, "the air's solar transmittance");
  path_.transmittance = at_all(uniform->transmittance, lanes, "the air's transmittance");
  path_.radiance = at_all(uniform->path_radiance, lanes, "the air's path radiance") +
                   layer_emission(path_.transmittance, uniform->air_temperature, lanes);
}

Spectrum BoundAtmosphere::sky(Vec3 /*direction_enu*/) const noexcept { return sky_; }

Spectrum BoundAtmosphere::direct_transmittance(Vec3 /*direction_enu*/) const noexcept {
  return direct_;
}

PathTerms BoundAtmosphere::path(Vec3 /*direction_enu*/, double /*length_m*/) const noexcept {
  return path_;
}

}  // namespace nadir::atmosphere
