#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

/// A lighthouse's intensity in candela times 4 pi, and a laser's flux per um, stay below these.
NumberType lumens() { return from_to(0.0, 1e12); }
SpectralType flux() { return {from_to(0.0, 1e12)}; }
NumberType size() { return above_to(0.0, 1e5); }

/// A lamp: where it stands, where it shines and how much, then what is its own.
ElementType lamp(const std::string& name, const std::string& doc, std::vector<Attribute> own) {
  std::vector<Attribute> attributes = {
      optional("name", NameType{}, "", "the element's name", "For reports and messages."),
      defaulted("east_m", coordinate(), "m", "0",
                "Of the lamp's centre; in a list relative to the row's place."),
      defaulted("north_m", coordinate(), "m", "0", "Of the lamp's centre."),
      defaulted("up_m", coordinate(), "m", "0", "Of the lamp's centre."),
      defaulted("on_terrain", boolean(), "", "false",
                "up_m counts from the terrain below instead of the site."),
      optional("axis", VectorType{from_to(-1.0, 1.0), false}, "", "straight down",
               "Direction in which it shines: east, north, up; any length but 0."),
      optional("aim_m", VectorType{coordinate(), false}, "m", "axis says",
               "The place that it shines at, instead of axis."),
      defaulted("yaw_deg", full_turn(), "deg", "0",
                "Azimuth of its side (horizontal angle 0 of an IES file, the x axis of a plane), "
                "clockwise from north, before it is tilted from straight down to its axis."),
      optional("flux_w_per_um", flux(), "W um^-1", "lumens and colour_temperature_k are needed",
               "Spectral flux in all directions together."),
      optional("lumens", lumens(), "lm",
               "flux_w_per_um, or the flux of the IES file, or a column of the list",
               "Luminous flux in all directions together; needs a colour temperature."),
      optional("colour_temperature_k", from_to(1000.0, 25000.0), "K",
               "flux_w_per_um is needed, or a column of the list",
               "The lamp's spectrum is that of a black body of this temperature.")};
  for (Attribute& attribute : own) attributes.push_back(std::move(attribute));
  return {.id = name, .name = name, .doc = doc, .attributes = std::move(attributes)};
}

std::vector<Child> kinds() { return {{"point_lamp"}, {"spot_lamp"}, {"area_lamp"}}; }

ElementType area_lamp() {
  ElementType type =
      lamp("area_lamp",
           "A surface that shines diffusely from its front. It is part of the scene: it is seen, "
           "throws shadows and reflects as its material says.",
           {required("material", NameType{}, "", "Name of one of the scenario's materials.")});
  type.content = Content::one_of;
  type.children = {{"lamp_disc"}, {"lamp_plane"}, {"lamp_sphere"}};
  return type;
}

}  // namespace

std::vector<ElementType> schema_of_lamps() {
  std::vector<Child> all_kinds = kinds();
  all_kinds.push_back({"lamps_list"});
  return {
      {.id = "lamps",
       .name = "lamps",
       .doc = "What shines in the scene beside sun, moon and sky.",
       .content = Content::list,
       .children = std::move(all_kinds),
       .at_least = 1},
      lamp("point_lamp",
           "A lamp too small to have a size, alike in all directions or as a photometric file "
           "says.",
           {optional("ies", PathType{{".ies"}}, "", "alike in all directions",
                     "Intensity by direction, IES LM-63 type C; docs/formats.md.")}),
      lamp("spot_lamp", "A lamp too small to have a size that shines into a cone.",
           {required("half_angle_deg", above_to(0.0, 180.0), "deg",
                     "From the axis to the edge of the cone."),
            defaulted("cosine_power", from_to(0.0, 1e5), "", "0",
                      "Intensity falls like this power of the cosine of the angle from the axis; "
                      "nothing beyond 90 deg unless it is 0.")}),
      area_lamp(),
      {.id = "lamp_disc",
       .name = "disc",
       .doc = "A disc around the lamp's centre, normal to its axis.",
       .attributes = {required("radius_m", size(), "m", "Radius.")}},
      {.id = "lamp_plane",
       .name = "plane",
       .doc = "A rectangle around the lamp's centre, normal to its axis.",
       .attributes = {required("size_x_m", size(), "m", "Along the lamp's side (yaw_deg)."),
                      required("size_y_m", size(), "m", "Across it.")}},
      {.id = "lamp_sphere",
       .name = "sphere",
       .doc = "A ball around the lamp's centre; it shines outwards all around.",
       .attributes = {required("radius_m", size(), "m", "Radius.")}},
      {.id = "lamps_list",
       .name = "lamps_list",
       .doc = "One lamp placed by every row of a list, such as the street lamps of a town.",
       .attributes = {required("file", PathType{{".csv"}}, "",
                               "A lamp in every row; docs/formats.md."),
                      optional("name", NameType{}, "", "the lamp's name", "For messages."),
                      defaulted("on_terrain", boolean(), "", "false",
                                "up in the list counts from the terrain below.")},
       .content = Content::one_of,
       .children = kinds()},
  };
}

}  // namespace nadir::sim
