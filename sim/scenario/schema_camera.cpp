#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

/// Wavelengths for which the Planck function and the spectra are tested.
NumberType wavelength() { return from_to(0.2, 20.0); }

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

}  // namespace

std::vector<ElementType> schema_of_camera() {
  std::vector<ElementType> all = camera();
  for (ElementType& type : bands()) all.push_back(std::move(type));
  return all;
}

}  // namespace nadir::sim
