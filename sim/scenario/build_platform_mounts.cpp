#include <fmt/format.h>

#include "sim/scenario/build_platform.hpp"

namespace nadir::sim {
namespace {

sensor::ScanMount scan_of(const BuildContext& context, const CheckedElement& element) {
  sensor::ScanMount scan;
  const bool swing = element.value<std::string>("motion") == "swing";
  scan.motion = swing ? sensor::ScanMount::Motion::swing : sensor::ScanMount::Motion::sweep;
  scan.axis = element.value<std::string>("axis") == "x" ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
  const auto first = element.find<double>("first_deg"), last = element.find<double>("last_deg");
  if (first && last && *first == *last) {
    context.mistake(element.where("last_deg"), "<scan> begins and ends at the same angle");
  }
  scan.first_rad = degrees(first.value_or(0.0)).value;
  scan.last_rad = degrees(last.value_or(0.0)).value;
  scan.start_s = element.number("start_s");
  const auto sweep = element.find<double>("sweep_s");
  scan.sweep_s = sweep.value_or(1.0);
  scan.period_s = element.find<double>("period_s").value_or(scan.sweep_s);
  if (sweep && scan.period_s < scan.sweep_s) {
    context.mistake(
        element.where("period_s"),
        fmt::format("period_s is {}, shorter than sweep_s, {}", scan.period_s, scan.sweep_s));
  }
  return scan;
}

MountInput mount_of(const PlatformBuilder& builder, const CheckedElement& element) {
  MountInput mount;
  mount.offset_m = {element.number("x_m"), element.number("y_m"), element.number("z_m")};
  mount.yaw_deg = element.number("yaw_deg");
  mount.pitch_deg = element.number("pitch_deg");
  mount.roll_deg = element.number("roll_deg");
  const CheckedElement *scan = element.child("scan"), *stare = element.child("stare");
  if (scan != nullptr && stare != nullptr) {
    builder.context.mistake(stare->offset, "a <mount> holds <scan> or <stare>, not both",
                            "put one mount inside the other");
  }
  if (scan != nullptr) mount.law = scan_of(builder.context, *scan);
  if (stare != nullptr) {
    if (auto place = builder.build_place(*stare)) mount.law = *place;
  }
  return mount;
}

}  // namespace

JitterInput PlatformBuilder::build_jitter(const CheckedElement& element) const {
  JitterInput jitter;
  jitter.where = context.source.locate(element.offset);
  jitter.white_urad = {element.number("white_x_urad"), element.number("white_y_urad"),
                       element.number("white_z_urad")};
  jitter.spectrum = element.find<std::filesystem::path>("spectrum");
  jitter.seed = static_cast<std::uint64_t>(element.value<int>("seed"));
  const bool refused = context.issues.count() > 0;  // then a number may be missing
  if (!refused && !jitter.spectrum && jitter.white_urad == Vec3{}) {
    context.mistake(element.offset, "<jitter> shakes nothing",
                    "give white_x_urad, white_y_urad, white_z_urad or spectrum");
  }
  return jitter;
}

std::vector<MountInput> PlatformBuilder::build_mounts(const CheckedElement& element) const {
  std::vector<MountInput> mounts;
  for (const CheckedElement* mount = element.child("mount"); mount != nullptr;
       mount = mount->child("mount")) {
    mounts.push_back(mount_of(*this, *mount));
  }
  return mounts;
}

}  // namespace nadir::sim
