#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "core/error.hpp"
#include "geometry/region.hpp"
#include "sim/scenario/placement_input.hpp"
#include "sim/scenario/spectral_input.hpp"

namespace nadir::sim {

struct HenyeyGreensteinInput {
  SpectralInput g{0.0, {}};  ///< mean cosine
};
struct RayleighInput {};
struct PhaseTableInput {
  std::filesystem::path file;  ///< CSV
};

/// A participating volume: a shape filled with something that absorbs, scatters and emits.
struct VolumeInput {
  std::string name;
  geometry::RegionShape shape;
  PlacementInput placement;
  SpectralInput absorption_per_m{0.0, {}};
  SpectralInput scattering_per_m{0.0, {}};
  std::variant<HenyeyGreensteinInput, RayleighInput, PhaseTableInput> phase;
  std::optional<std::filesystem::path> density_grid;        ///< NRRD; none: 1 everywhere
  std::variant<double, std::filesystem::path> temperature;  ///< K, or a grid of it
  SourceLocation where{};
};

}  // namespace nadir::sim
