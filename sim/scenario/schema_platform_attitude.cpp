#include "sim/scenario/schema_parts.hpp"
#include "sim/scenario/schema_platform.hpp"

namespace nadir::sim {
namespace {

NumberType unit_component() { return from_to(-1.001, 1.001); }

AttributeType reference_type() { return EnumerationType{{"scene", "earth", "local", "orbit"}}; }
constexpr const char* reference_doc =
    "Axes that it is given in: scene (east, north, up at the site), earth (ECEF), local (east, "
    "north, up at the platform), orbit (those of nadir).";

std::vector<Attribute> turns_on_track() {
  return {defaulted("yaw_deg", full_turn(), "deg", "0", "First, about z: right-handed."),
          defaulted("pitch_deg", full_turn(), "deg", "0",
                    "Then, about x: raises the line of sight towards the way ahead."),
          defaulted("roll_deg", full_turn(), "deg", "0",
                    "Then, about y: turns the line of sight to the platform's right."),
          defaulted("inertial", boolean(), "", "false",
                    "Follows the way among the stars instead of that over the turning earth.")};
}

std::vector<ElementType> steady_attitudes() {
  return {
      {.id = "attitude",
       .name = "attitude",
       .doc = "Of the platform.",
       .content = Content::one_of,
       .children =
           {{"look_at"}, {"euler"}, {"quaternion"}, {"nadir"}, {"velocity"}, {"attitude_table"}}},
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

std::vector<ElementType> moving_attitudes() {
  return {
      {.id = "quaternion",
       .name = "quaternion",
       .doc = "A rotation from the platform's axes to others; length 1 within 0.001.",
       .attributes = {required("reference", reference_type(), "", reference_doc),
                      required("w", unit_component(), "", "Scalar part."),
                      required("x", unit_component(), "", "Vector part."),
                      required("y", unit_component(), "", "Vector part."),
                      required("z", unit_component(), "", "Vector part.")}},
      {.id = "nadir",
       .name = "nadir",
       .doc = "Follows the way and looks straight down: z against the ellipsoid's normal, y along "
              "the horizontal part of the way.",
       .attributes = turns_on_track()},
      {.id = "velocity",
       .name = "velocity",
       .doc = "Follows the way: y exactly along it, z as far down as that allows.",
       .attributes = turns_on_track()},
      {.id = "attitude_table",
       .name = "attitude_table",
       .doc = "Orientations at moments, from a table, and the even turn between them; "
              "docs/formats.md.",
       .attributes = {required(
                          "file", PathType{{".csv"}}, "",
                          "Times as time_s or time_utc, and w, x, y, z; or yaw_deg, pitch_deg, "
                          "roll_deg (as in euler; with reference orbit as in nadir)."),
                      required("reference", reference_type(), "", reference_doc),
                      optional("max_gap_s", above_to(0.0, 1e9), "s",
                               "5 times the median step; any with fewer than 8 rows",
                               "The longest time between two rows while the camera looks.")}},
  };
}

}  // namespace

std::vector<ElementType> schema_of_attitude() {
  std::vector<ElementType> all = steady_attitudes();
  for (ElementType& type : moving_attitudes()) all.push_back(std::move(type));
  return all;
}

}  // namespace nadir::sim
