#pragma once

#include <cstddef>
#include <vector>

namespace nadir::sim {

/// What a way of computing a picture costs and how far off it is.
struct CostPoint {
  double time_s = 0.0, error = 0.0;
};

/// The points that no other beats: none is as fast and as accurate and better in one of the two. In
/// the order of time; of equals the first. Points that are not finite are left out.
[[nodiscard]] std::vector<std::size_t> pareto_front(const std::vector<CostPoint>& points);

}  // namespace nadir::sim
