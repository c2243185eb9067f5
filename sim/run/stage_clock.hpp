#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/products/report.hpp"

namespace nadir::sim {

/// Measures the stages of a run, one after the other: wall clock and processor time of all threads.
class StageClock {
 public:
  /// Runs a stage under its name and hands on what it returns. A stage that throws is not recorded.
  template <class F>
  auto stage(const std::string& name, F&& work) {
    const Reading start = now();
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      record(name, start);
    } else {
      auto result = work();
      record(name, start);
      return result;
    }
  }
  [[nodiscard]] const std::vector<StageTime>& stages() const noexcept { return stages_; }

 private:
  struct Reading {
    double wall_s = 0.0, cpu_s = 0.0;
  };
  [[nodiscard]] static Reading now();
  void record(const std::string& name, const Reading& start);

  std::vector<StageTime> stages_;
};

/// Largest resident memory of this process so far.
[[nodiscard]] std::uint64_t peak_memory_bytes();

/// The computer's clock as ISO 8601 UTC, to the second.
[[nodiscard]] std::string clock_utc();

}  // namespace nadir::sim
