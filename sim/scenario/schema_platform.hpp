#pragma once

#include <vector>

#include "sim/scenario/schema.hpp"

namespace nadir::sim {

/// Positions that change in time.
[[nodiscard]] std::vector<ElementType> schema_of_ways();
[[nodiscard]] std::vector<ElementType> schema_of_attitude();
/// Jitter and mounts.
[[nodiscard]] std::vector<ElementType> schema_of_mounts();

}  // namespace nadir::sim
