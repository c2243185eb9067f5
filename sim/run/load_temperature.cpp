#include "sim/run/load_temperature.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "sim/files/temperature_table.hpp"

namespace nadir::sim {
namespace {

using ephemeris::Instant;
using Slice = TemperatureRasterInput::Slice;

constexpr double hottest_map_k = 6000.0;  // as for temperatures in scenario files

/// A lone slice stands for the moment; that it was taken so long before or after is worth a word.
constexpr double other_time_s = 3600.0;

bool is_temperature(double kelvin) {
  return kelvin >= 0.0 && kelvin <= hottest_map_k;  // false for NaN
}

InputError at_file(const Slice& slice, std::string message) {
  return InputError{InputIssue{{slice.file.string(), 0, 0}, std::move(message), {}, {}}};
}

/// The slices to mix, and the second one's share; both the same where one is enough.
struct Mix {
  const Slice *first = nullptr, *second = nullptr;
  double share = 0.0;
};

std::vector<const Slice*> by_time(const TemperatureRasterInput& input) {
  std::vector<const Slice*> slices;
  for (const Slice& slice : input.slices) {
    if (!slice.time) throw at_file(slice, "a raster that is one of several needs its time");
    slices.push_back(&slice);
  }
  std::sort(slices.begin(), slices.end(),
            [](const Slice* a, const Slice* b) { return (*b->time - *a->time).value > 0.0; });
  for (std::size_t i = 1; i < slices.size(); ++i) {
    if (!((*slices[i]->time - *slices[i - 1]->time).value > 0.0)) {
      throw at_file(*slices[i], "two rasters have the time " + slices[i]->time->to_string());
    }
  }
  return slices;
}

Mix mix_of(const TemperatureRasterInput& input, const Instant& moment) {
  const std::vector<const Slice*> slices = by_time(input);
  const auto after = std::find_if(slices.begin(), slices.end(), [&](const Slice* slice) {
    return (*slice->time - moment).value >= 0.0;
  });
  const bool early = after == slices.begin() && (*slices.front()->time - moment).value > 0.0;
  if (after == slices.end() || early) {
    throw InputError{InputIssue{input.where,
                                "the rasters run from " + slices.front()->time->to_string() +
                                    " to " + slices.back()->time->to_string() +
                                    ", which does not cover " + moment.to_string(),
                                {},
                                {}}};
  }
  if (after == slices.begin()) return {*after, *after, 0.0};
  const Slice *before = *(after - 1), *next = *after;
  return {before, next, (moment - *before->time).value / (*next->time - *before->time).value};
}

Mix lone(const Slice& slice, const Instant& moment, Diagnostics& diagnostics) {
  if (slice.time && std::abs((*slice.time - moment).value) > other_time_s) {
    diagnostics.warn(
        fmt::format("{}: temperatures of {} stand for {}: give a second raster to "
                    "let them change",
                    slice.file.string(), slice.time->to_string(), moment.to_string()));
  }
  return {&slice, &slice, 0.0};
}

struct LoadedSlice {
  const Slice* slice = nullptr;
  materials::MapFrame frame;
  std::vector<double> kelvin;
};

InputError bad_pixel(const TemperatureRasterInput& input, const Slice& slice, const Raster& raster,
                     std::size_t pixel) {
  if (std::isnan(raster.values[pixel])) {
    return pixel_error(slice.file, raster, pixel, "has no value, and so no temperature");
  }
  const double kelvin = input.gain * raster.values[pixel] + input.offset_k;
  const bool celsius = input.gain == 1.0 && input.offset_k == 0.0 && kelvin < 0.0;
  return pixel_error(
      slice.file, raster, pixel,
      fmt::format("gives {:.6g} K; temperatures are from 0 to {:.0f} K", kelvin, hottest_map_k),
      celsius ? "values in degrees Celsius need an offset of 273.15 K" : "");
}

LoadedSlice load_slice(const TemperatureRasterInput& input, const Slice& slice,
                       const MapContext& context, InputFiles& files) {
  const Raster raster = read_raster(files.note(slice.file), slice.band);
  LoadedSlice loaded{&slice, map_frame(input.place, slice.file, raster, context), {}};
  loaded.kelvin.reserve(raster.values.size());
  for (std::size_t i = 0; i < raster.values.size(); ++i) {
    const double kelvin = input.gain * raster.values[i] + input.offset_k;
    if (!is_temperature(kelvin)) throw bad_pixel(input, slice, raster, i);
    loaded.kelvin.push_back(kelvin);
  }
  return loaded;
}

/// How far the corners of one map lie from those of another, in its pixels.
double apart(const materials::MapFrame& a, const materials::MapFrame& b) {
  double worst = 0.0;
  for (const Vec2 corner : {Vec2{0.0, 0.0}, Vec2{1.0, 0.0}, Vec2{0.0, 1.0}, Vec2{1.0, 1.0}}) {
    const double column = corner.x * b.columns, row = corner.y * b.rows;
    const Vec2 there = a.pixels({b.origin.x + column * b.step.x + row * b.lean.x,
                                 b.origin.y + column * b.lean.y + row * b.step.y});
    worst = std::max({worst, std::abs(there.x - column), std::abs(there.y - row)});
  }
  return worst;
}

void check_alike(const LoadedSlice& first, const LoadedSlice& second) {
  const auto &a = first.frame, &b = second.frame;
  if (a.columns != b.columns || a.rows != b.rows) {
    throw at_file(*second.slice,
                  fmt::format("the raster has {} x {} pixels, that of the time before ({}) has "
                              "{} x {}",
                              b.columns, b.rows, first.slice->file.string(), a.columns, a.rows));
  }
  // A tenth of a pixel: more than rounding in coordinate systems, less than anyone sees.
  if (!(apart(a, b) < 0.1)) {
    throw at_file(*second.slice, "the raster does not lie where that of the time before (" +
                                     first.slice->file.string() + ") lies");
  }
}

}  // namespace

thermal::MappedTemperature load_temperature_raster(const TemperatureRasterInput& input,
                                                   const Instant& moment, const MapContext& context,
                                                   InputFiles& files) {
  if (input.slices.empty()) {
    throw InputError{InputIssue{input.where, "temperatures from no raster at all", {}, {}}};
  }
  const Mix mix = input.slices.size() == 1
                      ? lone(input.slices.front(), moment, *context.diagnostics)
                      : mix_of(input, moment);
  const LoadedSlice first = load_slice(input, *mix.first, context, files);
  thermal::MappedTemperature map;
  map.frame = first.frame;
  map.kelvin.assign(first.kelvin.begin(), first.kelvin.end());
  if (mix.second == mix.first) return map;
  const LoadedSlice second = load_slice(input, *mix.second, context, files);
  check_alike(first, second);
  for (std::size_t i = 0; i < map.kelvin.size(); ++i) {
    map.kelvin[i] =
        static_cast<float>(first.kelvin[i] + mix.share * (second.kelvin[i] - first.kelvin[i]));
  }
  return map;
}

Kelvin load_temperature_table(const TemperatureTableInput& input, const Instant& moment,
                              InputFiles& files) {
  return read_temperature_table(files.note(input.file), input.column).at(moment);
}

thermal::VertexTemperature vertex_temperature(const VertexTemperatureInput& input,
                                              std::shared_ptr<const geometry::Scene> scene) {
  return {std::move(scene), input.gain, input.offset_k};
}

bool has_vertex_values(const geometry::TriangleMesh& mesh) noexcept {
  return !mesh.positions.empty() && mesh.vertex_values.size() == mesh.positions.size();
}

void check_vertex_temperature(const geometry::TriangleMesh& mesh,
                              const VertexTemperatureInput& input, const std::string& name) {
  const auto mistake = [&](std::string message, std::string hint) {
    return InputError{InputIssue{{name, 0, 0}, std::move(message), std::move(hint), {}}};
  };
  if (!has_vertex_values(mesh)) {
    throw mistake("the mesh gives its vertices no temperatures, which its material asks for",
                  "a PLY file has them as the property temperature_k, temperature_c or "
                  "temperature of its vertices");
  }
  for (std::size_t i = 0; i < mesh.vertex_values.size(); ++i) {
    const double kelvin = input.gain * static_cast<double>(mesh.vertex_values[i]) + input.offset_k;
    if (is_temperature(kelvin)) continue;
    throw mistake(fmt::format("vertex {} (the first is 0) has {:.6g} K; temperatures are from 0 "
                              "to {:.0f} K",
                              i, kelvin, hottest_map_k),
                  kelvin < 0.0 ? "degrees Celsius have the property temperature_c" : "");
  }
}

}  // namespace nadir::sim
