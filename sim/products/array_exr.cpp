#include "sim/files/exr.hpp"
#include "sim/products/array_files.hpp"

namespace nadir::sim {
namespace {

void add_attributes(ExrImage& exr, const ArrayImage& image, const ProductContext& context) {
  std::vector<std::string> names;
  std::vector<float> wavelength_um, fwhm_um;
  for (const BandImage& band : image.bands) {
    names.push_back(band.name);
    wavelength_um.push_back(static_cast<float>(band.centre_um));
    fwhm_um.push_back(static_cast<float>(band.fwhm_um));
  }
  exr.attributes = {{"array", image.name},
                    {"bandNames", names},
                    {"wavelengthMicrometers", wavelength_um},
                    {"fwhmMicrometers", fwhm_um},
                    {"radianceUnits", std::string{"W m-2 sr-1 um-1"}},
                    {"scenario", context.scenario_name},
                    {"acquisitionTimeUtc", context.time_utc},
                    {"software", "nadir " + context.version}};
}

void add_truth(ExrImage& exr, const TruthImage& truth) {
  exr.channels.push_back({"truth.material", truth.material});
  exr.channels.push_back({"truth.range_m", truth.range_m});
  exr.channels.push_back({"truth.temperature_k", truth.temperature_k});
  exr.channels.push_back({"truth.sun_elevation_deg", truth.sun_elevation_deg});
  exr.channels.push_back({"truth.shadow_fraction", truth.shadow_fraction});
  std::vector<std::string> names{"sky"};
  names.insert(names.end(), truth.material_names.begin(), truth.material_names.end());
  exr.attributes["materialNames"] = names;
}

}  // namespace

void write_array_exr(const ArrayImage& image, const ProductContext& context,
                     const std::filesystem::path& stem, std::vector<ProductFile>& written) {
  ExrImage exr;
  exr.samples = image.samples;
  exr.lines = image.lines;
  for (const BandImage& band : image.bands) {
    exr.channels.push_back({"radiance." + band.name, band.radiance});
    exr.channels.push_back({"error." + band.name, band.standard_error});
  }
  add_attributes(exr, image, context);
  if (context.truth) add_truth(exr, image.truth);
  const auto file = with_ending(stem, ".exr");
  write_exr(file, exr);
  written.push_back({"exr", image.name, file, std::filesystem::file_size(file)});
}

}  // namespace nadir::sim
