#pragma once

#include "core/diagnostics.hpp"
#include "sim/run/world.hpp"

namespace nadir::sim {

/// Tells of detector arrays that see no surface before time is spent on them: a warning where there
/// is a sky to see or where a small object may lie between the lines of sight that were tried.
/// Warns of lines or samples that all see the same ground though they should come by motion, and
/// of time-delay integration that does not follow the ground's image.
/// @throws InputError for an array that would deliver nothing but darkness
void check_view(const World& world, Diagnostics& diagnostics);

}  // namespace nadir::sim
