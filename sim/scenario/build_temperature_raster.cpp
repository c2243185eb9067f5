#include <fmt/format.h>

#include <algorithm>

#include "core/constants.hpp"
#include "sim/scenario/build_material.hpp"
#include "sim/scenario/build_temperature.hpp"

namespace nadir::sim {
namespace {

void check_slice_times(const BuildContext& context, const CheckedElement& element) {
  std::map<std::string, int> first_line;
  for (const CheckedElement& slice : element.children) {
    const auto time = slice.find<ephemeris::Instant>("utc");
    if (!time) continue;
    const int line = context.source.locate(slice.offset).line;
    const auto [first, is_new] = first_line.emplace(time->to_string(), line);
    if (is_new) continue;
    context.mistake(slice.where("utc"), fmt::format("a slice of {} is there already, in line {}",
                                                    first->first, first->second));
  }
}

/// By time, whatever their order in the file.
std::vector<TemperatureRasterInput::Slice> slices_of(const CheckedElement& element) {
  std::vector<TemperatureRasterInput::Slice> slices;
  for (const CheckedElement& child : element.children) {
    const auto time = child.find<ephemeris::Instant>("utc");
    if (!time) continue;
    slices.push_back({child.value<std::filesystem::path>("file"), child.value<int>("band"), time});
  }
  std::stable_sort(slices.begin(), slices.end(),
                   [](const auto& a, const auto& b) { return (*a.time - *b.time).value < 0.0; });
  return slices;
}

}  // namespace

TemperatureRasterInput build_temperature_raster(const BuildContext& context,
                                                const CheckedElement& element) {
  TemperatureRasterInput raster;
  raster.gain = element.number("gain");
  raster.offset_k = element.number("offset_k");
  if (element.value<std::string>("unit") == "C") raster.offset_k += si::zero_celsius;
  raster.place = build_map_place(context, element);
  raster.where = context.source.locate(element.offset);
  if (!element.children.empty()) {
    keep_for(context, element, {"file", "band"}, "a raster without slices, which name their own");
    check_slice_times(context, element);
    raster.slices = slices_of(element);
  } else if (element.gives("file")) {
    raster.slices = {{element.value<std::filesystem::path>("file"),
                      element.find<int>("band").value_or(1), std::nullopt}};
  } else {
    context.mistake(element.offset, "<temperature_raster> has neither a file nor a <slice>",
                    "write file=\"...\", or a <slice utc=\"...\" file=\"...\"/> for each time");
  }
  return raster;
}

}  // namespace nadir::sim
