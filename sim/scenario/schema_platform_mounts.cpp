#include "sim/scenario/schema_parts.hpp"
#include "sim/scenario/schema_platform.hpp"

namespace nadir::sim {
namespace {

constexpr double most_white_urad = 1e6;  // a radian: more is no small angle

ElementType jitter_type() {
  const auto white = [](const char* name, const char* doc) {
    return defaulted(name, from_to(0.0, most_white_urad), "urad", "0", doc);
  };
  return {
      .id = "jitter",
      .name = "jitter",
      .doc =
          "Shakes the camera by small angles about its axes; give white noise, a spectrum "
          "or both.",
      .attributes = {white("white_x_urad", "Root mean square about x, from moment to moment anew."),
                     white("white_y_urad", "The same about y."),
                     white("white_z_urad", "The same about z."),
                     optional("spectrum", PathType{{".csv"}}, "", "white noise only",
                              "Power spectral densities: frequency_hz, and x_rad2_hz, y_rad2_hz or "
                              "z_rad2_hz; docs/formats.md."),
                     defaulted("seed", IntegerType{0, 2147483647}, "", "1",
                               "Of the motion that has this spectrum.")}};
}

ElementType mount_type() {
  const auto offset = [](const char* name) {
    return defaulted(name, coordinate(), "m", "0", "Of its origin, in its carrier's axes.");
  };
  return {.id = "mount",
          .name = "mount",
          .doc =
              "What turns the camera, or a further mount inside this one, against its carrier. "
              "At rest its axes are the carrier's after three right-handed turns about its own "
              "axes: Rz(yaw) Rx(pitch) Ry(roll). It stays so, or scans or stares.",
          .attributes = {offset("x_m"), offset("y_m"), offset("z_m"),
                         defaulted("yaw_deg", full_turn(), "deg", "0",
                                   "First, about z: the image turns clockwise."),
                         defaulted("pitch_deg", full_turn(), "deg", "0",
                                   "Then, about x: the line of sight turns to the image's top."),
                         defaulted("roll_deg", full_turn(), "deg", "0",
                                   "Then, about y: the line of sight turns to the image's right.")},
          .content = Content::record,
          .children = {{"mount_scan"}, {"mount_stare"}, {"mount"}}};
}

ElementType scan_type() {
  return {
      .id = "mount_scan",
      .name = "scan",
      .doc = "Swings the mount about an axis of its own at a constant rate.",
      .attributes = {
          required("axis", EnumerationType{{"x", "y"}}, "",
                   "Right-handed: about y, growing angles look towards the image's right; about x, "
                   "towards its top."),
          required("first_deg", full_turn(), "deg", "Where a sweep begins."),
          required("last_deg", full_turn(), "deg", "Where it ends."),
          defaulted("start_s", from_to(-1e9, 1e9), "s", "0",
                    "When a sweep begins, after the scenario's time."),
          required("sweep_s", above_to(0.0, 1e9), "s", "From the first angle to the last."),
          optional("period_s", above_to(0.0, 1e9), "s", "sweep_s",
                   "From the beginning of one sweep to that of the next; the rest is dead time."),
          defaulted("motion", EnumerationType{{"sweep", "swing"}}, "", "sweep",
                    "Sweep: then at once back to the first angle. Swing: to and fro, one way in "
                    "each period.")}};
}

}  // namespace

std::vector<ElementType> schema_of_mounts() {
  return {jitter_type(),
          {.id = "mounts",
           .name = "mounts",
           .doc = "What stands between platform and camera.",
           .content = Content::record,
           .children = {{"mount", true}}},
          mount_type(),
          scan_type(),
          {.id = "mount_stare",
           .name = "stare",
           .doc = "Turns the mount so that its z axis keeps looking at a place.",
           .content = Content::one_of,
           .children = {{"geodetic"}, {"local"}}}};
}

}  // namespace nadir::sim
