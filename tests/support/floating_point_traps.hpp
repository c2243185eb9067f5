#pragma once

namespace nadir::support {

/// Whether this build can be trusted with traps: g++ keeps operations that a condition guards
/// behind it (-ftrapping-math is its default), clang computes both sides of a condition at once and
/// the sanitizers' own arithmetic is not ours.
[[nodiscard]] bool traps_are_honest() noexcept;

/// Invalid operations, divisions by zero and overflows raise SIGFPE in this thread, from here on.
/// Underflow and inexact results are what rounding is for.
void trap_floating_point() noexcept;
void ignore_floating_point() noexcept;
[[nodiscard]] bool floating_point_is_trapped() noexcept;

/// Where a SIGFPE struck, on the error stream, before whoever else handles it.
void print_where_it_trapped() noexcept;

/// While it lives, nothing traps; afterwards the state is as before, and what was raised meanwhile
/// is forgotten. For calls of code that is not ours and raises exceptions on purpose; and for tests
/// that hand over NaN, of which the comparison that finds it is an invalid operation itself.
class WithoutTraps {
 public:
  WithoutTraps() noexcept : trapped_{floating_point_is_trapped()} {
    if (trapped_) ignore_floating_point();
  }
  ~WithoutTraps() {
    if (trapped_) trap_floating_point();
  }
  WithoutTraps(const WithoutTraps&) = delete;
  WithoutTraps& operator=(const WithoutTraps&) = delete;

 private:
  bool trapped_;
};

}  // namespace nadir::support
