#pragma once

#include <vector>

namespace nadir::materials {

/// Measured reflectance of an isotropic surface as plain data: f in sr^-1 over zenith angles of
/// incidence and view, the azimuth between them, and wavelength.
///
/// Axes ascend strictly. Zenith angles begin at 0 and end at or before pi/2; relative azimuths run
/// from 0 (light and view on the same side: back scatter) to pi. `value` has wavelength running
/// fastest, then azimuth, then view, then incidence: value[((i * view + v) * azimuth + a) *
/// wavelength + w].
struct BrdfTable {
  std::vector<double> incidence_rad, view_rad, azimuth_rad, wavelength_um;
  std::vector<float> value;  ///< sr^-1, finite, >= 0, without holes
};

/// @throws InputError without location if the axes or values are not as stated above
void check(const BrdfTable& table);

}  // namespace nadir::materials
