#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace nadir::sim {

/// What one number gives of the light that reached the aperture, of a band's radiance.
struct EffectShares {
  std::vector<float> path;  ///< added by the air between surface and sensor
  std::vector<float>
      emission;  ///< emitted by the surface seen, through the air; the rest it reflects
};

/// One detector band of an image.
struct BandImage {
  std::string name;
  double centre_um = 0.0;
  double fwhm_um = 0.0;
  std::vector<float> radiance;        ///< at-aperture band mean, W m^-2 sr^-1 um^-1, row-major
  std::vector<float> standard_error;  ///< of the same, from independent replicates
  std::vector<float>
      brightness_temperature;  ///< K; filled for bands centred beyond 3 um, else empty
  std::vector<float>
      brightness_temperature_error;  ///< K, the standard error carried over; as above
  EffectShares shares{};             ///< in the unit of the radiance; empty unless asked for
  /// What is known of the error that sampling does not show (steps of the wavelength, bounces cut
  /// off, effects left out), in the unit of the radiance; empty unless it was stated.
  std::vector<float> bias{};
  std::vector<std::uint16_t> dn{};  ///< digital numbers; empty without a detector
  std::vector<float> electrons{};   ///< noise-free; empty unless asked for
  std::vector<float> noise{};       ///< sigma of the sensor's own noise, as radiance; as `dn`
};

/// What the pixels looked at. Ids by majority of the pixel's paths, the rest by their mean over
/// the paths that hit something; NaN where none did. A plane that nobody asked for is empty.
struct TruthImage {
  std::vector<std::string> material_names;  ///< name of id 1, 2, ...; id 0 is "sky"
  std::vector<std::uint32_t> material;      ///< 0 for sky, else 1 + index of the material
  std::vector<std::string> object_names;    ///< name of id 1, 2, ...; id 0 is "sky"
  std::vector<std::uint32_t> object;        ///< 0 for sky, else 1 + number of the object
  std::vector<float> range_m;               ///< sensor to surface
  std::vector<float> temperature_k;         ///< kinetic, area-weighted mean
  std::vector<float>
      sun_elevation_deg;  ///< above the surface's own tangent plane; negative: facing away
  std::vector<float>
      shadow_fraction;  ///< share of the pixel's surface that the sun's centre does not see
  std::vector<float> material_fraction;  ///< share of the pixel's paths that the majority has
  std::vector<float> normal_east, normal_north, normal_up;  ///< mean, scene axes; not unit at edges
  std::vector<float> sun_zenith_deg, sun_azimuth_deg;    ///< at the place, from its local vertical
  std::vector<float> view_zenith_deg, view_azimuth_deg;  ///< of the sensor as seen from the place
  std::vector<float> sky_view;  ///< share of the sky's cosine-weighted light not hidden
  std::vector<double> latitude_deg, longitude_deg, height_m;  ///< WGS84
  std::vector<double> time_s;  ///< of the pixel's exposure, after the scenario's time
  /// Share of the pixel's paths by material: the sky, then `material_names`; empty unless asked
  /// for.
  std::vector<std::vector<float>> fractions;
};

/// A plane of the truth: what writers need to know of it.
template <class Number>
struct TruthPlane {
  const char* name;  ///< in file headers
  const char* unit;
  const char* key;  ///< of the EXR's channel and the NetCDF's variable
  std::vector<Number> TruthImage::*values;
};

inline constexpr auto truth_planes = std::to_array<TruthPlane<float>>({
    {"range", "m", "range_m", &TruthImage::range_m},
    {"temperature", "K", "temperature_k", &TruthImage::temperature_k},
    {"sun elevation", "deg", "sun_elevation_deg", &TruthImage::sun_elevation_deg},
    {"shadow fraction", "", "shadow_fraction", &TruthImage::shadow_fraction},
    {"material fraction", "", "material_fraction", &TruthImage::material_fraction},
    {"normal east", "", "normal_east", &TruthImage::normal_east},
    {"normal north", "", "normal_north", &TruthImage::normal_north},
    {"normal up", "", "normal_up", &TruthImage::normal_up},
    {"sun zenith", "deg", "sun_zenith_deg", &TruthImage::sun_zenith_deg},
    {"sun azimuth", "deg", "sun_azimuth_deg", &TruthImage::sun_azimuth_deg},
    {"view zenith", "deg", "view_zenith_deg", &TruthImage::view_zenith_deg},
    {"view azimuth", "deg", "view_azimuth_deg", &TruthImage::view_azimuth_deg},
    {"sky view", "", "sky_view", &TruthImage::sky_view},
});
/// Where a float's seven digits would not do.
inline constexpr auto place_planes = std::to_array<TruthPlane<double>>({
    {"latitude", "deg", "latitude_deg", &TruthImage::latitude_deg},
    {"longitude", "deg", "longitude_deg", &TruthImage::longitude_deg},
    {"height", "m", "height_m", &TruthImage::height_m},
    {"time", "s", "time_s", &TruthImage::time_s},
});

/// What one detector array delivers: all of it, a strip of consecutive whole lines, or a tile.
struct ArrayImage {
  std::string name;
  int samples = 0, lines = 0;  ///< of the strip or tile
  std::vector<BandImage> bands;
  TruthImage truth;
  int first_line = 0;       ///< of the strip, in the image
  int all_lines = 0;        ///< of the image; 0: as many as `lines`
  std::uint32_t paths = 0;  ///< a pixel; where there is `pixel_paths`, the most
  /// Of each pixel, where they differ: sampled to a goal, or merged. Else empty.
  std::vector<std::uint32_t> pixel_paths{};
  int first_sample = 0;  ///< of the tile, in the image

  /// Paths of a pixel, however they are kept.
  [[nodiscard]] std::uint32_t paths_of(std::size_t pixel) const {
    return pixel_paths.empty() ? paths : pixel_paths[pixel];
  }
  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(samples) * static_cast<std::size_t>(lines);
  }
  [[nodiscard]] int image_lines() const { return all_lines > 0 ? all_lines : lines; }
};

}  // namespace nadir::sim
