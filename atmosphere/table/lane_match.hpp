#pragma once
// Private to this folder: which lanes of a table stand for the lanes of a block.

#include <cstddef>
#include <vector>

#include "atmosphere/table/air_table.hpp"
#include "spectral/lanes.hpp"

namespace nadir::atmosphere {

/// A lane between two of the table's: (1 - weight) of the lower and weight of the upper.
struct LaneMatch {
  std::size_t lower = 0, upper = 0;
  float weight = 0.0F;

  /// @param row  one value per lane of the table
  [[nodiscard]] float of(const float* row) const {
    return lower == upper ? row[lower] : row[lower] + weight * (row[upper] - row[lower]);
  }
};

/// A lane with the same wavelength, interval and term (wavelengths to 1e-9) is taken as it is.
/// Otherwise a lane without an interval lies between the table's lanes that are not split into
/// terms; so does the first term of a lane with one, where the table knows of no intervals at all.
/// @throws InputError where the table does not cover a lane
[[nodiscard]] std::vector<LaneMatch> match_lanes(const std::vector<AirTable::Lane>& table,
                                                 const spectral::Lanes& lanes);

}  // namespace nadir::atmosphere
