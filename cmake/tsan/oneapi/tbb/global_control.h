#pragma once
#include "threads.hpp"

namespace oneapi::tbb {

class global_control {
 public:
  enum parameter { max_allowed_parallelism };
  global_control(parameter, std::size_t threads)
      : before_{nadir_tsan::most_threads.exchange(threads)} {}
  ~global_control() { nadir_tsan::most_threads = before_; }
  global_control(const global_control&) = delete;
  global_control& operator=(const global_control&) = delete;

 private:
  std::size_t before_;
};

}  // namespace oneapi::tbb
namespace tbb = oneapi::tbb;
