#pragma once
// Work spread over std::threads in place of oneTBB's: for the thread sanitizer, see README.md.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace nadir_tsan {

/// What a global_control or an arena allows; 0: nothing said.
inline std::atomic<std::size_t> most_threads{0};
/// Whether this thread is one of a loop's already: loops within it run on it alone.
inline thread_local bool within_a_loop = false;

inline std::size_t threads_of_a_loop() {
  const std::size_t most = most_threads.load();
  return within_a_loop ? 1 : std::max<std::size_t>(most > 0 ? most : 4, 1);
}

/// Calls body(i) for i from 0 to count, each thread the next that is free; the first exception ends
/// the loop and is thrown here.
template <class Body>
void for_each_index(std::size_t count, const Body& body) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    const bool before = within_a_loop;
    within_a_loop = true;
    try {
      for (std::size_t i = next++; i < count; i = next++) body(i);
    } catch (...) {
      const std::lock_guard lock{mutex};
      if (!failure) failure = std::current_exception();
      next = count;
    }
    within_a_loop = before;
  };
  const std::size_t threads = std::min(threads_of_a_loop(), count);
  std::vector<std::thread> helpers;
  for (std::size_t i = 1; i < threads; ++i) helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace nadir_tsan
