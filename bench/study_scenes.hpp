#pragma once

#include <string>
#include <vector>

#include "geometry/ray_query.hpp"
#include "radiometry/lit_scene.hpp"

// The scenes of the table of solver settings: small, built in memory, each for one thing that
// settings of the generic solver have to cope with.

namespace nadir::bench {

/// Neighbouring lanes that the table reports together.
struct LaneGroup {
  std::string name;
  int first = 0, count = 0;
};

struct StudyScene {
  std::string name;   ///< for the command line
  std::string title;  ///< a line for the reader
  radiometry::SceneDescription description;
  spectral::Lanes lanes;
  std::vector<LaneGroup> groups;
  std::vector<geometry::Ray> views;  ///< always the same; what is compared is the mean over them
};

[[nodiscard]] const std::vector<std::string>& study_scene_names();
/// @param name  one of study_scene_names()
[[nodiscard]] StudyScene study_scene(const std::string& name);

}  // namespace nadir::bench
