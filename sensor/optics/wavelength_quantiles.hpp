#pragma once

#include <array>
#include <cstddef>

#include "spectral/response.hpp"

namespace nadir::sensor {

/// Wavelengths that cut a band's response into parts of equal area: drawing evenly between two of
/// them draws the response.
class WavelengthQuantiles {
 public:
  static constexpr std::size_t parts = 64;
  explicit WavelengthQuantiles(const spectral::Response& response);

  /// The wavelength below which a share of the response lies, um.
  [[nodiscard]] double at(double share) const noexcept {
    const double place = share * static_cast<double>(parts);
    const auto part = static_cast<std::size_t>(place);
    if (part >= parts) return edges_um_[parts];
    const double within = place - static_cast<double>(part);
    return edges_um_[part] + within * (edges_um_[part + 1] - edges_um_[part]);
  }
  /// The middle of a part: `parts` equal weights stand for the band.
  [[nodiscard]] double middle(std::size_t part) const noexcept {
    return 0.5 * (edges_um_[part] + edges_um_[part + 1]);
  }

 private:
  std::array<double, parts + 1> edges_um_{};
};

}  // namespace nadir::sensor
