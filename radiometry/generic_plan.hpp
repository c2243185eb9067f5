#pragma once

#include <optional>

#include "materials/bound_material.hpp"
#include "materials/solver_settings.hpp"
#include "radiometry/importance.hpp"
#include "radiometry/quad_hemisphere.hpp"

namespace nadir::radiometry {

/// How the generic solver samples the surroundings of one material.
class GenericPlan {
 public:
  GenericPlan(const materials::BoundMaterial& material, const materials::SolverSettings& settings);

  [[nodiscard]] const materials::SolverSettings& settings() const noexcept { return settings_; }
  [[nodiscard]] const QuadHemisphere& quads() const noexcept { return quads_; }
  /// None for materials whose lobes are narrower than a quad, ideal mirrors above all: their full
  /// samples are drawn by the model itself, since the mean over a quad would see the lobe by luck.
  [[nodiscard]] const std::optional<ImportanceTable>& importance() const noexcept {
    return importance_;
  }

 private:
  materials::SolverSettings settings_;
  QuadHemisphere quads_;
  std::optional<ImportanceTable> importance_;
};

}  // namespace nadir::radiometry
