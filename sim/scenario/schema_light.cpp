#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

/// The sun at 1 AU has 2000 W m^-2 um^-1 at its peak; lamps may be much brighter.
SpectralType irradiance() { return {from_to(0.0, 1e9)}; }

}  // namespace

std::vector<ElementType> schema_of_light() {
  return {
      {.id = "illumination",
       .name = "illumination",
       .doc = "The bodies that light the scene.",
       .content = Content::one_of,
       .children = {{"ephemeris"}, {"fixed"}}},
      {.id = "ephemeris",
       .name = "ephemeris",
       .doc = "Sun and moon where they stand at the scenario's time, seen from its site.",
       .attributes =
           {optional("solar_irradiance", irradiance(), "W m^-2 um^-1",
                     "library:illumination/solar.csv",
                     "Of the sun at 1 AU above the air, on a plane normal to its direction; scaled "
                     "by the actual distance, and darkened by an eclipse. 0: the sun is dark."),
            optional("lunar_irradiance", irradiance(), "W m^-2 um^-1",
                     "the ROLO model's, where the sun is less than 5 degrees high",
                     "Of the moon above the air, as it arrives that night, eclipses included. The "
                     "model: sunlight times the moon's reflectance at that phase and libration, "
                     "distances and eclipses included. 0: the moon is dark.")}},
      {.id = "fixed",
       .name = "fixed",
       .doc = "Bodies at given angles. Without any the scene has no sun and no moon.",
       .content = Content::list,
       .children = {{"body"}}},
      {.id = "body",
       .name = "body",
       .doc = "A luminous disc in the sky.",
       .attributes = {required("name", NameType{}, "", "Such as sun."),
                      required("azimuth_deg", full_turn(), "deg", "Clockwise from north."),
                      required("elevation_deg", from_to(-90.0, 90.0), "deg", "Above the horizon."),
                      // 0.2666 deg: the sun's radius of 695700 km seen from 1 AU
                      defaulted("angular_radius_deg", above_to(0.0, 89.0), "deg", "0.2666",
                                "Half the angle that it spans; the default is the sun's."),
                      required("irradiance", irradiance(), "W m^-2 um^-1",
                               "Above the air, on a plane normal to its direction.")}},
  };
}

}  // namespace nadir::sim
