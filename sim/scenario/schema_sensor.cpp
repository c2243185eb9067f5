#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

/// Wavelengths for which the Planck function and the spectra are tested.
NumberType wavelength() { return from_to(0.2, 20.0); }

std::vector<Attribute> geodetic_place() {
  return {required("latitude_deg", latitude(), "deg", "Geodetic, north positive."),
          required("longitude_deg", longitude(), "deg", "East positive."),
          required("height_m", from_to(-1e4, 1e8), "m", "Above the WGS84 ellipsoid.")};
}

std::vector<ElementType> platform() {
  return {
      {.id = "platform",
       .name = "platform",
       .doc = "Where the camera is and which way it looks.",
       .content = Content::record,
       .children = {{"position", true}, {"attitude", true}}},
      {.id = "position",
       .name = "position",
       .doc = "Of the camera.",
       .content = Content::one_of,
       .children = {{"geodetic"}, {"local"}}},
      {.id = "geodetic",
       .name = "geodetic",
       .doc = "A place by its coordinates on the earth.",
       .attributes = geodetic_place()},
      {.id = "local",
       .name = "local",
       .doc = "A place in the scene's axes.",
       .attributes = {required("east_m", coordinate(), "m", "From the site."),
                      required("north_m", coordinate(), "m", "From the site."),
                      required("up_m", coordinate(), "m", "From the site."),
                      defaulted("on_terrain", boolean(), "", "false",
                                "up_m counts from the terrain below instead of the site.")}},
      {.id = "attitude",
       .name = "attitude",
       .doc = "Of the camera.",
       .content = Content::one_of,
       .children = {{"look_at"}, {"euler"}}},
      {.id = "look_at",
       .name = "look_at",
       .doc = "The middle of the image looks at this place.",
       .attributes = {defaulted("roll_deg", full_turn(), "deg", "0",
                                "Clockwise about the line of sight. At 0 the top of the image is "
                                "as high as it goes, or north when looking straight down.")},
       .content = Content::one_of,
       .children = {{"geodetic"}, {"local"}}},
      {.id = "euler",
       .name = "euler",
       .doc = "Angles of the line of sight.",
       .attributes = {required("yaw_deg", full_turn(), "deg", "Clockwise from north."),
                      required("pitch_deg", from_to(-90.0, 90.0), "deg",
                               "Up from the horizon; -90 looks straight down."),
                      defaulted("roll_deg", full_turn(), "deg", "0", "Right side down.")}},
  };
}

ElementType array(const std::string& id, std::vector<Attribute> geometry) {
  const IntegerType pixels{1, 100000};
  std::vector<Attribute> attributes = {
      required("name", NameType{}, "", "Unique in the camera; its products are called after it."),
      required("samples", pixels, "", "Columns of detectors."),
      required("lines", pixels, "", "Rows of detectors.")};
  for (Attribute& attribute : geometry) attributes.push_back(std::move(attribute));
  return {.id = id,
          .name = "array",
          .doc = "A detector array. Every detector measures all of its bands.",
          .attributes = std::move(attributes),
          .content = Content::list,
          .children = {{"band"}, {"band_box"}, {"band_gaussian"}},
          .at_least = 1};
}

std::vector<ElementType> camera() {
  const NumberType offset_um = from_to(-1e6, 1e6);
  const char* const from_axis = "Of the array's centre from the optical axis.";
  return {
      {.id = "camera",
       .name = "camera",
       .doc = "A framing camera: every detector sees at the same moment.",
       .content = Content::one_of,
       .children = {{"perspective"}, {"orthographic"}}},
      {.id = "perspective",
       .name = "perspective",
       .doc = "A pinhole in front of a focal plane.",
       .attributes = {required("focal_length_mm", above_to(0.0, 1e6), "mm", "Focal length.")},
       .content = Content::list,
       .children = {{"perspective_array"}},
       .at_least = 1},
      {.id = "orthographic",
       .name = "orthographic",
       .doc = "All detectors look in the same direction.",
       .content = Content::list,
       .children = {{"orthographic_array"}},
       .at_least = 1},
      array("perspective_array",
            {required("pitch_um", above_to(0.0, 1e5), "um", "From detector to detector."),
             defaulted("offset_x_um", offset_um, "um", "0", from_axis),
             defaulted("offset_y_um", offset_um, "um", "0", from_axis)}),
      array("orthographic_array",
            {required("ground_pitch_m", above_to(0.0, 1e6), "m",
                      "From detector to detector, across the line of sight."),
             defaulted("offset_x_m", from_to(-1e6, 1e6), "m", "0", from_axis),
             defaulted("offset_y_m", from_to(-1e6, 1e6), "m", "0", from_axis)}),
  };
}

std::vector<ElementType> bands() {
  const Attribute name = required("name", NameType{}, "", "Unique in its array.");
  return {
      {.id = "band",
       .name = "band",
       .doc = "A band whose relative response is a column of a file.",
       .attributes = {name, required("response", ColumnType{}, "", "Relative spectral response.")}},
      {.id = "band_box",
       .name = "band_box",
       .doc = "A band of response 1 between two wavelengths.",
       .attributes = {name, required("lo_um", wavelength(), "um", "Least wavelength."),
                      required("hi_um", wavelength(), "um", "Greatest wavelength.")}},
      {.id = "band_gaussian",
       .name = "band_gaussian",
       .doc = "A band of Gaussian response.",
       .attributes = {name, required("centre_um", wavelength(), "um", "Wavelength of the peak."),
                      required("fwhm_um", above_to(0.0, 10.0), "um",
                               "Full width at half maximum.")}},
  };
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

std::vector<ElementType> schema_of_sensor() {
  std::vector<ElementType> all = platform();
  for (auto&& part : {camera(), bands(), results()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace nadir::sim
