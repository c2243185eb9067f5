#pragma once
#include <utility>

#include "threads.hpp"

namespace oneapi::tbb {

class task_arena {
 public:
  static constexpr int automatic = -1;
  explicit task_arena(int = automatic) {}
  template <class Body>
  auto execute(Body&& body) -> decltype(body()) {
    return std::forward<Body>(body)();
  }
};

}  // namespace oneapi::tbb
namespace tbb = oneapi::tbb;
