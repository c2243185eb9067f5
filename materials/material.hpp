#pragma once

#include <optional>
#include <string>

#include "materials/scattering.hpp"
#include "materials/solver_settings.hpp"
#include "spectral/curve.hpp"

namespace nadir::materials {

/// What a surface is made of, as the database and the scenario describe it. At least one of
/// reflectance and emissivity is there; Kirchhoff's law gives the other (opaque: eps = 1 - rho).
struct Material {
  std::string name;
  std::string description;
  std::optional<spectral::Curve> reflectance;  ///< directional-hemispherical, in [0, 1]
  std::optional<spectral::Curve> emissivity;   ///< in [0, 1]
  Scattering scattering = Lambertian{};
  std::optional<SolverSettings> solver;  ///< none: the scenario's default
};

}  // namespace nadir::materials
