#pragma once

#include <string>
#include <vector>

#include "materials/solver_settings.hpp"

namespace nadir::bench {

/// A row of the table of solver settings.
struct StudyRow {
  std::string label;
  materials::SolverSettings settings;
};

/// The default, then one setting at a time changed, then some that change together.
/// @param lights  rays to lights that each hit sends
[[nodiscard]] std::vector<StudyRow> study_rows(int lights);

}  // namespace nadir::bench
