#pragma once

#include <vector>

#include "sim/study/study_settings.hpp"

namespace nadir::sim {

/// What decides which settings are worth trying.
struct StudyScope {
  StudySettings scenario;    ///< the scenario's own
  int lights = 1;            ///< rays that lights take from a hit's samples
  bool layered_air = false;  ///< whose table follows from wavelengths and streams
  int streams = 8;           ///< of that air; 2: mode "fast"
};

/// Rows of a study, the most important first: the scenario's settings, the path solver, settings
/// that are known to be good (docs/solver-settings.md), then one thing varied at a time about the
/// scenario's settings of the generic solver, wavelengths and air last. None twice.
[[nodiscard]] std::vector<StudyPoint> study_points(const StudyScope& scope);

/// The settings of the reference: the path solver without a limit, all else as the scenario says.
[[nodiscard]] StudySettings reference_settings(const StudySettings& scenario);

}  // namespace nadir::sim
