#pragma once

#include <cstddef>
#include <vector>

namespace nadir::sim {

/// How many wavelengths each band is computed at: the same number for all, or one a band.
struct BandNodes {
  // NOLINTNEXTLINE(google-explicit-constructor): a number says all there is to say
  constexpr BandNodes(int everywhere_ = 4) : everywhere{everywhere_} {}

  int everywhere = 4;                        ///< 0: chosen by the planner; 4 until then
  std::vector<std::vector<int>> by_array{};  ///< by array and band; empty: everywhere the same

  [[nodiscard]] int of(std::size_t array, std::size_t band) const {
    if (!by_array.empty()) return by_array.at(array).at(band);
    return everywhere > 0 ? everywhere : 4;
  }
  [[nodiscard]] bool operator==(const BandNodes&) const = default;
};

}  // namespace nadir::sim
