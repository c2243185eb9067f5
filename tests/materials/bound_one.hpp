#pragma once

#include <numbers>
#include <optional>
#include <string>

#include "core/error.hpp"
#include "materials/scattering/bind_context.hpp"
#include "spectral/lanes.hpp"

namespace nadir::support {

/// A model at one lane, 1 um, under a material of this reflectance and transmittance.
template <class Bound, class Model>
[[nodiscard]] Bound bound_one(const Model& model, double rho = 0.0, double tau = 0.0) {
  const spectral::Lanes lanes{{Micrometres{1.0}}};
  const spectral::Spectrum reflectance{1, static_cast<float>(rho)};
  const spectral::Spectrum transmittance{1, static_cast<float>(tau)};
  return Bound{model, materials::BindContext{lanes, reflectance, transmittance}};
}

/// The message of the InputError that f throws, or "no error".
template <class F>
[[nodiscard]] std::string refusal(F&& f) {
  try {
    f();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

[[nodiscard]] inline double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

}  // namespace nadir::support
