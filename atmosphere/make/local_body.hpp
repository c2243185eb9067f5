#pragma once

#include <cstddef>
#include <vector>

#include "atmosphere/make/view_paths.hpp"

namespace nadir::atmosphere {

/// Transmittance of the delta-scaled air towards a low body as its height over the local horizon
/// changes along a path.
class LocalBody {
 public:
  LocalBody() = default;
  LocalBody(const Shells& shells, const std::vector<double>& scaled_depth, double mu0);
  [[nodiscard]] bool empty() const noexcept { return transmittance_.empty(); }
  /// @param layer, top  a height, see StepEnd
  [[nodiscard]] double transmittance(int layer, double top, double mu0) const noexcept;

 private:
  double lowest_rad_ = 0.0;  // elevation
  std::size_t levels_ = 0;
  std::vector<double> transmittance_;  // [elevation][level]
};

/// How far a body's first scattering is that with its local height: 1 for one lower than
/// 11.5 degrees (mu0 < 0.2), 0 for one above 14.5 (mu0 > 0.25), where the air between it and a path
/// varies by a few hundredths at most; smooth in between, so that no light jumps as it rises.
[[nodiscard]] double local_share(double mu0) noexcept;

}  // namespace nadir::atmosphere
