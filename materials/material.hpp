#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/error.hpp"
#include "materials/maps/relief_map.hpp"
#include "materials/scattering/models.hpp"
#include "materials/solver_settings.hpp"
#include "spectral/curve.hpp"

namespace nadir::materials {

/// What a surface is made of, as the database and the scenario describe it. For scattering models
/// that are scaled by it at least one of reflectance and emissivity is there; Kirchhoff's law gives
/// the other: eps = 1 - rho - tau, with the directional-hemispherical rho and tau of the view
/// direction.
struct Material {
  std::string name;
  std::string description;
  std::optional<spectral::Curve> reflectance;    ///< directional-hemispherical, in [0, 1]
  std::optional<spectral::Curve> transmittance;  ///< likewise; none: opaque
  std::optional<spectral::Curve> emissivity;     ///< in [0, 1]
  Scattering scattering = Lambertian{};
  std::shared_ptr<const ReliefMap> relief;  ///< bumps of the surface; null: smooth
  std::optional<SolverSettings> solver;     ///< none: the scenario's default
  std::optional<std::uint32_t> shown_as{};  ///< products count it as that material of the scene
  SourceLocation where{};                   ///< in the user's files, for messages
};

}  // namespace nadir::materials
