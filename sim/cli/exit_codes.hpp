#pragma once

namespace nadir::sim {

inline constexpr int exit_done = 0;
inline constexpr int exit_our_fault = 1;
inline constexpr int exit_bad_input = 2;

}  // namespace nadir::sim
