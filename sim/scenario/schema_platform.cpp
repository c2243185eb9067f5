#include "sim/scenario/schema_platform.hpp"
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
       .doc = "Where the camera is, how it moves and which way it looks. Axes of a platform and of "
              "a camera on it: x towards increasing samples (image right), y towards increasing "
              "lines (image down), z along the line of sight.",
       .attributes = {optional("name", TextType{}, "", "no name", "For metadata.")},
       .content = Content::record,
       .children = {{"position", true}, {"attitude", true}, {"jitter"}, {"mounts"}}},
      {.id = "position",
       .name = "position",
       .doc = "Of the platform: a place where it stands still, or a way in time. Times are seconds "
              "after the scenario's.",
       .content = Content::one_of,
       .children = {{"geodetic"},
                    {"local"},
                    {"straight"},
                    {"circle"},
                    {"waypoints"},
                    {"circular_orbit"},
                    {"kepler_orbit"},
                    {"tle"},
                    {"oem"}}},
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
  };
}

}  // namespace

std::vector<ElementType> schema_of_platform() {
  std::vector<ElementType> all = platform();
  for (auto&& part : {schema_of_ways(), schema_of_attitude(), schema_of_mounts()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace nadir::sim
