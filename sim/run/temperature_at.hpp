#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/quantity.hpp"
#include "core/vec.hpp"
#include "ephemeris/instant.hpp"
#include "thermal/solve/heat_solver.hpp"

namespace nadir::sim {

/// Which surface of a scene is meant: the first that a ray from there meets.
struct PlaceQuestion {
  double east_m = 0.0, north_m = 0.0;
  std::optional<double> up_m;  ///< none: from above everything
  Vec3 direction{0.0, 0.0, -1.0};
};

/// How warm a place of a scene is, and where that comes from.
struct TemperatureAt {
  std::string title;  ///< of the scenario
  ephemeris::Instant time = ephemeris::Instant::parse_utc("2000-01-01T12:00:00Z");
  Vec3 place, normal;  ///< of the surface, scene axes
  std::string object, material;
  Kelvin temperature;
  std::optional<thermal::HeatMaterial> heat;  ///< of a surface with a heat balance
  std::optional<thermal::HeatRecord> record;  ///< likewise
  std::vector<std::string> warnings;
};

/// @throws InputError whatever is wrong with the scenario; a ray that meets nothing
[[nodiscard]] TemperatureAt temperature_at(const std::filesystem::path& scenario,
                                           const PlaceQuestion& question);

}  // namespace nadir::sim
