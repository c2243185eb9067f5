#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>

namespace nadir::sim {

/// Tells how far a run is: a bar with the time left on a terminal, a plain line at every tenth in a
/// log, nothing when quiet. Not thread-safe: the caller serialises.
class Progress {
 public:
  enum class Style { none, lines, bar };
  /// bar for a terminal, lines for anything else, none when quiet
  [[nodiscard]] static Style style_for(std::FILE* stream, bool quiet);

  Progress(std::FILE* stream, Style style);
  void update(std::size_t done, std::size_t all);

 private:
  using Clock = std::chrono::steady_clock;
  void draw_bar(double share, const std::string& time_left);

  std::FILE* stream_;
  Style style_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_drawn_;
  int last_tenth_ = 0;
};

/// "3 s", "2 min 05 s", "1 h 10 min".
[[nodiscard]] std::string readable_duration(double seconds);

}  // namespace nadir::sim
