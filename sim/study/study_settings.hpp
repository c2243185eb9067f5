#pragma once

#include <string>

#include "materials/solver_settings.hpp"
#include "radiometry/method.hpp"
#include "sim/scenario/band_nodes.hpp"

namespace nadir::sim {

/// One way of computing a scenario: all that a study varies but for the number of paths.
struct StudySettings {
  radiometry::Method method = radiometry::Method::path;
  int path_max_bounces = 0;           ///< of the path solver; 0: no limit, and no bias
  materials::SolverSettings generic;  ///< of the generic solver
  BandNodes wavelengths;
  /// Of air in layers: discrete ordinates; 2: two streams (mode "fast"); 0: as the scenario says.
  int air_streams = 0;
};

/// The settings as one line for people: "path solver", "generic: 8 samples, decay 2, ...".
[[nodiscard]] std::string readable(const StudySettings& settings);

/// The settings that change results, as text that differs where they do.
[[nodiscard]] std::string key_of(const StudySettings& settings);

/// The <solver> element that asks for them.
[[nodiscard]] std::string solver_element(const StudySettings& settings);

/// A row of a study.
struct StudyPoint {
  std::string name;   ///< "default", "4 bounces", ...; unique in a study
  std::string group;  ///< what is varied: "method", "samples", "decay", ...
  StudySettings settings;
  double weight = 1.0;  ///< share of the time that it gets, beside the others'
  /// Compared path by path with the same random numbers at the scenario's wavelengths and air,
  /// because its difference is far smaller than noise.
  bool paired = false;
  [[nodiscard]] bool unbiased() const noexcept {
    return settings.method == radiometry::Method::path && settings.path_max_bounces == 0 && !paired;
  }
};

}  // namespace nadir::sim
