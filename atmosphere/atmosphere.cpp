#include "atmosphere/atmosphere.hpp"

#include <algorithm>
#include <limits>

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

BoundAtmosphere::BoundAtmosphere(const Atmosphere& atmosphere, const Lanes& lanes,
                                 const AirParts& parts)
    : sky_{Spectrum{lanes.count()}, Spectrum{lanes.count()}},
      beyond_{sky_},
      loses_{parts.path_transmittance},
      direct_{lanes.count(), 1.0F},
      path_{Spectrum{lanes.count(), 1.0F}, Spectrum{lanes.count()}} {
  if (const auto* tabulated = std::get_if<Tabulated>(&atmosphere)) {
    table_.emplace(tabulated->table, tabulated->ground, lanes, parts);
    views_ = !tabulated->table->views.empty();
    even_sky_ = !parts.sky();
  }
  if (const auto* uniform = std::get_if<Uniform>(&atmosphere)) bind(*uniform, lanes, parts);
}

void BoundAtmosphere::bind(const Uniform& air, const Lanes& lanes, const AirParts& parts) {
  using spectral::at_all;
  shape_ = air.sky_shape;
  even_sky_ = shape_ == SkyShape::even || !parts.sky_scattering;
  const auto fill = [&](Dome& dome, AirLight wanted) {
    if (wanted.emitted) dome.even = spectral::planck(lanes, air.sky_temperature);
    if (!wanted.scattered) return;
    Spectrum& scattered = shape_ == SkyShape::even ? dome.even : dome.shaped;
    scattered += at_all(air.sky_radiance, lanes, "the sky's radiance");
  };
  fill(sky_, sky_light(parts));
  fill(beyond_, path_light(parts));
  direct_ = at_all(air.solar_transmittance, lanes, "the air's solar transmittance");
  if (parts.path_scattering) {
    path_.radiance = at_all(air.path_radiance, lanes, "the air's path radiance");
  }
  if (!parts.path_emission && !parts.path_transmittance) return;
  const Spectrum left = at_all(air.transmittance, lanes, "the air's transmittance");
  if (parts.path_emission) path_.radiance += layer_emission(left, air.air_temperature, lanes);
  if (parts.path_transmittance) path_.transmittance = left;
}

Spectrum BoundAtmosphere::Dome::towards(Vec3 direction, SkyShape shape) const noexcept {
  if (shape == SkyShape::even) return even;
  const double bright = 3.0 / 7.0 * (1.0 + 2.0 * std::max(direction.z, 0.0));
  Spectrum radiance = even;
  return radiance.add_scaled(shaped, static_cast<float>(bright));
}

Spectrum BoundAtmosphere::sky(Vec3 direction_enu) const noexcept {
  return table_ ? table_->sky(direction_enu) : sky_.towards(direction_enu, shape_);
}

Spectrum BoundAtmosphere::direct_transmittance(Vec3 direction_enu) const noexcept {
  return table_ ? table_->direct_transmittance(direction_enu) : direct_;
}

Spectrum BoundAtmosphere::disc_transmittance(Vec3 eye, Vec3 direction) const noexcept {
  if (!loses_) return Spectrum{direct_.count(), 1.0F};
  if (!views_) return direct_transmittance(direction);
  return table_->path(eye, direction, std::numeric_limits<double>::infinity()).transmittance;
}

PathTerms BoundAtmosphere::path(Vec3 eye, Vec3 direction, double length_m) const noexcept {
  return table_ ? table_->path(eye, direction, length_m) : path_;
}

Spectrum BoundAtmosphere::beyond(Vec3 eye, Vec3 direction) const noexcept {
  return table_ ? table_->beyond(eye, direction) : beyond_.towards(direction, shape_);
}

}  // namespace nadir::atmosphere
