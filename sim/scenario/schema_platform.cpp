#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

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

}  // namespace

std::vector<ElementType> schema_of_platform() { return platform(); }

}  // namespace nadir::sim
