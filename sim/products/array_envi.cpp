#include <fmt/format.h>

#include "sim/files/envi.hpp"
#include "sim/products/array_files.hpp"

namespace nadir::sim {
namespace {

constexpr const char* radiance_units = "W m-2 sr-1 um-1";

EnviHeader header_of(const ArrayImage& image, const ProductContext& context) {
  EnviHeader header;
  header.samples = image.samples;
  header.lines = image.lines;
  header.sensor_type = fmt::format("array {} simulated by nadir {}", image.name, context.version);
  header.acquisition_time = context.time_utc;
  return header;
}

void record(const char* kind, const ArrayImage& image, const std::filesystem::path& file,
            std::vector<ProductFile>& written) {
  for (const auto& path : {file, envi_header_of(file)}) {
    written.push_back({kind, image.name, path, std::filesystem::file_size(path)});
  }
}

std::string description(const char* what, const ProductContext& context) {
  return fmt::format("{}, scenario {}", what, context.scenario_name);
}

void write_bands(const ArrayImage& image, const ProductContext& context,
                 const std::filesystem::path& stem, std::vector<ProductFile>& written) {
  EnviHeader header = header_of(image, context);
  header.data_units = radiance_units;
  std::vector<std::span<const float>> radiance, error;
  for (const BandImage& band : image.bands) {
    header.band_names.push_back(band.name);
    header.wavelength_um.push_back(band.centre_um);
    header.fwhm_um.push_back(band.fwhm_um);
    radiance.emplace_back(band.radiance);
    error.emplace_back(band.standard_error);
  }
  header.description = description("At-aperture spectral radiance, band means", context);
  auto file = with_ending(stem, "_radiance.img");
  write_envi(file, header, radiance);
  record("radiance", image, file, written);

  header.description = description("Standard error of the spectral radiance", context);
  file = with_ending(stem, "_error.img");
  write_envi(file, header, error);
  record("standard error", image, file, written);
}

void write_truth(const ArrayImage& image, const ProductContext& context,
                 const std::filesystem::path& stem, std::vector<ProductFile>& written) {
  EnviHeader header = header_of(image, context);
  header.description =
      description("Truth planes, means over the pixel's surface; NaN: only sky", context);
  header.band_names = {"range (m)", "temperature (K)", "sun elevation (deg)", "shadow fraction"};
  header.nan_is_no_data = true;
  const TruthImage& truth = image.truth;
  const auto planes = std::vector<std::span<const float>>{
      truth.range_m, truth.temperature_k, truth.sun_elevation_deg, truth.shadow_fraction};
  auto file = with_ending(stem, "_truth.img");
  write_envi(file, header, planes);
  record("truth", image, file, written);

  EnviHeader ids = header_of(image, context);
  ids.class_names = {"sky"};
  ids.class_names.insert(ids.class_names.end(), truth.material_names.begin(),
                         truth.material_names.end());
  std::string names;
  for (std::size_t id = 0; id < ids.class_names.size(); ++id) {
    names += fmt::format("{}{} {}", id == 0 ? "" : ", ", id, ids.class_names[id]);
  }
  ids.description = description("Material of the pixel's majority", context) + ": " + names;
  ids.band_names = {"material"};
  file = with_ending(stem, "_material.img");
  write_envi(file, ids, std::vector<std::span<const std::uint32_t>>{truth.material});
  record("material", image, file, written);
}

}  // namespace

void write_array_envi(const ArrayImage& image, const ProductContext& context,
                      const std::filesystem::path& stem, std::vector<ProductFile>& written) {
  write_bands(image, context, stem, written);
  if (context.truth) write_truth(image, context, stem, written);
}

}  // namespace nadir::sim
