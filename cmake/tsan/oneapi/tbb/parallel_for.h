#pragma once
#include <algorithm>

#include "blocked_range.h"
#include "threads.hpp"

namespace oneapi::tbb {

struct simple_partitioner {};
struct auto_partitioner {};
struct static_partitioner {};

template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body) {
  const auto size = static_cast<std::size_t>(range.end() - range.begin());
  const std::size_t grain = range.grainsize();
  nadir_tsan::for_each_index((size + grain - 1) / grain, [&](std::size_t i) {
    const auto first = static_cast<Value>(range.begin() + static_cast<Value>(i * grain));
    const auto last = std::min(range.end(), static_cast<Value>(first + static_cast<Value>(grain)));
    body(blocked_range<Value>{first, last, grain});
  });
}
template <class Value, class Body, class Partitioner>
void parallel_for(const blocked_range<Value>& range, const Body& body, const Partitioner&) {
  parallel_for(range, body);
}
template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body) {
  if (!(first < last)) return;
  nadir_tsan::for_each_index(static_cast<std::size_t>(last - first), [&](std::size_t i) {
    body(static_cast<Index>(first + static_cast<Index>(i)));
  });
}

}  // namespace oneapi::tbb
