#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

std::vector<ElementType> results() {
  return {
      {.id = "sampling",
       .name = "sampling",
       .doc = "How much work each pixel gets.",
       .attributes = {defaulted("replicates", IntegerType{4, 1024}, "", "4",
                                "Independent repetitions that the standard error is made from."),
                      defaulted("samples_per_replicate", IntegerType{1, 1000000}, "", "2",
                                "Rays from the pixel in each repetition."),
                      // as many as spectral::gauss_quadrature can place
                      defaulted("wavelengths_per_band", IntegerType{1, 32}, "", "4",
                                "Wavelengths at which each band is computed.")}},
      {.id = "products",
       .name = "products",
       .doc = "Which files are written.",
       .attributes =
           {defaulted("envi", boolean(), "", "true", "Radiance and its standard error as ENVI."),
            defaulted("exr", boolean(), "", "true", "Every band as one OpenEXR file."),
            defaulted("quick_look", boolean(), "", "true", "A PNG picture for people."),
            defaulted("truth", boolean(), "", "true",
                      "Material, range, temperature, sun elevation and shadow of every pixel."),
            defaulted("truth_temperature", boolean(), "", "false",
                      "Solves heat balances for the truth's temperatures even if no band sees "
                      "them; needs truth."),
            optional("quick_look_bands", NamesType{3}, "", "chosen from the bands' wavelengths",
                     "One band for shades of grey, or three of one array for red, green and "
                     "blue.")}},
  };
}

}  // namespace

std::vector<ElementType> schema_of_results() { return results(); }

}  // namespace nadir::sim
