#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

const char* const area_doc = "Of the raster's outer edge, in scene axes; all four or none.";
const char* const no_area = "the raster's own coordinate system places it";

std::vector<Attribute> map_of(std::vector<Attribute> own) {
  own.insert(own.begin(), {required("name", NameType{}, "", "Unique among materials and maps."),
                           required("raster", PathType{}, "", "Any raster that GDAL reads.")});
  return map_placement(std::move(own));
}

}  // namespace

std::vector<Attribute> map_placement(std::vector<Attribute> own) {
  own.push_back(defaulted("drape", EnumerationType{{"ground", "texture"}}, "", "ground",
                          "Over the ground from above, or along the mesh's texture coordinates."));
  for (const char* edge : {"west_m", "south_m", "east_m", "north_m"}) {
    own.push_back(optional(edge, coordinate(), "m", no_area, area_doc));
  }
  own.push_back(optional("size_u", above_to(0.0, 1e6), "", "1",
                         "Texture units that the raster's width spans; with drape=\"texture\"."));
  own.push_back(optional("size_v", above_to(0.0, 1e6), "", "1",
                         "Texture units that the raster's height spans; with drape=\"texture\"."));
  own.push_back(optional("repeats", boolean(), "", "true for texture, false for ground",
                         "Tiles the plane; otherwise the edge pixels go on outside."));
  return own;
}

std::vector<ElementType> schema_of_maps() {
  return {
      {.id = "relief",
       .name = "relief",
       .doc = "Bumps too fine for the mesh, from a raster of heights or a normal map.",
       .attributes = map_placement(
           {required("file", PathType{}, "", "Any raster that GDAL reads."),
            required("kind", EnumerationType{{"heights", "normals"}}, "",
                     "Band 1: heights in m (with drape=\"texture\": in texture units); or "
                     "bands 1 to 3: x, y, z of normals, x along rising columns, y upwards, "
                     "-1 to 1 (whole numbers: 0 to the type's largest)."),
            defaulted("strength", from_to(-1e4, 1e4), "", "1", "Factor on the slopes.")})},
      {.id = "material_map",
       .name = "material_map",
       .doc = "A raster that says which material is where; objects may name it as their material. "
              "Holds either choices (a pixel's value is looked up) or fractions (each band is the "
              "share of a material, in the sum 1).",
       .attributes = map_of(
           {optional("band", band_number(), "", "1", "Of the values that choices look up.")}),
       .content = Content::list,
       .children = {{"choice"}, {"fraction"}},
       .at_least = 1},
      {.id = "choice",
       .name = "choice",
       .doc = "What a value of the raster stands for. Every value in it needs one.",
       .attributes = {required("value", from_to(-1e9, 1e9), "", "As in the raster."),
                      required("material", NameType{}, "",
                               "Name of one of the scenario's materials.")}},
      {.id = "fraction",
       .name = "fraction",
       .doc = "A band that holds the share of a material, from 0 to 1.",
       .attributes = {required("band", band_number(), "", "Of the raster, from 1."),
                      required("material", NameType{}, "",
                               "Name of one of the scenario's materials.")}},
      {.id = "contrast_map",
       .name = "contrast_map",
       .doc =
           "Gives a surface the variety of many spectra of one material, laid out by the contrast "
           "of an image: each pixel takes the spectrum whose standard score among all, in the "
           "image's band, is nearest to its own. Objects may name it as their material.",
       .attributes = map_of(
           {required("material", NameType{}, "",
                     "Whose scattering model, temperature and solver all the spectra share."),
            defaulted("band", band_number(), "", "1", "Of the raster."),
            required("band_low_um", above_to(0.0, 1000.0), "um", "Where the image was taken."),
            required("band_high_um", above_to(0.0, 1000.0), "um", "Where the image was taken."),
            defaulted("half_window_pixels", IntegerType{0, 100000}, "", "0",
                      "Contrast within 2 of these and 1 pixels; 0: within the whole image.")}),
       .content = Content::list,
       .children = {{"contrast_spectrum"}},
       .at_least = 2},
      {.id = "contrast_spectrum",
       .name = "spectrum",
       .doc = "One of the spectra that a contrast map chooses from.",
       .attributes = {required("reflectance", SpectralType{from_to(0.0, 1.0)}, "",
                               "In place of the material's."),
                      optional("transmittance", SpectralType{from_to(0.0, 1.0)}, "",
                               "the material's", "In place of the material's.")}},
  };
}

}  // namespace nadir::sim
