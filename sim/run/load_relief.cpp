#include "sim/run/load_relief.hpp"

#include <fmt/format.h>

#include <cmath>

namespace nadir::sim {
namespace {

using materials::MapFrame;
using materials::ReliefMap;

/// Steeper than this a normal map says nothing of a surface that is seen from above.
constexpr double least_normal_z = 0.01;

void check_holes(const std::filesystem::path& file, const Raster& raster) {
  for (std::size_t i = 0; i < raster.values.size(); ++i) {
    if (!std::isfinite(raster.values[i])) throw pixel_error(file, raster, i, "has no value");
  }
}

ReliefMap from_heights(const ReliefInput& input, const MapContext& context) {
  const Raster raster = read_raster(input.file);
  check_holes(input.file, raster);
  const MapFrame frame = map_frame(input.place, input.file, raster, context);
  return {frame, materials::slopes_of_heights(frame, raster.values, input.strength)};
}

/// Component of a normal: whole numbers from 0 to the type's largest stand for -1 to 1.
double component(const Raster& raster, std::size_t pixel) {
  const double value = raster.values[pixel];
  return raster.full_scale > 0.0 ? 2.0 * value / raster.full_scale - 1.0 : value;
}

ReliefMap from_normals(const ReliefInput& input, const MapContext& context) {
  const Raster x = read_raster(input.file, 1);
  if (x.bands < 3) {
    throw InputError{
        InputIssue{{input.file.string(), 0, 0},
                   fmt::format("a normal map has three bands; this raster has {}", x.bands),
                   {},
                   {}}};
  }
  const Raster y = read_raster(input.file, 2), z = read_raster(input.file, 3);
  ReliefMap map{map_frame(input.place, input.file, x, context), {}};
  const MapFrame& frame = map.frame;
  const double column_step = std::hypot(frame.step.x, frame.lean.y);
  const double row_step = std::hypot(frame.lean.x, frame.step.y);
  map.slope.reserve(x.values.size());
  for (std::size_t i = 0; i < x.values.size(); ++i) {
    const Vec3 normal{component(x, i), component(y, i), component(z, i)};
    if (!is_finite(normal)) throw pixel_error(input.file, x, i, "has no value");
    if (normal.z < least_normal_z) {
      throw pixel_error(input.file, x, i,
                        fmt::format("holds the normal ({:.3g}, {:.3g}, {:.3g}), which does not "
                                    "point out of the surface",
                                    normal.x, normal.y, normal.z),
                        "the third band must be above 0.01");
    }
    // The map's own axes are its columns and, upwards, its rows.
    const Vec2 slope = materials::slope_of_normal(normal, input.strength);
    map.slope.push_back(frame.gradient({slope.x * column_step, -slope.y * row_step}));
  }
  return map;
}

}  // namespace

std::shared_ptr<const ReliefMap> ReliefReader::read(const ReliefInput& input) {
  auto& known = known_[{input.where.file, input.where.line, input.where.column}];
  if (!known) {
    files_->note(input.file);
    known = std::make_shared<const ReliefMap>(input.normals ? from_normals(input, context_)
                                                            : from_heights(input, context_));
  }
  return known;
}

}  // namespace nadir::sim
