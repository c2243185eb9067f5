#pragma once

namespace nadir::sim {

inline constexpr int exit_done = 0;
inline constexpr int exit_our_fault = 1;
inline constexpr int exit_bad_input = 2;
inline constexpr int exit_promise_not_kept = 3;

/// Thrown by a command that did its work but did not keep what it promised, after it has said so.
struct PromiseNotKept {};

}  // namespace nadir::sim
