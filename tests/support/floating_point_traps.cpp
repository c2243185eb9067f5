#include "support/floating_point_traps.hpp"

#include <cfenv>

#if defined(__GLIBC__)
#include <execinfo.h>
#include <unistd.h>

#include <array>
#include <csignal>
#endif

namespace nadir::support {

#if defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)

namespace {

constexpr int trapped_exceptions = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

void print_frames(int) {
  static std::array<void*, 40> frames;  // in a signal handler: no heap, little stack
  const int count = backtrace(frames.data(), static_cast<int>(frames.size()));
  backtrace_symbols_fd(frames.data(), count, STDERR_FILENO);
  std::signal(SIGFPE, SIG_DFL);
  std::raise(SIGFPE);
}

}  // namespace

bool traps_are_honest() noexcept { return true; }

void trap_floating_point() noexcept {
  std::feclearexcept(FE_ALL_EXCEPT);  // what is pending would trap at once
  feenableexcept(trapped_exceptions);
}
void ignore_floating_point() noexcept { fedisableexcept(FE_ALL_EXCEPT); }
bool floating_point_is_trapped() noexcept { return (fegetexcept() & trapped_exceptions) != 0; }

void print_where_it_trapped() noexcept {
  static std::array<void*, 1> first;
  backtrace(first.data(), 1);  // loads what it needs while the heap may still be used
  std::signal(SIGFPE, print_frames);
}

#else

bool traps_are_honest() noexcept { return false; }
void trap_floating_point() noexcept {}
void ignore_floating_point() noexcept {}
bool floating_point_is_trapped() noexcept { return false; }
void print_where_it_trapped() noexcept {}

#endif

}  // namespace nadir::support
