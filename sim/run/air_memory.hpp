#pragma once

#include <cstddef>

#include "sim/run/load_air.hpp"

namespace nadir::sim {

/// Memory that the table of air in layers will need, in bytes: the table, and once more as much for
/// the form that is written to the cache and, later, the one that rays look up. At least what it
/// is; more where kinds of haze turn out to be alike.
[[nodiscard]] double air_table_memory(const LayeredTask& task, std::size_t lanes,
                                      std::size_t bodies);

}  // namespace nadir::sim
