#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace nadir::sim {

/// One detector band of a finished image.
struct BandImage {
  std::string name;
  double centre_um = 0.0;
  double fwhm_um = 0.0;
  std::vector<float> radiance;        ///< at-aperture band mean, W m^-2 sr^-1 um^-1, row-major
  std::vector<float> standard_error;  ///< of the same, from independent replicates
  std::vector<float>
      brightness_temperature;  ///< K; filled for bands centred beyond 3 um, else empty
};

/// What the pixels looked at. Ids by majority of the pixel's paths, the rest by their mean over
/// the paths that hit something; NaN where none did.
struct TruthImage {
  std::vector<std::string> material_names;  ///< name of id 1, 2, ...; id 0 is "sky"
  std::vector<std::uint32_t> material;      ///< 0 for sky, else 1 + index of the material
  std::vector<float> range_m;               ///< sensor to surface
  std::vector<float> temperature_k;         ///< kinetic, area-weighted mean
  std::vector<float>
      sun_elevation_deg;  ///< above the surface's own tangent plane; negative: facing away
  std::vector<float>
      shadow_fraction;  ///< share of the pixel's surface that the sun's centre does not see
};

/// Everything that one detector array delivers.
struct ArrayImage {
  std::string name;
  int samples = 0, lines = 0;
  std::vector<BandImage> bands;
  TruthImage truth;

  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(samples) * static_cast<std::size_t>(lines);
  }
};

}  // namespace nadir::sim
