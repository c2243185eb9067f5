#include "sim/scenario/build_camera.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/scenario/sensor_file.hpp"

namespace nadir::sim {
namespace {

LensInput build_lens(const CheckedElement& element) {
  return {element.number("focal_length_mm"),
          element.number("k1"),
          element.number("k2"),
          element.number("p1"),
          element.number("p2"),
          element.number("k3"),
          element.number("principal_x_um"),
          element.number("principal_y_um")};
}

/// The lens of an array that has one of its own.
void build_own_lens(const BuildContext& context, const CheckedElement& element, ArrayInput& array) {
  array.own_lens = element.flag("own_lens");
  const CheckedElement* lens = single_child(context, element, {"lens"}, "<lens>");
  if (lens == nullptr) return;
  array.lens = build_lens(*lens);
  if (!array.own_lens) {
    context.mistake(lens->offset,
                    fmt::format("<lens> of array \"{}\" needs own_lens=\"true\"", array.name));
  }
}

ArrayInput build_array(const BuildContext& context, const CheckedElement& element) {
  ArrayInput array{element.value<std::string>("name"), element.value<int>("samples"),
                   element.value<int>("lines"),        element.number("pitch_um"),
                   element.number("pitch_y_um"),       element.number("offset_x_um"),
                   element.number("offset_y_um"),      element.number("ground_pitch_m"),
                   element.number("ground_pitch_y_m"), element.number("offset_x_m"),
                   element.number("offset_y_m"),       {},
                   element.number("fill_x"),           element.number("fill_y")};
  array.where = context.source.locate(element.offset);
  std::vector<const CheckedElement*> bands;
  for (const CheckedElement& child : element.children) {
    if (!child.type->name.starts_with("band")) continue;
    bands.push_back(&child);
    array.bands.push_back(build_band(context, child));
  }
  context.check_unique(bands, "band");
  build_own_lens(context, element, array);
  array.view_table = element.find<std::filesystem::path>("file");
  array.timing = build_timing(context, element);
  array.modules = build_modules(context, element);
  build_detection(context, element, array);
  return array;
}

/// The camera of a sensor file, as far as <sensor> wants it.
CameraInput build_preset(const BuildContext& context, const CheckedElement& element) {
  const auto file = element.find<std::filesystem::path>("file");
  std::error_code error;
  // A file that does not exist has been told of.
  if (!file || !std::filesystem::is_regular_file(*file, error)) return {};
  const std::size_t before = context.issues.count();
  const auto sensor = read_sensor(*file, context.issues);
  if (!sensor || context.issues.count() > before) return {};
  CameraInput camera = sensor->camera;
  camera.name = sensor->name;
  camera.sensor_file = *file;
  cut_preset(context, element, camera);
  return camera;
}

}  // namespace

const CheckedElement* single_child(const BuildContext& context, const CheckedElement& element,
                                   const std::vector<std::string>& names, const std::string& what) {
  const CheckedElement* first = nullptr;
  for (const CheckedElement& child : element.children) {
    if (std::find(names.begin(), names.end(), child.type->name) == names.end()) continue;
    if (first == nullptr) {
      first = &child;
      continue;
    }
    context.mistake(
        child.offset,
        fmt::format("<{}> holds only one {}; <{}> stands in line {} already", element.type->name,
                    what, first->type->name, context.source.locate(first->offset).line));
  }
  return first;
}

CameraInput build_projection(const BuildContext& context, const CheckedElement& projection) {
  CameraInput camera;
  camera.orthographic = projection.type->name == "orthographic";
  camera.lens = build_lens(projection);
  camera.where = context.source.locate(projection.offset);
  const std::size_t before = context.issues.count();
  std::vector<const CheckedElement*> arrays;
  for (const CheckedElement& array : projection.children) {
    arrays.push_back(&array);
    camera.arrays.push_back(build_array(context, array));
  }
  context.check_unique(arrays, "array");
  // After other mistakes the numbers may be placeholders that mean nothing.
  if (before == 0 && context.issues.count() == 0) check_focal_plane(context, arrays, camera);
  return camera;
}

void build_camera(const BuildContext& context, const CheckedElement& element, Scenario& scenario) {
  if (element.children.empty()) return;
  const CheckedElement& projection = element.children.front();
  const bool preset = projection.type->name == "sensor";
  scenario.camera =
      preset ? build_preset(context, projection) : build_projection(context, projection);
  scenario.camera.where = context.source.locate(element.offset);
  if (const auto name = element.find<std::string>("name")) scenario.camera.name = *name;
}

}  // namespace nadir::sim
