#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

/// auto, or as many wavelengths as spectral::gauss_quadrature can place.
EnumerationType counts_or_auto() {
  EnumerationType type{{"auto"}};
  for (int count = 1; count <= 32; ++count) type.values.push_back(std::to_string(count));
  return type;
}

std::vector<ElementType> results() {
  return {
      {.id = "sampling",
       .name = "sampling",
       .doc = "How much work each pixel gets.",
       .attributes = {defaulted("replicates", IntegerType{4, 1024}, "", "4",
                                "Independent repetitions that the standard error is made from."),
                      defaulted("samples_per_replicate", IntegerType{1, 1000000}, "", "2",
                                "Rays from the pixel in each repetition."),
                      defaulted("wavelengths_per_band", counts_or_auto(), "", "4",
                                "Wavelengths at which each band is computed; auto: for each band "
                                "the fewest that integrate the scene's spectra and air to the "
                                "accuracy asked for.")}},
      {.id = "products",
       .name = "products",
       .doc = "Which files are written.",
       .attributes =
           {defaulted("envi", boolean(), "", "true",
                      "Radiance, its standard error, digital numbers, truth and the rest as ENVI."),
            defaulted("exr", boolean(), "", "true", "All planes as one OpenEXR file."),
            defaulted("geotiff", boolean(), "", "false",
                      "Radiance, and digital numbers where there are any, as cloud-optimised "
                      "GeoTIFF."),
            defaulted("netcdf", boolean(), "", "false", "A swath as NetCDF with CF names."),
            defaulted(
                "sidecars", boolean(), "", "true",
                "Beside the images: a STAC item, and the geometry of every band as a USGS CSM "
                "image support file."),
            defaulted("quick_look", boolean(), "", "true", "A PNG picture for people."),
            defaulted("truth", boolean(), "", "true",
                      "What every pixel looked at: material, object, range, temperature, place, "
                      "angles, shadow."),
            defaulted("truth_temperature", boolean(), "", "false",
                      "Solves heat balances for the truth's temperatures even if no band sees "
                      "them; needs truth."),
            defaulted("sky_view", boolean(), "", "false",
                      "Truth: the share of the sky's light that is not hidden; a further ray for "
                      "each path; needs truth."),
            defaulted("fractions", boolean(), "", "false",
                      "Truth: the share of every material in every pixel; needs truth."),
            defaulted("electrons", boolean(), "", "false",
                      "Noise-free photo-electrons; needs a detector that counts them."),
            defaulted("statistics", boolean(), "", "false",
                      "Paths a pixel, and what the air and the surface's own heat have of every "
                      "band's radiance."),
            defaulted("keep_samples", boolean(), "", "true",
                      "Keeps the run's samples (samples.nadir) when it is finished, so that more "
                      "can be added and runs merged; until then they are always kept."),
            optional("quick_look_bands", NamesType{3}, "", "chosen from the bands' wavelengths",
                     "One band for shades of grey, or three of one array for red, green and "
                     "blue.")}},
  };
}

}  // namespace

std::vector<ElementType> schema_of_results() { return results(); }

}  // namespace nadir::sim
