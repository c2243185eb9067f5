#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "materials/scattering/sample.hpp"

namespace nadir::materials {

/// Directional-hemispherical reflectance and transmittance of a model without a closed form,
/// tabulated when it is bound and interpolated linearly in sqrt(mu) (and azimuth where the model is
/// anisotropic), separately for the upper and the lower side where they differ.
///
/// The entries are means of the model's own sample weights over a scrambled point set: right for a
/// lobe of any width, because the model samples it. Bound models hold the table by
/// `shared_ptr<const AlbedoTable>`, which keeps them cheap to copy.
///
/// Accuracy: as good as the model samples itself. Where weights vary little from draw to draw,
/// better than 2e-3 of the albedo; steep changes toward grazing add up to 5e-3. 24 cosines; 256
/// draws each for an isotropic model, 256 for each of 8 azimuths (over half a turn) otherwise.
class AlbedoTable {
 public:
  using Sampling = std::function<std::optional<ScatteringSample>(Vec3 wo, const ScatteringDraw& u)>;
  struct Shape {
    int lanes = 0;
    bool two_sided = false;    ///< the lower side differs from the upper
    bool anisotropic = false;  ///< depends on the azimuth of wo, alike after half a turn
  };
  AlbedoTable(const Shape& shape, const Sampling& sample);

  /// For a one-sided table the mirror image of wo is taken where wo.z < 0.
  [[nodiscard]] Albedo at(Vec3 wo) const noexcept;
  /// The same for a table of one lane, which a model multiplies by its spectra. Reflectance only.
  [[nodiscard]] double reflectance_at(Vec3 wo) const noexcept;

 private:
  /// The four entries around a direction and their weights.
  struct Corners {
    std::size_t entry[4];
    float weight[4];
  };
  [[nodiscard]] Corners corners(Vec3 wo) const noexcept;
  [[nodiscard]] std::size_t columns() const noexcept;
  void fill(std::size_t entry, Vec3 wo, const Sampling& sample);

  Shape shape_;
  // An entry is `lanes` reflectances, then as many transmittances. Entries run over azimuth
  // fastest, then the cosine, then the side.
  std::vector<float> values_;
};

}  // namespace nadir::materials
