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

BoundAtmosphere::BoundAtmosphere(const Atmosphere& atmosphere, const Lanes& lanes)
    : sky_{lanes.count()},
      shaped_{lanes.count()},
      direct_{lanes.count(), 1.0F},
      path_{Spectrum{lanes.count(), 1.0F}, Spectrum{lanes.count()}} {
  if (const auto* tabulated = std::get_if<Tabulated>(&atmosphere)) {
    table_.emplace(tabulated->table, tabulated->ground, lanes);
    views_ = !tabulated->table->views.empty();
  }
  const auto* uniform = std::get_if<Uniform>(&atmosphere);
  if (uniform == nullptr) return;
  using spectral::at_all;
  sky_ = spectral::planck(lanes, uniform->sky_temperature);
  shape_ = uniform->sky_shape;
  (even_sky() ? sky_ : shaped_) += at_all(uniform->sky_radiance, lanes, "the sky's radiance");
  direct_ = at_all(uniform->solar_transmittance, lanes, "the air's solar transmittance");
  path_.transmittance = at_all(uniform->transmittance, lanes, "the air's transmittance");
  path_.radiance = at_all(uniform->path_radiance, lanes, "the air's path radiance") +
                   layer_emission(path_.transmittance, uniform->air_temperature, lanes);
}

Spectrum BoundAtmosphere::sky(Vec3 direction_enu) const noexcept {
  if (table_) return table_->sky(direction_enu);
  if (even_sky()) return sky_;
  const double shape = 3.0 / 7.0 * (1.0 + 2.0 * std::max(direction_enu.z, 0.0));
  Spectrum radiance = sky_;
  return radiance.add_scaled(shaped_, static_cast<float>(shape));
}

Spectrum BoundAtmosphere::direct_transmittance(Vec3 direction_enu) const noexcept {
  return table_ ? table_->direct_transmittance(direction_enu) : direct_;
}

Spectrum BoundAtmosphere::disc_transmittance(Vec3 eye, Vec3 direction) const noexcept {
  if (!views_) return direct_transmittance(direction);
  return table_->path(eye, direction, std::numeric_limits<double>::infinity()).transmittance;
}

PathTerms BoundAtmosphere::path(Vec3 eye, Vec3 direction, double length_m) const noexcept {
  return table_ ? table_->path(eye, direction, length_m) : path_;
}

Spectrum BoundAtmosphere::beyond(Vec3 eye, Vec3 direction) const noexcept {
  return table_ ? table_->beyond(eye, direction) : sky(direction);
}

}  // namespace nadir::atmosphere
