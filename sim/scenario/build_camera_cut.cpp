#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/scenario/build_camera.hpp"

// <sensor>: which arrays of a preset a scenario takes, and which part of them.

namespace nadir::sim {
namespace {

/// A part of an axis of the image.
struct CutPart {
  int first = 0, count = 0;
};

/// The arrays by the names that <sensor> gives, in its order.
void choose_arrays(const BuildContext& context, const CheckedElement& element,
                   CameraInput& camera) {
  const auto wanted = element.find<std::vector<std::string>>("arrays");
  if (!wanted) return;
  std::vector<std::string> known;
  for (const ArrayInput& array : camera.arrays) known.push_back(array.name);
  std::vector<ArrayInput> chosen;
  for (auto name = wanted->begin(); name != wanted->end(); ++name) {
    const auto found = std::find(known.begin(), known.end(), *name);
    if (found == known.end()) {
      context.mistake(element.where("arrays"), fmt::format("the sensor has no array \"{}\"", *name),
                      suggestion(*name, known));
    } else if (std::find(wanted->begin(), name, *name) != name) {
      context.mistake(element.where("arrays"), fmt::format("array \"{}\" is named twice", *name));
    } else {
      chosen.push_back(camera.arrays[static_cast<std::size_t>(found - known.begin())]);
    }
  }
  camera.arrays = std::move(chosen);
}

/// What an attribute for the first pixel and one for their number ask for, of so many; nothing
/// where neither is given or after a mistake.
std::optional<CutPart> part_of(const BuildContext& context, const CheckedElement& element,
                               const std::string& axis, const ArrayInput& array) {
  const std::string first_name = axis == "samples" ? "first_sample" : "first_line";
  const int all = axis == "samples" ? array.samples : array.lines;
  const auto count = element.find<int>(axis), first = element.find<int>(first_name);
  if (!count) {
    if (first) {
      context.mistake(element.where(first_name), fmt::format("{} needs {}", first_name, axis));
    }
    return std::nullopt;
  }
  if (*count > all) {
    context.mistake(element.where(axis), fmt::format("{} is {}, but array \"{}\" has {}", axis,
                                                     *count, array.name, all));
    return std::nullopt;
  }
  const CutPart part{first.value_or((all - *count) / 2), *count};
  if (part.first > all - part.count) {
    context.mistake(element.where(first_name),
                    fmt::format("{} {} and {} {} reach beyond the {} of array \"{}\"", first_name,
                                part.first, axis, part.count, all, array.name));
    return std::nullopt;
  }
  return part;
}

/// The same part of an axis with another number of pixels.
CutPart scaled(const CutPart& part, int all, int base) {
  const double scale = static_cast<double>(all) / base;
  const int count = std::clamp(static_cast<int>(std::lround(part.count * scale)), 1, all);
  const int first = std::clamp(static_cast<int>(std::lround(part.first * scale)), 0, all - count);
  return {first, count};
}

/// Moves the array's place so that the pixels that are left stay where they were.
void shift(ArrayInput& array, double columns, double rows) {
  array.offset_x_um += columns * array.pitch_um;
  array.offset_x_m += columns * array.ground_pitch_m;
  array.offset_y_um += rows * (array.pitch_y_um > 0.0 ? array.pitch_y_um : array.pitch_um);
  array.offset_y_m +=
      rows * (array.ground_pitch_y_m > 0.0 ? array.ground_pitch_y_m : array.ground_pitch_m);
}

/// The modules' parts within the samples that are left. Modules turn about their middles: where
/// those move the offsets make up for it.
void cut_modules(ArrayInput& array, const CutPart& samples) {
  std::vector<ModuleInput> left;
  for (ModuleInput module : array.modules) {
    const int first = std::max(module.first_sample, samples.first);
    const int end = std::min(module.first_sample + module.samples, samples.first + samples.count);
    if (end <= first) continue;
    const double old_middle = module.first_sample + 0.5 * module.samples;
    const double d_um = (old_middle - 0.5 * (first + end)) * array.pitch_um;
    const double turn = module.rotation_deg * std::numbers::pi / 180.0;
    module.offset_x_um += d_um * (1.0 - std::cos(turn));
    module.offset_y_um -= d_um * std::sin(turn);
    module.first_sample = first - samples.first;
    module.samples = end - first;
    left.push_back(module);
  }
  array.modules = std::move(left);
}

void cut_samples(ArrayInput& array, const CutPart& samples) {
  constexpr double seconds_per_us = 1e-6;
  if (auto* scan = std::get_if<WhiskbroomInput>(&array.timing)) {
    // Samples come by the mirror's motion: later ones later.
    scan->start_s = first_exposure_s(array.timing, array.samples, array.lines) +
                    samples.first * scan->sample_period_us * seconds_per_us;
  } else {
    shift(array, samples.first + 0.5 * samples.count - 0.5 * array.samples, 0.0);
    cut_modules(array, samples);
  }
  array.is_cut = true;
  array.first_sample = samples.first;
  array.samples = samples.count;
}

void cut_frame(ArrayInput& array, const CutPart& lines) {
  if (std::optional<double>* start = start_of(array.timing)) {
    *start = first_exposure_s(array.timing, array.samples, array.lines) +
             lines.first * line_period_s(array.timing);
  }
  shift(array, 0.0, lines.first + 0.5 * lines.count - 0.5 * array.lines);
  array.is_cut = true;
  array.first_line = lines.first;
  array.lines = lines.count;
}

void cut_all_samples(const BuildContext& context, const CheckedElement& element,
                     CameraInput& camera) {
  const ArrayInput& first = camera.arrays.front();
  const auto part = part_of(context, element, "samples", first);
  if (!part) return;
  const int base = first.samples;
  for (ArrayInput& array : camera.arrays) cut_samples(array, scaled(*part, array.samples, base));
}

/// Lines of a pass; a whiskbroom's sweeps are taken whole.
int pass_lines(double lines, const TimingInput& timing) {
  const auto* scan = std::get_if<WhiskbroomInput>(&timing);
  const int together = scan != nullptr ? scan->lines_per_scan : 1;
  return together * std::max(1, static_cast<int>(std::lround(lines / together)));
}

/// Lines of passes: as many as are asked for, which may be more than the file says.
void set_lines(int lines, CameraInput& camera) {
  const double base_s = line_period_s(camera.arrays.front().timing);
  const double share = static_cast<double>(lines) / camera.arrays.front().lines;
  for (ArrayInput& array : camera.arrays) {
    if (is_scanned(array.timing)) {
      array.lines = pass_lines(lines * base_s / line_period_s(array.timing), array.timing);
    } else {
      const int count =
          std::clamp(static_cast<int>(std::lround(array.lines * share)), 1, array.lines);
      cut_frame(array, {(array.lines - count) / 2, count});
    }
  }
}

void cut_all_lines(const BuildContext& context, const CheckedElement& element,
                   CameraInput& camera) {
  const ArrayInput& first = camera.arrays.front();
  if (is_scanned(first.timing)) {
    if (element.gives("first_line")) {
      context.mistake(
          element.where("first_line"),
          fmt::format("first_line cuts frames, but array \"{}\" is scanned", first.name),
          "start_s says when its pass begins");
    }
    if (const auto lines = element.find<int>("lines")) set_lines(*lines, camera);
    return;
  }
  const auto part = part_of(context, element, "lines", first);
  if (!part) return;
  const int base = first.lines;
  for (ArrayInput& array : camera.arrays) {
    const CutPart own = scaled(*part, array.lines, base);
    if (is_scanned(array.timing)) {
      array.lines = pass_lines(own.count, array.timing);
    } else {
      cut_frame(array, own);
    }
  }
}

void set_start(const BuildContext& context, const CheckedElement& element, CameraInput& camera) {
  const auto start = element.find<double>("start_s");
  if (!start) return;
  bool any = false;
  for (ArrayInput& array : camera.arrays) {
    std::optional<double>* own = start_of(array.timing);
    if (own == nullptr) continue;
    *own = *start;
    any = true;
  }
  if (any) return;
  context.mistake(element.where("start_s"),
                  "start_s would do nothing: all lines of these arrays are taken at once");
}

}  // namespace

void cut_preset(const BuildContext& context, const CheckedElement& element, CameraInput& camera) {
  choose_arrays(context, element, camera);
  if (camera.arrays.empty()) return;
  set_start(context, element, camera);      // first: what is cut off then comes earlier or later
  cut_all_lines(context, element, camera);  // then passes are centred with the lines they have
  cut_all_samples(context, element, camera);
}

}  // namespace nadir::sim
