#include <fmt/format.h>

#include <algorithm>

#include "sim/scenario/build_camera.hpp"

namespace nadir::sim {
namespace {

constexpr double timing_s_per_ms = 1e-3;
constexpr double timing_s_per_us = 1e-6;

/// One detector cannot expose two lines at once.
void check_exposure(const BuildContext& context, const CheckedElement& element,
                    const std::string& exposure, const std::string& period) {
  const auto longest = element.find<double>(period);
  const double given = element.number(exposure);
  if (!longest || given <= *longest) return;
  context.mistake(element.where(exposure), fmt::format("{} is {}, longer than {}, which is {}",
                                                       exposure, given, period, *longest));
}

PushbroomInput build_pushbroom(const BuildContext& context, const CheckedElement& element) {
  check_exposure(context, element, "exposure_ms", "line_period_ms");
  return {element.number("line_period_ms"), element.number("exposure_ms"),
          element.find<double>("start_s"), element.value<int>("tdi_stages"),
          element.value<std::string>("tdi_direction") == "behind"};
}

WhiskbroomInput build_whiskbroom(const BuildContext& context, const CheckedElement& element,
                                 const CheckedElement& array) {
  check_exposure(context, element, "exposure_us", "sample_period_us");
  const WhiskbroomInput scan{element.number("sample_period_us"), element.number("scan_period_ms"),
                             element.value<int>("lines_per_scan"), element.number("exposure_us"),
                             element.find<double>("start_s")};
  const int samples = array.value<int>("samples"), lines = array.value<int>("lines");
  const double sweep_ms = samples * scan.sample_period_us * 1e-3;
  if (scan.scan_period_ms > 0.0 && sweep_ms > scan.scan_period_ms) {
    context.mistake(element.where("scan_period_ms"),
                    fmt::format("a sweep of {} samples takes {:.6g} ms, longer than "
                                "scan_period_ms, which is {}",
                                samples, sweep_ms, scan.scan_period_ms));
  }
  if (scan.lines_per_scan > 0 && lines % scan.lines_per_scan != 0) {
    context.mistake(
        array.where("lines"),
        fmt::format("{} lines are not a whole number of sweeps of {}", lines, scan.lines_per_scan));
  }
  if (array.gives("file")) {
    context.mistake(element.offset,
                    "a <whiskbroom> has no table of lines of sight: its column of "
                    "detectors has one sample");
  }
  if (const CheckedElement* module = array.child("module")) {
    context.mistake(module->offset, "the column of a <whiskbroom> has no modules");
  }
  return scan;
}

/// Tells of samples that no module or more than one has.
void check_modules(const BuildContext& context, const CheckedElement& array,
                   const std::vector<const CheckedElement*>& modules) {
  int next = 0;
  for (const CheckedElement* module : modules) {
    const auto first = module->find<int>("first_sample"), samples = module->find<int>("samples");
    if (!first || !samples) return;  // told already: what follows would be wrong because of it
    if (*first != next) {
      context.mistake(
          module->where("first_sample"),
          fmt::format("this module begins at sample {}, but {} {}", *first,
                      next == 0 ? "the array begins at" : "those before it end before", next),
          *first > next ? "samples between would belong to no module"
                        : "samples would belong to two modules");
    }
    next = *first + *samples;
  }
  const auto all = array.find<int>("samples");
  if (all && next != *all) {
    context.mistake(modules.back()->where("samples"),
                    fmt::format("the modules have {} samples, array \"{}\" has {}", next,
                                array.value<std::string>("name"), *all));
  }
}

/// Period from line to line on average, s; 0: all at once.
struct LinePeriod {
  double operator()(const GlobalShutterInput& /*t*/) const { return 0.0; }
  double operator()(const RollingShutterInput& t) const {
    return t.line_period_ms * timing_s_per_ms;
  }
  double operator()(const PushbroomInput& t) const { return t.line_period_ms * timing_s_per_ms; }
  double operator()(const WhiskbroomInput& t) const {
    return t.scan_period_ms * timing_s_per_ms / t.lines_per_scan;
  }
  double operator()(const BolometerInput& t) const { return t.line_period_us * timing_s_per_us; }
};

}  // namespace

double line_period_s(const TimingInput& timing) { return std::visit(LinePeriod{}, timing); }

double first_exposure_s(const TimingInput& timing, int samples, int lines) {
  if (const auto* shutter = std::get_if<GlobalShutterInput>(&timing)) {
    return shutter->delay_ms * timing_s_per_ms;
  }
  TimingInput copy = timing;
  const std::optional<double>* start = start_of(copy);
  if (start != nullptr && *start) return **start;
  if (const auto* scan = std::get_if<WhiskbroomInput>(&timing)) {
    const int sweeps = (lines + scan->lines_per_scan - 1) / scan->lines_per_scan;
    return -0.5 * ((sweeps - 1) * scan->scan_period_ms * timing_s_per_ms +
                   (samples - 1) * scan->sample_period_us * timing_s_per_us);
  }
  return -0.5 * (lines - 1) * line_period_s(timing);
}

std::optional<double>* start_of(TimingInput& timing) {
  if (auto* rolling = std::get_if<RollingShutterInput>(&timing)) return &rolling->start_s;
  if (auto* pushbroom = std::get_if<PushbroomInput>(&timing)) return &pushbroom->start_s;
  if (auto* whiskbroom = std::get_if<WhiskbroomInput>(&timing)) return &whiskbroom->start_s;
  auto* bolometer = std::get_if<BolometerInput>(&timing);
  return bolometer != nullptr ? &bolometer->start_s : nullptr;
}

bool is_scanned(const TimingInput& timing) {
  return std::holds_alternative<PushbroomInput>(timing) ||
         std::holds_alternative<WhiskbroomInput>(timing);
}

TimingInput build_timing(const BuildContext& context, const CheckedElement& array) {
  const CheckedElement* element = single_child(
      context, array, {"global_shutter", "rolling_shutter", "pushbroom", "whiskbroom", "bolometer"},
      "timing");
  if (element == nullptr) return GlobalShutterInput{};
  const std::string& name = element->type->name;
  if (name == "global_shutter") {
    return GlobalShutterInput{element->number("exposure_ms"), element->number("delay_ms")};
  }
  if (name == "rolling_shutter") {
    return RollingShutterInput{element->number("line_period_ms"), element->number("exposure_ms"),
                               element->find<double>("start_s")};
  }
  if (name == "pushbroom") return build_pushbroom(context, *element);
  if (name == "whiskbroom") return build_whiskbroom(context, *element, array);
  return BolometerInput{element->number("time_constant_ms"), element->number("line_period_us"),
                        element->find<double>("start_s")};
}

std::vector<ModuleInput> build_modules(const BuildContext& context, const CheckedElement& array) {
  std::vector<const CheckedElement*> elements;
  for (const CheckedElement& child : array.children) {
    if (child.type->name == "module") elements.push_back(&child);
  }
  if (elements.empty()) return {};
  std::stable_sort(elements.begin(), elements.end(),
                   [](const CheckedElement* a, const CheckedElement* b) {
                     return a->value<int>("first_sample") < b->value<int>("first_sample");
                   });
  check_modules(context, array, elements);
  std::vector<ModuleInput> modules;
  for (const CheckedElement* module : elements) {
    modules.push_back({module->value<int>("first_sample"), module->value<int>("samples"),
                       module->number("offset_x_um"), module->number("offset_y_um"),
                       module->number("rotation_deg")});
  }
  return modules;
}

}  // namespace nadir::sim
