#include "sim/run/stage_clock.hpp"

#include <sys/resource.h>

#include <chrono>
#include <ctime>

namespace nadir::sim {
namespace {

rusage usage() {
  rusage values{};
  getrusage(RUSAGE_SELF, &values);
  return values;
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

}  // namespace

StageClock::Reading StageClock::now() {
  const auto wall = std::chrono::steady_clock::now().time_since_epoch();
  const rusage cpu = usage();
  return {std::chrono::duration<double>(wall).count(),
          seconds(cpu.ru_utime) + seconds(cpu.ru_stime)};
}

void StageClock::record(const std::string& name, const Reading& start) {
  const Reading end = now();
  stages_.push_back({name, end.wall_s - start.wall_s, end.cpu_s - start.cpu_s});
}

std::uint64_t peak_memory_bytes() {
  constexpr std::uint64_t bytes_per_kib = 1024;  // Linux counts ru_maxrss in KiB
  return static_cast<std::uint64_t>(usage().ru_maxrss) * bytes_per_kib;
}

std::string clock_utc() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace nadir::sim
