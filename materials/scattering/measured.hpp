#pragma once

#include <optional>
#include <vector>

#include "materials/scattering/angle_axis.hpp"
#include "materials/scattering/bind_context.hpp"
#include "materials/scattering/direction_table.hpp"
#include "materials/scattering/models.hpp"
#include "materials/scattering/sample.hpp"
#include "materials/scattering/smooth_albedo.hpp"

namespace nadir::materials {

/// Reflectance of an isotropic surface measured over directions and wavelength.
///
/// Linear in wavelength; the table must cover the lanes. Between the angles a spline with a
/// continuous slope (AngleAxis) in both zenith angles and the azimuth, cut off at 0 where it would
/// swing below. Zenith angles beyond the last one tabulated keep its value. Where one direction
/// is vertical the azimuths' mean is taken: there is no azimuth.
///
/// Reciprocity: f(i, o) and f(o, i) are averaged where both are tabulated, and where one is, it
/// stands for both, so that the model is reciprocal even where the instrument was not; a table of
/// few angles of incidence gains from it. `bind` refuses tables with an albedo above 1.02: 2 % is
/// the error of good goniometers. Directions are drawn from DirectionTable.
class BoundMeasured {
 public:
  /// @throws InputError for axes that do not ascend or do not run as BrdfTable says, values that
  /// are
  ///         negative, not finite or too few, lanes outside the table, energy gained
  BoundMeasured(const Measured& model, const BindContext& context);

  [[nodiscard]] spectral::Spectrum eval(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample(Vec3 wo,
                                                       const ScatteringDraw& u) const noexcept;
  [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept;
  [[nodiscard]] ScatteringTraits traits() const noexcept { return {}; }

 private:
  AngleAxis zenith_, azimuth_;
  int lanes_ = 0;
  std::vector<float> values_;  // [zenith][zenith][azimuth][lane], symmetric in the zenith angles
  DirectionTable directions_;
  SmoothAlbedo albedo_;
};

}  // namespace nadir::materials
