#pragma once
#include "threads.hpp"

namespace oneapi::tbb::info {

inline int default_concurrency() { return static_cast<int>(nadir_tsan::threads_of_a_loop()); }

}  // namespace oneapi::tbb::info
namespace tbb = oneapi::tbb;
