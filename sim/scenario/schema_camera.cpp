#include "sim/scenario/schema_parts.hpp"

// Cameras, their projections, presets and arrays. What stands in an array: schema_camera_parts.cpp.

namespace nadir::sim {
namespace {

IntegerType pixels() { return {1, 100000}; }
NumberType focal_place() { return from_to(-1e6, 1e6); }

std::vector<Attribute> lens() {
  const NumberType coefficient = from_to(-1e3, 1e3);
  const auto distortion = [&](const char* name, const char* doc) {
    return defaulted(name, coefficient, "", "0", doc);
  };
  return {required("focal_length_mm", above_to(0.0, 1e6), "mm", "Focal length."),
          distortion("k1",
                     "Radial distortion, of r^2; x to image right and y to image down over "
                     "the focal length, from ideal to distorted (Brown-Conrady, as OpenCV)."),
          distortion("k2", "Radial distortion, of r^4."),
          distortion("p1", "Tangential distortion: 2 p1 x y in x, p1 (r^2 + 2 y^2) in y."),
          distortion("p2", "Tangential distortion: p2 (r^2 + 2 x^2) in x, 2 p2 x y in y."),
          distortion("k3", "Radial distortion, of r^6."),
          defaulted("principal_x_um", focal_place(), "um", "0",
                    "Where the optical axis meets the focal plane, from the origin of the arrays' "
                    "offsets, to image right."),
          defaulted("principal_y_um", focal_place(), "um", "0", "The same, to image down.")};
}

/// An array: its size, then where it lies, then what all kinds have.
ElementType array(const std::string& id, const std::string& doc, std::vector<Attribute> geometry,
                  std::vector<Child> own) {
  std::vector<Attribute> attributes = {
      required("name", NameType{}, "", "Unique in the camera; its products are called after it."),
      required("samples", pixels(), "", "Columns of the image."),
      required("lines", pixels(), "",
               "Rows of the image: of detectors in a frame, exposures of a pushbroom's row, lines "
               "of all sweeps of a whiskbroom.")};
  for (Attribute& attribute : geometry) attributes.push_back(std::move(attribute));
  for (const char* axis : {"x", "y"}) {
    attributes.push_back(defaulted(std::string{"fill_"} + axis, above_to(0.0, 1.0), "", "1",
                                   std::string{"Sensitive part of the pitch along "} + axis + "."));
  }
  std::vector<Child> children = {{"band", true},      {"band_box", true},  {"band_gaussian", true},
                                 {"global_shutter"},  {"rolling_shutter"}, {"pushbroom"},
                                 {"whiskbroom"},      {"bolometer"},       {"optics"},
                                 {"gaussian_blur"},   {"blur_table"},      {"stray_light"},
                                 {"photon_detector"}, {"published_noise"}};
  for (Child& child : own) children.push_back(std::move(child));
  return {.id = id,
          .name = "array",
          .doc = doc,
          .attributes = std::move(attributes),
          .content = Content::list,
          .children = std::move(children),
          .at_least = 1};
}

std::vector<ElementType> arrays() {
  const char* const from_origin = "Of the array's centre, to image right.";
  const char* const down = "The same, to image down; a pushbroom's rows look ahead there.";
  const Attribute pitch =
      required("pitch_um", above_to(0.0, 1e5), "um", "From detector to detector.");
  const Attribute pitch_y = optional("pitch_y_um", above_to(0.0, 1e5), "um", "pitch_um",
                                     "The same along y, from line to line of detectors.");
  return {
      array("perspective_array",
            "A detector array. Every detector measures all of its bands. Places on the focal plane "
            "are seen from behind the camera. Without a timing all detectors see at one moment.",
            {pitch, pitch_y, defaulted("offset_x_um", focal_place(), "um", "0", from_origin),
             defaulted("offset_y_um", focal_place(), "um", "0", down),
             defaulted("own_lens", boolean(), "", "false",
                       "It stands behind a lens of its own, as in cameras with a lens for every "
                       "band: it may lie at the place of another array, and has no place in "
                       "common with it.")},
            {{"lens"}, {"module"}, {"diffraction"}}),
      array("orthographic_array",
            "A detector array of a camera whose lines of sight are parallel. Lengths on its focal "
            "plane are lengths across the beam.",
            {required("ground_pitch_m", above_to(0.0, 1e6), "m",
                      "From detector to detector, across the line of sight."),
             optional("ground_pitch_y_m", above_to(0.0, 1e6), "m", "ground_pitch_m",
                      "The same along y."),
             defaulted("offset_x_m", from_to(-1e6, 1e6), "m", "0",
                       "Of the array's centre from the optical axis."),
             defaulted("offset_y_m", from_to(-1e6, 1e6), "m", "0",
                       "Of the array's centre from the optical axis.")},
            {}),
      array("sighted_array", "A detector array whose lines of sight were measured.",
            {required("file", PathType{{".csv"}}, "",
                      "Lines of sight of pixels on a grid; docs/formats.md, View tables."),
             required("pitch_um", above_to(0.0, 1e5), "um",
                      "From detector to detector: the scale of blur and of the sensitive area."),
             pitch_y},
            {{"diffraction"}}),
  };
}

ElementType preset() {
  return {
      .id = "sensor_preset",
      .name = "sensor",
      .doc = "A camera from a sensor file, whole or a part of it.",
      .attributes = {
          required("file", PathType{{".xml"}, true}, "",
                   "A sensor file, beside the scenario or else in Nadir's data; docs/formats.md."),
          optional("arrays", NamesType{100}, "", "all of them", "Those of its arrays to take."),
          optional("samples", pixels(), "", "all of them",
                   "Columns of the first of them; others are cut to the same part."),
          optional("first_sample", IntegerType{0, 99999}, "", "the middle of the array is taken",
                   "First of these columns, from 0; needs samples."),
          optional("lines", pixels(), "", "as the file says",
                   "Rows of the first of them: a part of a frame, or how long a scanned pass is; "
                   "the others get the same part or the same length of time."),
          optional("first_line", IntegerType{0, 99999}, "", "the middle of the frame is taken",
                   "First of a frame's rows, from 0; needs lines."),
          optional("start_s", from_to(-1e6, 1e6), "s",
                   "each pass is centred on the scenario's time",
                   "Centre of the first line's exposure after the scenario's time, of arrays "
                   "that scan.")}};
}

ElementType sensor_file() {
  return {.id = sensor_root,
          .name = "sensor",
          .doc = "Root of a sensor file: a camera that scenarios may use, and its data sheet.",
          .attributes =
              {required("name", NameType{}, "", "Of the instrument, for metadata."),
               optional("title", TextType{}, "", "no title", "For people."),
               optional("platform", NameType{}, "", "not named", "What carries it, for metadata."),
               required("nominal_height_m", above_to(0.0, 1e9), "m",
                        "Above the ground, for ground sampling distance and swath."),
               optional("ground_speed_m_s", above_to(0.0, 1e5), "m s^-1", "it stands still",
                        "Of the place straight below, along the lines' sequence."),
               optional("source", TextType{}, "", "not named", "Where the figures come from.")},
          .content = Content::one_of,
          .children = {{"perspective"}, {"orthographic"}, {"lines_of_sight"}}};
}

std::vector<ElementType> cameras() {
  const auto projection = [](const char* name, const char* doc, const char* array_id,
                             std::vector<Attribute> attributes) {
    return ElementType{.id = name,
                       .name = name,
                       .doc = doc,
                       .attributes = std::move(attributes),
                       .content = Content::list,
                       .children = {{array_id}},
                       .at_least = 1};
  };
  return {
      {.id = "camera",
       .name = "camera",
       .doc = "What takes the image.",
       .attributes = {optional("name", NameType{}, "", "not named, or as a sensor file says",
                               "Of the instrument, for metadata.")},
       .content = Content::one_of,
       .children = {{"perspective"}, {"orthographic"}, {"lines_of_sight"}, {"sensor_preset"}}},
      projection("perspective", "A lens in front of a focal plane.", "perspective_array", lens()),
      projection("orthographic", "All detectors look in the same direction.", "orthographic_array",
                 {}),
      projection("lines_of_sight", "Every pixel looks where a table says.", "sighted_array", {}),
      preset(),
      sensor_file(),
  };
}

}  // namespace

std::vector<ElementType> schema_of_camera() {
  std::vector<ElementType> all = cameras();
  for (ElementType& type : arrays()) all.push_back(std::move(type));
  all.push_back({.id = "lens",
                 .name = "lens",
                 .doc =
                     "The lens of an array with own_lens=\"true\"; without it, it is like that of "
                     "the camera.",
                 .attributes = lens()});
  for (ElementType& type : schema_of_camera_parts()) all.push_back(std::move(type));
  return all;
}

}  // namespace nadir::sim
