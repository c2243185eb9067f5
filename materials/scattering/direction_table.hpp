#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/vec.hpp"

namespace nadir::materials {

/// Draws directions of the upper hemisphere in proportion to a tabulated isotropic function times
/// the cosine: for each of 16 classes of the view's cosine a density that is constant in cells of
/// equal solid angle, 32 in the cosine times 32 in the azimuth from the view over half a turn. A
/// tenth of the draws follows the cosine alone, so that no direction that the table missed is lost,
/// and weights stay bounded.
class DirectionTable {
 public:
  DirectionTable() = default;
  /// @param f  the lane-averaged function, >= 0, called with wi.z > 0, wo.z > 0
  explicit DirectionTable(const std::function<double(Vec3 wi, Vec3 wo)>& f);

  /// Solid-angle density, sr^-1; wi.z > 0, wo.z > 0.
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] Vec3 draw(Vec3 wo, Vec2 u) const noexcept;

 private:
  void tabulate(std::size_t view, const std::function<double(Vec3 wi, Vec3 wo)>& f);

  std::vector<float> density_;  // [view][row][column], sr^-1
  std::vector<float> columns_;  // cumulative within each row
  std::vector<float> rows_;     // [view][row], cumulative
};

}  // namespace nadir::materials
