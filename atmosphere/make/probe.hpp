#pragma once

#include <vector>

#include "atmosphere/make/table_filler.hpp"
#include "atmosphere/table/bound_air_table.hpp"

namespace nadir::atmosphere {

/// Finds how far a table's interpolation is off between its nodes: at a few lanes, in random
/// directions to random shares of the way, looks the table up and sums the path directly with the
/// same fields. The error counts relative to the radiance, or to a tenth of the greatest radiance
/// met at that lane in that view where that is more: what is dark does not count. Directions within
/// 5 degrees of a body are left out: there the phase function itself is tabulated.
class ErrorProbe {
 public:
  ErrorProbe(const TableJob& job, const TableFiller& filler);

  /// Keeps the fields of the lanes to be probed. From several threads, each lane once.
  void keep(std::size_t lane, LaneFields fields);
  [[nodiscard]] double largest_error(const AirTable& table) const;

 private:
  struct Kept {
    std::size_t lane = 0;
    LaneFields fields;
  };
  [[nodiscard]] double view_error(const AirTable& table, const BoundAirTable& bound,
                                  const std::vector<std::size_t>& lanes, bool whole) const;

  const TableFiller& filler_;
  std::vector<Kept> kept_;
};

}  // namespace nadir::atmosphere
